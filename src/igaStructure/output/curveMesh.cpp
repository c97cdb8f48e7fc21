// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/output/curveMesh.hpp"

#include "igaStructure/output/bernstein.hpp"

namespace tokay::structure {

VtuMesh stripMesh(const geometry::NurbsCurve& curve, int subdivision, double thickness) {
    const std::vector<double>& xi = curve.knotVector().breakpoints();
    VtuMesh mesh;
    for (std::size_t span = 0; span + 1 < xi.size(); ++span) {
        const auto first = static_cast<std::int64_t>(mesh.points.size());
        for (int i = 0; i <= subdivision; ++i) {
            const double at = xi[span] + (xi[span + 1] - xi[span]) * i / subdivision;
            mesh.points.push_back({0, at, 0, -0.5 * thickness});
            mesh.points.push_back({0, at, 0, 0.5 * thickness});
        }
        for (int i = 0; i < subdivision; ++i) {
            const std::int64_t right = first + 2 * i;
            mesh.connectivity.insert(mesh.connectivity.end(),
                                     {right, right + 2, right + 3, right + 1});
        }
    }
    return mesh;
}

VtuMesh segmentMesh(const geometry::NurbsCurve& curve, int subdivision) {
    const std::vector<double>& xi = curve.knotVector().breakpoints();
    VtuMesh mesh;
    mesh.cellType = VtkCell::line;
    mesh.cellSize = 2;
    for (std::size_t span = 0; span + 1 < xi.size(); ++span) {
        const auto first = static_cast<std::int64_t>(mesh.points.size());
        for (int i = 0; i <= subdivision; ++i) {
            mesh.points.push_back(
                {0, xi[span] + (xi[span + 1] - xi[span]) * i / subdivision, 0, 0});
        }
        for (int i = 0; i < subdivision; ++i) {
            mesh.connectivity.insert(mesh.connectivity.end(), {first + i, first + i + 1});
        }
    }
    return mesh;
}

VtuMesh bezierMesh(const geometry::NurbsCurve& curve) {
    const std::vector<double>& xi = curve.knotVector().breakpoints();
    const int p = curve.degree();
    VtuMesh mesh;
    mesh.cellType = VtkCell::bezierCurve;
    mesh.degrees = {p, 0, 0};
    mesh.cellSize = p + 1;
    mesh.toBernsteinXi = bernsteinInverse(p);
    for (std::size_t span = 0; span + 1 < xi.size(); ++span) {
        const auto first = static_cast<std::int64_t>(mesh.points.size());
        mesh.connectivity.insert(mesh.connectivity.end(), {first, first + p}); // ends first
        for (int i = 0; i <= p; ++i) {
            mesh.points.push_back({0, xi[span] + (xi[span + 1] - xi[span]) * i / p, 0, 0});
            if (i > 0 && i < p) {
                mesh.connectivity.push_back(first + i);
            }
        }
    }
    mesh.weights = Eigen::VectorXd::Ones(mesh.points.size());
    if (curve.isRational()) {
        const geometry::NurbsCurve denominator(
            curve.knotVector(), geometry::Points(curve.weights() * Eigen::RowVector3d(1, 0, 0)));
        mesh.setDenominators(
            [&](const Location& location) { return denominator.point(location.xi)[0]; });
    }
    return mesh;
}

} // namespace tokay::structure
