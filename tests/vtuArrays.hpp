// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tokay {

namespace detail {

template <class Value>
std::vector<double> numbers(const char* bytes, std::uint64_t size) {
    std::vector<Value> values(size / sizeof(Value));
    std::memcpy(values.data(), bytes, size);
    return {values.begin(), values.end()};
}

inline std::vector<double> numbers(const std::string& type, const char* bytes) {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes, sizeof size);
    bytes += sizeof size;
    if (type == "Float64") {
        return numbers<double>(bytes, size);
    }
    if (type == "Int32") {
        return numbers<std::int32_t>(bytes, size);
    }
    if (type == "Int64") {
        return numbers<std::int64_t>(bytes, size);
    }
    if (type == "UInt8") {
        return numbers<std::uint8_t>(bytes, size);
    }
    throw std::runtime_error("no such type: " + type);
}

inline std::string attribute(const std::string& element, const std::string& name) {
    const std::size_t begin = element.find(name + "=\"") + name.size() + 2;
    return element.substr(begin, element.find('"', begin) - begin);
}

} // namespace detail

/// The appended arrays of a .vtu file as VtuFile writes them, by their names;
/// texts are left out.
inline std::map<std::string, std::vector<double>> vtuArrays(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    const std::string text = content.str();
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t data = text.find(mark) + mark.size();
    std::map<std::string, std::vector<double>> arrays;
    for (std::size_t at = text.find("<DataArray"); at < data;
         at = text.find("<DataArray", at + 1)) {
        const std::string element = text.substr(at, text.find('>', at) - at);
        if (element.find("format=\"appended\"") == std::string::npos) {
            continue;
        }
        arrays[detail::attribute(element, "Name")] =
            detail::numbers(detail::attribute(element, "type"),
                            text.data() + data + std::stoul(detail::attribute(element, "offset")));
    }
    return arrays;
}

} // namespace tokay
