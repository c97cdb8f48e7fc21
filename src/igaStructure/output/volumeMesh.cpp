// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/output/volumeMesh.hpp"

#include "igaStructure/output/bernstein.hpp"

#include <array>

namespace tokay::structure {

namespace {

// Grid of (n + 1) x (m + 1) x (l + 1) points on each element, xi fastest.
std::vector<Location> gridPoints(const geometry::NurbsVolume& volume, const Eigen::Vector3i& n) {
    const auto parameter = [&](int axis, int span, int i) {
        const std::vector<double>& breakpoints = volume.direction(axis).breakpoints();
        return breakpoints[span] + (breakpoints[span + 1] - breakpoints[span]) * i / n[axis];
    };
    const Eigen::Vector3i nSpans(volume.u().nSpans(), volume.v().nSpans(), volume.w().nSpans());
    const Eigen::Vector3i nPoints = n.array() + 1;
    std::vector<Location> points;
    for (int element = 0; element < nSpans.prod(); ++element) {
        const int spanU = element % nSpans[0];
        const int spanV = element / nSpans[0] % nSpans[1];
        const int spanW = element / nSpans[0] / nSpans[1];
        for (int k = 0; k < nPoints.prod(); ++k) {
            points.push_back({0, parameter(0, spanU, k % nPoints[0]),
                              parameter(1, spanV, k / nPoints[0] % nPoints[1]),
                              parameter(2, spanW, k / nPoints[0] / nPoints[1])});
        }
    }
    return points;
}

// VTK's number of point (i, j, k) in a cell: corners, edges, faces, interior. The
// edges along zeta at the last eta are numbered as files of version 1.0 have them.
// Source: vtkHigherOrderHexahedron::PointIndexFromIJK, VTK 8
int vtkPointNumber(const Eigen::Vector3i& at, const Eigen::Vector3i& degrees) {
    const Eigen::Vector3i inner = degrees.array() - 1;
    const auto isLast = [&](int axis) { return at[axis] == degrees[axis]; };
    const auto onSide = [&](int axis) { return at[axis] == 0 || isLast(axis); };
    const int nSides = onSide(0) + onSide(1) + onSide(2);
    int number = 0;
    if (nSides == 3) {
        return (isLast(0) ? (isLast(1) ? 2 : 1) : (isLast(1) ? 3 : 0)) + (isLast(2) ? 4 : 0);
    }
    number += 8;
    const int ring = 2 * (inner[0] + inner[1]);
    if (nSides == 2) {
        if (!onSide(0)) {
            return number + at[0] - 1 + (isLast(1) ? inner[0] + inner[1] : 0) +
                   (isLast(2) ? ring : 0);
        }
        if (!onSide(1)) {
            return number + at[1] - 1 + (isLast(0) ? inner[0] : 2 * inner[0] + inner[1]) +
                   (isLast(2) ? ring : 0);
        }
        const int edge = isLast(0) ? (isLast(1) ? 3 : 1) : (isLast(1) ? 2 : 0);
        return number + 2 * ring + at[2] - 1 + inner[2] * edge;
    }
    number += 4 * inner.sum();
    if (nSides == 1) {
        for (int axis = 0; axis < 3; ++axis) {
            const int first = axis == 0 ? 1 : 0;
            const int second = axis == 2 ? 1 : 2;
            const int nOnFace = inner[first] * inner[second];
            if (onSide(axis)) {
                return number + (isLast(axis) ? nOnFace : 0) + at[first] - 1 +
                       inner[first] * (at[second] - 1);
            }
            number += 2 * nOnFace;
        }
    }
    number += 2 * (inner[0] * inner[1] + inner[1] * inner[2] + inner[0] * inner[2]);
    return number + at[0] - 1 + inner[0] * (at[1] - 1 + inner[1] * (at[2] - 1));
}

} // namespace

VtuMesh hexahedronMesh(const geometry::NurbsVolume& volume, int subdivision) {
    VtuMesh mesh;
    mesh.cellSize = 8;
    mesh.cellType = VtkCell::hexahedron;
    mesh.points = gridPoints(volume, Eigen::Vector3i::Constant(subdivision));
    const int row = subdivision + 1;
    const auto nPoints = static_cast<int>(mesh.points.size());
    for (int first = 0; first < nPoints; first += row * row * row) {
        for (int cell = 0; cell < subdivision * subdivision * subdivision; ++cell) {
            const int corner = first + cell % subdivision +
                               row * (cell / subdivision % subdivision) +
                               row * row * (cell / subdivision / subdivision);
            for (const int layer : {corner, corner + row * row}) {
                mesh.connectivity.insert(mesh.connectivity.end(),
                                         {layer, layer + 1, layer + 1 + row, layer + row});
            }
        }
    }
    return mesh;
}

VtuMesh bezierMesh(const geometry::NurbsVolume& volume) {
    VtuMesh mesh;
    mesh.degrees = {volume.u().degree(), volume.v().degree(), volume.w().degree()};
    mesh.cellSize = (mesh.degrees.array() + 1).prod();
    mesh.cellType = VtkCell::bezierHexahedron;
    mesh.points = gridPoints(volume, mesh.degrees);
    mesh.toBernsteinXi = bernsteinInverse(mesh.degrees[0]);
    mesh.toBernsteinEta = bernsteinInverse(mesh.degrees[1]);
    mesh.toBernsteinZeta = bernsteinInverse(mesh.degrees[2]);
    const auto nPoints = static_cast<int>(mesh.points.size());
    mesh.connectivity.resize(nPoints);
    const int nU = mesh.degrees[0] + 1;
    const int nV = mesh.degrees[1] + 1;
    for (int point = 0; point < nPoints; ++point) {
        const int local = point % mesh.cellSize;
        const Eigen::Vector3i at(local % nU, local / nU % nV, local / nU / nV);
        mesh.connectivity[point - local + vtkPointNumber(at, mesh.degrees)] = point;
    }
    mesh.weights = Eigen::VectorXd::Ones(nPoints);
    if (volume.isRational()) {
        const geometry::NurbsVolume denominator(
            volume.u(), volume.v(), volume.w(),
            geometry::Points(volume.weights() * Eigen::RowVector3d(1, 0, 0)));
        mesh.setDenominators([&](const Location& location) {
            return denominator.point({location.xi, location.eta, location.zeta})[0];
        });
    }
    return mesh;
}

} // namespace tokay::structure
