#include "geometry/writeModelVtu.hpp"

#include "common/errors.hpp"
#include "geometry/chords.hpp"
#include "geometry/patchTriangles.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>

namespace tokay::geometry {

namespace {

enum CellType { polyLine = 4, triangle = 5 };

struct Cells {
    std::vector<double> coordinates, xi, eta;
    std::vector<int> connectivity, offsets, types, faces, edges, elements;

    int nPoints() const { return static_cast<int>(xi.size()); }

    void addPoint(const Point& point, double pointXi, double pointEta) {
        coordinates.insert(coordinates.end(), {point[0], point[1], point[2]});
        xi.push_back(pointXi);
        eta.push_back(pointEta);
    }
    void endCell(CellType type, int face, int edge, int element) {
        offsets.push_back(static_cast<int>(connectivity.size()));
        types.push_back(type);
        faces.push_back(face);
        edges.push_back(edge);
        elements.push_back(element);
    }
};

void addFace(const BrepModel& model, int face, double tolerance, Cells& cells) {
    const PatchTriangles mesh = patchTriangles(model.patch(face), tolerance);
    const int first = cells.nPoints();
    for (std::size_t i = 0; i < mesh.parameters.size(); ++i)
        cells.addPoint(mesh.points.row(i), mesh.parameters[i][0], mesh.parameters[i][1]);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const int corner : mesh.triangles[i])
            cells.connectivity.push_back(first + corner);
        cells.endCell(triangle, face, -1, mesh.elements[i]);
    }
}

void addEdge(const BrepModel& model, int edge, double tolerance, Cells& cells) {
    for (const BrepTrim& trim : model.edges()[edge].trims) {
        const CurveOnSurface curve = model.curveInSpace(trim);
        for (const double t : chordParameters(curve, tolerance)) {
            const Point at = curve.parameterCurve().point(t);
            cells.connectivity.push_back(cells.nPoints());
            cells.addPoint(curve.derivatives(t, 0).row(0), at[0], at[1]);
        }
        cells.endCell(polyLine, trim.face, edge, -1);
    }
}

template <class Value>
std::string array(const char* type, const char* name, int nComponents,
                  const std::vector<Value>& values) {
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                       "format=\"ascii\">\n{}\n</DataArray>\n",
                       type, name, nComponents, fmt::join(values, " "));
}

/// Texts as VTK has them: numbers of their characters, ended by zeros.
std::string names(const char* name, const std::vector<std::string>& texts) {
    std::vector<int> characters;
    for (const std::string& text : texts) {
        for (const unsigned char c : text)
            characters.push_back(c);
        characters.push_back(0);
    }
    return fmt::format("<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" "
                       "format=\"ascii\">\n{}\n</DataArray>\n",
                       name, texts.size(), fmt::join(characters, " "));
}

std::string fieldData(const BrepModel& model) {
    std::vector<std::string> faces, edges;
    for (const BrepFace& face : model.faces())
        faces.push_back(face.patch.name());
    for (const BrepEdge& edge : model.edges())
        edges.push_back(edge.name);
    return "<FieldData>\n" + names("faceNames", faces) + names("edgeNames", edges) +
           "</FieldData>\n";
}

std::string xml(const BrepModel& model, const Cells& cells) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
           "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n" +
           fieldData(model) +
           fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", cells.nPoints(),
                       cells.types.size()) +
           "<PointData>\n" + array("Float64", "xi", 1, cells.xi) +
           array("Float64", "eta", 1, cells.eta) + "</PointData>\n<CellData>\n" +
           array("Int32", "face", 1, cells.faces) + array("Int32", "edge", 1, cells.edges) +
           array("Int32", "element", 1, cells.elements) + "</CellData>\n<Points>\n" +
           array("Float64", "Points", 3, cells.coordinates) + "</Points>\n<Cells>\n" +
           array("Int32", "connectivity", 1, cells.connectivity) +
           array("Int32", "offsets", 1, cells.offsets) + array("UInt8", "types", 1, cells.types) +
           "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace

void writeModelVtu(const BrepModel& model, const std::string& path, double chordTolerance) {
    const double tolerance = chordTolerance > 0 ? chordTolerance : 1e-3 * model.size();
    Cells cells;
    for (std::size_t face = 0; face < model.faces().size(); ++face)
        addFace(model, static_cast<int>(face), tolerance, cells);
    for (std::size_t edge = 0; edge < model.edges().size(); ++edge)
        addEdge(model, static_cast<int>(edge), tolerance, cells);
    std::ofstream file(path);
    file << xml(model, cells);
    file.close();
    if (!file)
        throw InputError(fmt::format("{}: the file cannot be written. Check the folder and the "
                                     "space left.",
                                     path));
}

} // namespace tokay::geometry
