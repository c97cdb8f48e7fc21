// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/output/VtuMesh.hpp"

#include "igaStructure/output/bernstein.hpp"

namespace tokay::structure {

namespace {

// A grid of (nU + 1) x (nV + 1) points on each element, xi fastest.
std::vector<Location> gridPoints(const geometry::NurbsSurface& surface, int nU, int nV, int patch) {
    const std::vector<double>& xi = surface.u().breakpoints();
    const std::vector<double>& eta = surface.v().breakpoints();
    std::vector<Location> points;
    for (std::size_t spanV = 0; spanV + 1 < eta.size(); ++spanV) {
        for (std::size_t spanU = 0; spanU + 1 < xi.size(); ++spanU) {
            for (int j = 0; j <= nV; ++j) {
                for (int i = 0; i <= nU; ++i) {
                    points.push_back({patch, xi[spanU] + (xi[spanU + 1] - xi[spanU]) * i / nU,
                                      eta[spanV] + (eta[spanV + 1] - eta[spanV]) * j / nV, 0});
                }
            }
        }
    }
    return points;
}

// VTK's number of point (i, j) in a cell: corners, edges, interior.
// Source: vtkHigherOrderQuadrilateral::PointIndexFromIJK
int vtkPointNumber(int i, int j, const Eigen::Vector3i& degrees) {
    const int p = degrees[0];
    const int q = degrees[1];
    const bool onU = i == 0 || i == p;
    const bool onV = j == 0 || j == q;
    if (onU && onV) {
        return i > 0 ? (j > 0 ? 2 : 1) : (j > 0 ? 3 : 0);
    }
    if (onV) {
        return 4 + (i - 1) + (j > 0 ? p + q - 2 : 0);
    }
    if (onU) {
        return 4 + (j - 1) + (i > 0 ? p - 1 : 2 * (p - 1) + q - 1);
    }
    return 4 + 2 * (p + q - 2) + (i - 1) + (p - 1) * (j - 1);
}

// Bernstein coefficients of values at the points of a cell, xi fastest.
Eigen::MatrixXd toBernstein(const VtuMesh& mesh, const Eigen::Map<const Eigen::MatrixXd>& grid) {
    const Eigen::Vector3i n = mesh.degrees.array() + 1;
    Eigen::MatrixXd result = mesh.toBernsteinXi * grid; // n[0] x (n[1] n[2])
    for (int k = 0; k < n[2]; ++k) {
        auto layer = result.middleCols(k * n[1], n[1]);
        layer = (layer * mesh.toBernsteinEta.transpose()).eval();
    }
    const Eigen::Map<Eigen::MatrixXd> columns(result.data(), n[0] * n[1], n[2]);
    return columns * mesh.toBernsteinZeta.transpose();
}

// The same of every cell.
Eigen::MatrixXd toBernstein(const VtuMesh& mesh, const Eigen::MatrixXd& values) {
    const Eigen::Vector3i n = mesh.degrees.array() + 1;
    Eigen::MatrixXd result(values.rows(), values.cols());
    for (Eigen::Index c = 0; c < values.rows(); ++c) {
        const Eigen::RowVectorXd row = values.row(c);
        Eigen::RowVectorXd coefficients(row.size());
        for (Eigen::Index cell = 0; cell < row.size(); cell += mesh.cellSize) {
            const Eigen::Map<const Eigen::MatrixXd> grid(row.data() + cell, n[0], n[1] * n[2]);
            Eigen::Map<Eigen::MatrixXd>(coefficients.data() + cell, n[0] * n[1], n[2]) =
                toBernstein(mesh, grid);
        }
        result.row(c) = coefficients;
    }
    return result;
}

} // namespace

VtuMesh quadMesh(const geometry::NurbsSurface& surface, int subdivision, int patch) {
    VtuMesh mesh;
    mesh.cellType = VtkCell::quadrilateral;
    mesh.points = gridPoints(surface, subdivision, subdivision, patch);
    const int rowLength = subdivision + 1;
    const auto nPoints = static_cast<int>(mesh.points.size());
    for (int first = 0; first < nPoints; first += rowLength * rowLength) {
        for (int j = 0; j < subdivision; ++j) {
            for (int i = 0; i < subdivision; ++i) {
                const int corner = first + i + rowLength * j;
                mesh.connectivity.insert(
                    mesh.connectivity.end(),
                    {corner, corner + 1, corner + 1 + rowLength, corner + rowLength});
            }
        }
    }
    return mesh;
}

VtuMesh bezierMesh(const geometry::NurbsSurface& surface, int patch) {
    VtuMesh mesh;
    const int p = surface.u().degree();
    const int q = surface.v().degree();
    mesh.cellType = VtkCell::bezierQuadrilateral;
    mesh.degrees = {p, q, 0};
    mesh.cellSize = (p + 1) * (q + 1);
    mesh.points = gridPoints(surface, p, q, patch);
    mesh.toBernsteinXi = bernsteinInverse(p);
    mesh.toBernsteinEta = bernsteinInverse(q);
    const auto nPoints = static_cast<int>(mesh.points.size());
    mesh.connectivity.resize(nPoints);
    for (int first = 0; first < nPoints; first += mesh.cellSize) {
        for (int j = 0; j <= q; ++j) {
            for (int i = 0; i <= p; ++i) {
                mesh.connectivity[first + vtkPointNumber(i, j, mesh.degrees)] =
                    first + i + (p + 1) * j;
            }
        }
    }
    mesh.weights = Eigen::VectorXd::Ones(nPoints);
    if (surface.isRational()) {
        const geometry::NurbsSurface denominator(
            surface.u(), surface.v(),
            geometry::Points(surface.weights() * Eigen::RowVector3d(1, 0, 0)));
        mesh.setDenominators([&](const Location& location) {
            return denominator.point(location.xi, location.eta)[0];
        });
    }
    return mesh;
}

void VtuMesh::setDenominators(const std::function<double(const Location&)>& denominator) {
    Eigen::MatrixXd values(1, points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        values(0, k) = denominator(points[k]);
    }
    weights = toBernstein(*this, values).row(0).transpose();
    denominators = values.row(0).transpose();
}

Eigen::MatrixXd fileValues(const VtuMesh& mesh, const Eigen::MatrixXd& values) {
    if (!mesh.isBezier()) {
        return values;
    }
    if (mesh.denominators.size() == 0) {
        return toBernstein(mesh, values);
    }
    // Numerators are polynomials: interpolate these, then divide by the weights.
    const Eigen::MatrixXd numerators = values * mesh.denominators.asDiagonal();
    return toBernstein(mesh, numerators) * mesh.weights.cwiseInverse().asDiagonal();
}

} // namespace tokay::structure
