// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/writeModelVtu.hpp"

#include "common/VtuFile.hpp"
#include "geometry/trimming/chords.hpp"
#include "geometry/trimming/patchTriangles.hpp"

namespace tokay::geometry {

namespace {

struct Cells {
    std::vector<double> coordinates, xi, eta;
    std::vector<std::int64_t> connectivity, ends;
    std::vector<VtkCell> types;
    std::vector<int> faces, edges, elements;

    int nPoints() const { return static_cast<int>(xi.size()); }

    void addPoint(const Point& point, double pointXi, double pointEta) {
        coordinates.insert(coordinates.end(), {point[0], point[1], point[2]});
        xi.push_back(pointXi);
        eta.push_back(pointEta);
    }
    void endCell(VtkCell type, int face, int edge, int element) {
        ends.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(type);
        faces.push_back(face);
        edges.push_back(edge);
        elements.push_back(element);
    }
};

void addFace(const BrepModel& model, int face, double tolerance, Cells& cells) {
    const PatchTriangles mesh = patchTriangles(model.patch(face), tolerance);
    const int first = cells.nPoints();
    for (std::size_t i = 0; i < mesh.parameters.size(); ++i) {
        cells.addPoint(mesh.points.row(i), mesh.parameters[i][0], mesh.parameters[i][1]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const int corner : mesh.triangles[i]) {
            cells.connectivity.push_back(first + corner);
        }
        cells.endCell(VtkCell::triangle, face, -1, mesh.elements[i]);
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
        cells.endCell(VtkCell::polyLine, trim.face, edge, -1);
    }
}

void addNames(const BrepModel& model, VtuFile& file) {
    std::vector<std::string> faces, edges;
    for (const BrepFace& face : model.faces()) {
        faces.push_back(face.patch.name());
    }
    for (const BrepEdge& edge : model.edges()) {
        edges.push_back(edge.name);
    }
    file.addTexts("faceNames", faces);
    file.addTexts("edgeNames", edges);
}

} // namespace

void writeModelVtu(const BrepModel& model, const std::string& path, double chordTolerance) {
    const double tolerance = chordTolerance > 0 ? chordTolerance : 1e-3 * model.size();
    Cells cells;
    for (std::size_t face = 0; face < model.faces().size(); ++face) {
        addFace(model, static_cast<int>(face), tolerance, cells);
    }
    for (std::size_t edge = 0; edge < model.edges().size(); ++edge) {
        addEdge(model, static_cast<int>(edge), tolerance, cells);
    }
    VtuFile file;
    file.beginPiece(cells.coordinates, cells.connectivity, cells.ends, cells.types);
    addNames(model, file);
    file.addField(VtuFile::On::points, "xi", 1, cells.xi);
    file.addField(VtuFile::On::points, "eta", 1, cells.eta);
    file.addField(VtuFile::On::cells, "face", cells.faces);
    file.addField(VtuFile::On::cells, "edge", cells.edges);
    file.addField(VtuFile::On::cells, "element", cells.elements);
    file.write(path);
}

} // namespace tokay::geometry
