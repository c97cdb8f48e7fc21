// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tokay {

/// VTK's cell types.
/// Source: vtkCellType.h
enum class VtkCell : std::uint8_t {
    vertex = 1,
    line = 3,
    polyLine = 4,
    triangle = 5,
    polygon = 7,
    quad = 9,
    hexahedron = 12,
    bezierCurve = 75,
    bezierQuadrilateral = 77,
    bezierHexahedron = 79
};

/// An unstructured grid and its fields as ParaView reads them (.vtu): the
/// description as XML, the numbers appended in binary.
class VtuFile {
  public:
    enum class On { points, cells };

    /// Begins a piece of the file; fields that follow belong to it.
    /// @param coordinates   x, y, z of each point [m]
    /// @param connectivity  points of each cell, cell after cell
    /// @param ends          where in the connectivity each cell ends
    void beginPiece(const std::vector<double>& coordinates,
                    const std::vector<std::int64_t>& connectivity,
                    const std::vector<std::int64_t>& ends, const std::vector<VtkCell>& types);

    /// A field of the piece; all pieces must have the same ones.
    /// @param values     nComponents for each point or cell; six are a symmetric
    ///                   tensor in the order xx yy zz xy yz xz
    /// @param attribute  what the field is to VTK, such as "RationalWeights"
    void addField(On on, const std::string& name, int nComponents,
                  const std::vector<double>& values, const std::string& attribute = "");
    void addField(On on, const std::string& name, const std::vector<int>& values);

    /// Texts that belong to the whole file.
    void addTexts(const std::string& name, const std::vector<std::string>& texts);

    /// @throws OutputError
    void write(const std::string& path) const;

  private:
    /// Element of the XML and what it holds.
    struct Section {
        std::string attributes, arrays;
    };
    struct Piece {
        Section points, cells, pointData, cellData;
        std::string counts;
    };
    Section& section(On on) {
        return on == On::points ? pieces_.back().pointData : pieces_.back().cellData;
    }
    static std::string text(const Piece& piece);

    /// Text that announces an array whose bytes are appended.
    template <class Value>
    std::string append(const std::string& name, int nComponents, const std::vector<Value>& values);

    std::vector<Piece> pieces_;
    std::string texts_;
    std::string bytes_;
};

} // namespace tokay
