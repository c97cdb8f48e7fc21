// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/NurbsSurface.hpp"

#include "common/errors.hpp"
#include "geometry/spline/rational.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

const std::array<const char*, 4> edgeNames = {"left", "right", "bottom", "top"};

/// Turns functions N_i into w_i N_i / sum of w_j N_j, derivative by derivative.
void makeRational(Eigen::MatrixXd& N, const Eigen::VectorXd& weights, int order) {
    N *= weights.asDiagonal();
    const Eigen::VectorXd sums = N.rowwise().sum();
    for (int n = 0; n <= order; ++n) {
        for (int l = 0; l <= n; ++l) {
            const int k = n - l;
            auto row = N.row(derivativeRow(k, l));
            for (int i = 0; i <= k; ++i) {
                for (int j = i == 0 ? 1 : 0; j <= l; ++j) {
                    row -= binomial(k, i) * binomial(l, j) * sums[derivativeRow(i, j)] *
                           N.row(derivativeRow(k - i, l - j));
                }
            }
            row /= sums[0];
        }
    }
}

} // namespace

Edge edgeFromName(const std::string& name) {
    const auto found = std::find(edgeNames.begin(), edgeNames.end(), name);
    if (found == edgeNames.end()) {
        throw InputError(fmt::format("there is no edge \"{}\": a patch has the edges left, right, "
                                     "bottom and top",
                                     name));
    }
    return static_cast<Edge>(found - edgeNames.begin());
}

std::string nameOf(Edge edge) {
    return edgeNames[static_cast<int>(edge)];
}

NurbsSurface::NurbsSurface(KnotVector u, KnotVector v, Points controlPoints,
                           Eigen::VectorXd weights)
    : u_(std::move(u)), v_(std::move(v)), controlPoints_(std::move(controlPoints)),
      weights_(checkedWeights(std::move(weights), nControlPoints(), "the surface")) {
    checkControlPoints(controlPoints_, nControlPoints(), "the surface");
}

SurfaceBasis NurbsSurface::basis(double xi, double eta, int nDerivatives) const {
    return spanBasis(*this, u_.findSpan(xi), v_.findSpan(eta), xi, eta, nDerivatives);
}

SurfaceBasis spanBasis(const NurbsSurface& surface, int spanU, int spanV, double xi, double eta,
                       int nDerivatives) {
    const int p = surface.u().degree(), q = surface.v().degree();
    const Eigen::MatrixXd Nu = surface.u().basisDerivatives(spanU, xi, nDerivatives);
    const Eigen::MatrixXd Nv = surface.v().basisDerivatives(spanV, eta, nDerivatives);

    SurfaceBasis basis;
    basis.controlPoints.reserve((p + 1) * (q + 1));
    basis.N.resize(nDerivativeRows(nDerivatives), (p + 1) * (q + 1));
    for (int j = 0; j <= q; ++j) {
        for (int i = 0; i <= p; ++i) {
            basis.controlPoints.push_back(spanU - p + i + surface.u().nBasis() * (spanV - q + j));
        }
        for (int n = 0; n <= nDerivatives; ++n) {
            for (int l = 0; l <= n; ++l) {
                basis.N.row(derivativeRow(n - l, l)).segment(j * (p + 1), p + 1) =
                    Nv(l, j) * Nu.row(n - l);
            }
        }
    }
    if (surface.isRational()) {
        makeRational(basis.N, surface.weights()(basis.controlPoints), nDerivatives);
    }
    return basis;
}

Points NurbsSurface::derivatives(double xi, double eta, int n) const {
    const SurfaceBasis b = basis(xi, eta, n);
    Points d = Points::Zero(b.N.rows(), 3);
    for (std::size_t i = 0; i < b.controlPoints.size(); ++i) {
        d.noalias() += b.N.col(i) * controlPoints_.row(b.controlPoints[i]);
    }
    return d;
}

Point NurbsSurface::point(double xi, double eta) const {
    return derivatives(xi, eta, 0).row(0);
}

BoundaryCurve NurbsSurface::boundaryCurve(Edge edge) const {
    const int nU = u_.nBasis(), nV = v_.nBasis();
    const bool alongU = edge == Edge::bottom || edge == Edge::top;
    const int start = edge == Edge::right ? nU - 1 : edge == Edge::top ? nU * (nV - 1) : 0;
    const int step = alongU ? 1 : nU;

    std::vector<int> numbers(alongU ? nU : nV);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = start + step * static_cast<int>(i);
    }
    Eigen::VectorXd weights;
    if (isRational()) {
        weights = weights_(numbers);
    }
    return {NurbsCurve(alongU ? u_ : v_, controlPoints_(numbers, Eigen::all), std::move(weights)),
            std::move(numbers)};
}

NurbsSurface NurbsSurface::withControlPoints(Points controlPoints) const {
    return NurbsSurface(u_, v_, std::move(controlPoints), weights_);
}

} // namespace tokay::geometry
