// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/splineProjection.hpp"

#include "geometry/trimming/elementQuadrature.hpp"
#include "mapper/mortar/MassInverse.hpp"

#include <Eigen/Geometry>

namespace tokay::tool {

using geometry::Point;
using geometry::Points;

Eigen::VectorXd splineProjection(const mapper::SurfaceInterface& splines,
                                 const std::function<double(const Point&)>& function) {
    const int n = splines.nValues();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n);
    for (int piece = 0; piece < splines.nPieces(); ++piece) {
        const geometry::TrimmedPatch& patch = splines.piece(piece).patch;
        const geometry::NurbsSurface& surface = patch.basis();
        const int degree = 2 * std::max(surface.u().degree(), surface.v().degree()) + 2;
        for (int element = 0; element < patch.nElements(); ++element) {
            for (const auto& at : elementQuadrature(patch, element, degree)) {
                const Points d = surface.derivatives(at.xi, at.eta, 1);
                const double weight = at.weight * Point(d.row(1)).cross(Point(d.row(2))).norm();
                const double value = function(d.row(0));
                const mapper::Functions f = splines.functions(piece, at.xi, at.eta);
                for (std::size_t i = 0; i < f.values.size(); ++i) {
                    rhs[f.values[i]] += weight * f.weights[i] * value;
                    for (std::size_t j = 0; j < f.values.size(); ++j) {
                        entries.emplace_back(f.values[i], f.values[j],
                                             weight * f.weights[i] * f.weights[j]);
                    }
                }
            }
        }
    }
    mapper::RowSparseMatrix mass(n, n);
    mass.setFromTriplets(entries.begin(), entries.end());
    return mapper::MassInverse(mass, mapper::SingularMass::minimumNorm).solve(rhs);
}

} // namespace tokay::tool
