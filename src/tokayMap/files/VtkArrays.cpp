// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/files/VtkArrays.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace tokay::tool {

namespace {

std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw InputError(fmt::format("{}: the file cannot be opened", path));
    }
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

template <class Value>
std::vector<double> converted(const std::string& bytes) {
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!values.empty()) {
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
    }
    return {values.begin(), values.end()};
}

std::vector<double> converted(const std::string& type, const std::string& bytes) {
    static const std::map<std::string, std::vector<double> (*)(const std::string&)> byType = {
        {"Float32", converted<float>},      {"Float64", converted<double>},
        {"Int8", converted<std::int8_t>},   {"UInt8", converted<std::uint8_t>},
        {"Int16", converted<std::int16_t>}, {"UInt16", converted<std::uint16_t>},
        {"Int32", converted<std::int32_t>}, {"UInt32", converted<std::uint32_t>},
        {"Int64", converted<std::int64_t>}, {"UInt64", converted<std::uint64_t>}};
    const auto found = byType.find(type);
    if (found == byType.end()) {
        throw InputError(fmt::format("numbers of type '{}' are not supported", type));
    }
    return found->second(bytes);
}

std::vector<double> parsed(const char* text) {
    std::vector<double> values;
    for (;;) {
        char* end = nullptr;
        const double value = std::strtod(text, &end);
        if (end == text) {
            break;
        }
        values.push_back(value);
        text = end;
    }
    text += std::strspn(text, " \t\r\n");
    if (*text != '\0') {
        throw InputError(fmt::format("'{}' is not a number", std::string(text).substr(0, 20)));
    }
    return values;
}

constexpr std::size_t largestRatio = 1032; // of zlib

/// @param compressed  a block
std::string inflated(const std::string& compressed, std::size_t size) {
    if (size / largestRatio > compressed.size()) {
        throw InputError(
            fmt::format("a block of {} bytes cannot grow to {}", compressed.size(), size));
    }
    std::string bytes(size, '\0');
    uLongf n = size;
    const int status =
        uncompress(reinterpret_cast<Bytef*>(bytes.data()), &n,
                   reinterpret_cast<const Bytef*>(compressed.data()), compressed.size());
    if (status != Z_OK || n != size) {
        throw InputError("a block of compressed data is damaged");
    }
    return bytes;
}

} // namespace

VtkArrays::VtkArrays(const std::string& path) : path_(path) {
    const std::string content = contentOf(path);
    fileSize_ = content.size();
    splitOffAppended(content);
    readAttributes();
}

void VtkArrays::fail(const std::string& message) const {
    throw InputError(fmt::format("{}: {}", path_, message));
}

void VtkArrays::splitOffAppended(const std::string& content) {
    const std::size_t element = content.find("<AppendedData");
    const std::string head =
        element == std::string::npos ? content : content.substr(0, element) + "</VTKFile>";
    const pugi::xml_parse_result result = document_.load_buffer(head.data(), head.size());
    if (!result) {
        fail(fmt::format("not well-formed XML: {} (at byte {})", result.description(),
                         result.offset));
    }
    if (!root()) {
        fail("not a VTK file in XML (no element VTKFile); legacy .vtk "
             "files: save as .vtu or .vtp");
    }
    if (element == std::string::npos) {
        return;
    }
    const std::size_t end = content.find('>', element), mark = content.find('_', end);
    if (mark == std::string::npos) {
        fail("the appended data do not begin with an underscore");
    }
    const std::string tag = content.substr(element, end - element);
    if (tag.find("base64") != std::string::npos) {
        appendedEncoding_ = ByteEncoding::base64;
    }
    appended_ = content.substr(mark + 1);
}

void VtkArrays::readAttributes() {
    const std::string order = root().attribute("byte_order").as_string("LittleEndian");
    if (order != "LittleEndian") {
        fail(fmt::format("byte order '{}' is not supported: write little-endian", order));
    }
    const std::string header = root().attribute("header_type").as_string("UInt32");
    if (header != "UInt32" && header != "UInt64") {
        fail(fmt::format("header_type '{}' is neither UInt32 nor UInt64", header));
    }
    headerSize_ = header == "UInt64" ? 8 : 4;
    const std::string compressor = root().attribute("compressor").as_string();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
        fail(fmt::format("the compressor {} is not supported: write with zlib or "
                         "without",
                         compressor));
    }
    isCompressed_ = !compressor.empty();
}

std::vector<double> VtkArrays::numbers(pugi::xml_node array) const {
    try {
        if (std::strcmp(array.attribute("format").as_string("ascii"), "ascii") == 0) {
            return parsed(array.child_value());
        }
        return converted(array.attribute("type").as_string(), bytes(stream(array)));
    } catch (const InputError& error) {
        fail(fmt::format("array '{}': {}", array.attribute("Name").as_string(), error.what()));
    }
}

std::vector<double> VtkArrays::numbers(pugi::xml_node array, std::size_t n) const {
    std::vector<double> values = numbers(array);
    if (values.size() != n) {
        fail(fmt::format("array '{}' has {} numbers, but {} are announced",
                         array.attribute("Name").as_string(), values.size(), n));
    }
    return values;
}

std::size_t VtkArrays::count(pugi::xml_node node, const char* attribute,
                             std::size_t fallback) const {
    const std::size_t n = node.attribute(attribute).as_ullong(fallback);
    const std::size_t most =
        std::min<std::size_t>(fileSize_ * largestRatio, std::numeric_limits<int>::max());
    if (n > most) {
        fail(fmt::format("{}: {} is more than a file of {} bytes can hold", attribute,
                         node.attribute(attribute).value(), fileSize_));
    }
    return n;
}

pugi::xml_node VtkArrays::arrayIn(pugi::xml_node parent, const std::string& name) const {
    const pugi::xml_node array =
        name.empty() ? parent.child("DataArray")
                     : parent.find_child_by_attribute("DataArray", "Name", name.c_str());
    if (!array) {
        fail(fmt::format("the element '{}' has no array '{}'", parent.name(), name));
    }
    return array;
}

ByteStream VtkArrays::stream(pugi::xml_node array) const {
    const std::string format = array.attribute("format").as_string();
    if (format == "binary") {
        return {array.child_value(), ByteEncoding::base64};
    }
    if (format != "appended") {
        throw InputError(fmt::format("the format '{}' is not ascii, binary or appended", format));
    }
    const std::size_t offset = array.attribute("offset").as_ullong();
    if (offset >= appended_.size()) {
        throw InputError(
            fmt::format("its offset {} is beyond the {} appended bytes", offset, appended_.size()));
    }
    return {std::string_view(appended_).substr(offset), appendedEncoding_};
}

std::size_t VtkArrays::takeHeader(ByteStream& stream) const {
    std::uint64_t value = 0;
    std::memcpy(&value, stream.take(headerSize_).data(), headerSize_); // little-endian
    return value;
}

std::string VtkArrays::bytes(ByteStream stream) const {
    return isCompressed_ ? uncompressed(stream) : stream.take(takeHeader(stream));
}

/// Number of blocks, size of each, size of the last if it is another (else 0),
/// compressed size of each, blocks.
std::string VtkArrays::uncompressed(ByteStream& stream) const {
    const std::size_t nBlocks = takeHeader(stream), size = takeHeader(stream),
                      lastSize = takeHeader(stream);
    std::vector<std::size_t> compressedSizes;
    for (std::size_t i = 0; i < nBlocks; ++i) {
        compressedSizes.push_back(takeHeader(stream));
    }
    std::string all;
    for (std::size_t i = 0; i < nBlocks; ++i) {
        const bool isPartial = i + 1 == nBlocks && lastSize > 0;
        all += inflated(stream.take(compressedSizes[i]), isPartial ? lastSize : size);
    }
    return all;
}

} // namespace tokay::tool
