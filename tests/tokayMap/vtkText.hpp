// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tokay::tool {

/// How a file has its arrays.
struct VtkStyle {
    enum class Format { ascii, inlineBase64, appendedRaw, appendedBase64 };
    Format format = Format::ascii;
    bool isCompressed = false;
    bool hasLongHeaders = false;
    /// Float32 and Int32, else Float64 and Int64.
    bool isSingle = false;
};

/// Text of a VTK file as its format describes it, array by array.
class VtkText {
  public:
    explicit VtkText(const VtkStyle& style) : style_(style) {}

    /// @return the element DataArray
    std::string reals(const std::string& name, int nComponents, const std::vector<double>& values);
    std::string integers(const std::string& name, const std::vector<int>& values);

    /// @param type     UnstructuredGrid or PolyData
    /// @param content  of that element
    std::string file(const std::string& type, const std::string& content) const;

  private:
    template <class Value>
    std::string array(const std::string& type, const std::string& name, int nComponents,
                      const std::vector<Value>& values);
    std::string encoded(const std::string& bytes) const;
    std::string header(const std::vector<std::size_t>& numbers) const;
    std::string compressed(const std::string& bytes, bool isBase64) const;

    VtkStyle style_;
    std::string appended_;
};

/// The unit square in two triangles and a line along its bottom; fields p at
/// vertices (x), U at vertices (three components), q on cells (10, 20, line 30).
std::string exampleGrid(const VtkStyle& style);

} // namespace tokay::tool
