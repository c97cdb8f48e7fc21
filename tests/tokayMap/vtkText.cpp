// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkText.hpp"

#include <zlib.h>

#include <cstdint>
#include <sstream>

namespace tokay::tool {

namespace {

using Format = VtkStyle::Format;

std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t j = i; j < i + 3; ++j) {
            group = group << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
        }
        for (int j = 0; j < 4; ++j) {
            text += i + j > bytes.size() ? '=' : digits[group >> (18 - 6 * j) & 63];
        }
    }
    return text;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    compress(reinterpret_cast<Bytef*>(result.data()), &size,
             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    return result.substr(0, size);
}

} // namespace

std::string VtkText::reals(const std::string& name, int nComponents,
                           const std::vector<double>& values) {
    if (!style_.isSingle) {
        return array("Float64", name, nComponents, values);
    }
    return array("Float32", name, nComponents, std::vector<float>(values.begin(), values.end()));
}

std::string VtkText::integers(const std::string& name, const std::vector<int>& values) {
    if (style_.isSingle) {
        return array("Int32", name, 1, std::vector<std::int32_t>(values.begin(), values.end()));
    }
    return array("Int64", name, 1, std::vector<std::int64_t>(values.begin(), values.end()));
}

template <class Value>
std::string VtkText::array(const std::string& type, const std::string& name, int nComponents,
                           const std::vector<Value>& values) {
    std::ostringstream text;
    text << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
         << nComponents << "\" format=\"";
    const std::string bytes(reinterpret_cast<const char*>(values.data()),
                            values.size() * sizeof(Value));
    if (style_.format == Format::ascii) {
        text.precision(17);
        text << "ascii\">\n";
        for (const Value value : values) {
            text << ' ' << value;
        }
        text << "\n</DataArray>\n";
    } else if (style_.format == Format::inlineBase64) {
        text << "binary\">\n  " << encoded(bytes) << "\n</DataArray>\n";
    } else {
        text << "appended\" offset=\"" << appended_.size() << "\"/>\n";
        appended_ += encoded(bytes);
    }
    return text.str();
}

std::string VtkText::header(const std::vector<std::size_t>& numbers) const {
    std::string bytes;
    for (const std::uint64_t number : numbers) {
        bytes.append(reinterpret_cast<const char*>(&number), style_.hasLongHeaders ? 8 : 4);
    }
    return bytes;
}

std::string VtkText::encoded(const std::string& bytes) const {
    const bool isBase64 = style_.format != Format::appendedRaw;
    if (style_.isCompressed) {
        return compressed(bytes, isBase64);
    }
    const std::string all = header({bytes.size()}) + bytes;
    return isBase64 ? base64(all) : all;
}

/// In blocks of 64 bytes; header and blocks are base64 each for itself.
std::string VtkText::compressed(const std::string& bytes, bool isBase64) const {
    constexpr std::size_t blockSize = 64;
    std::string blocks;
    std::vector<std::size_t> numbers = {(bytes.size() + blockSize - 1) / blockSize, blockSize,
                                        bytes.size() % blockSize};
    for (std::size_t at = 0; at < bytes.size(); at += blockSize) {
        const std::string block = deflated(bytes.substr(at, blockSize));
        numbers.push_back(block.size());
        blocks += block;
    }
    return isBase64 ? base64(header(numbers)) + base64(blocks) : header(numbers) + blocks;
}

std::string VtkText::file(const std::string& type, const std::string& content) const {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
                       "\" version=\"0.1\" byte_order=\"LittleEndian\"";
    if (style_.hasLongHeaders) {
        text += " header_type=\"UInt64\"";
    }
    if (style_.isCompressed) {
        text += " compressor=\"vtkZLibDataCompressor\"";
    }
    text += ">\n<" + type + ">\n" + content + "</" + type + ">\n";
    if (!appended_.empty()) {
        text += std::string("<AppendedData encoding=\"") +
                (style_.format == Format::appendedRaw ? "raw" : "base64") + "\">\n _" + appended_ +
                "\n</AppendedData>\n";
    }
    return text + "</VTKFile>\n";
}

std::string exampleGrid(const VtkStyle& style) {
    VtkText text(style);
    std::string piece = "<Piece NumberOfPoints=\"4\" NumberOfCells=\"3\">\n<PointData>\n";
    piece += text.reals("p", 1, {0, 1, 1, 0}); // one by one: appended in this order
    piece += text.reals("U", 3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.25});
    piece += "</PointData>\n<CellData>\n";
    piece += text.reals("q", 1, {10, 30, 20});
    piece += "</CellData>\n<Points>\n";
    piece += text.reals("Points", 3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    piece += "</Points>\n<Cells>\n";
    piece += text.integers("connectivity", {0, 1, 2, 0, 1, 0, 2, 3});
    piece += text.integers("offsets", {3, 5, 8});
    piece += text.integers("types", {5, 3, 5});
    return text.file("UnstructuredGrid", piece + "</Cells>\n</Piece>\n");
}

} // namespace tokay::tool
