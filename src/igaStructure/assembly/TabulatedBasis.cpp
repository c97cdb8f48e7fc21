// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/TabulatedBasis.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"

namespace tokay::structure {

TabulatedBasis::TabulatedBasis(const geometry::KnotVector& knots, int nPointsPerSpan,
                               int nDerivatives)
    : degree_(knots.degree()), nPoints_(nPointsPerSpan) {
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(nPoints_);
    const std::vector<double>& breakpoints = knots.breakpoints();
    for (std::size_t k = 0; k + 1 < breakpoints.size(); ++k) {
        const double length = breakpoints[k + 1] - breakpoints[k];
        const int span = knots.findSpan(breakpoints[k]);
        firstFunctions_.push_back(span - degree_);
        for (int g = 0; g < nPoints_; ++g) {
            const double xi = breakpoints[k] + rule.points[g] * length;
            parameters_.push_back(xi);
            weights_.push_back(rule.weights[g] * length);
            basis_.push_back(knots.basisDerivatives(span, xi, nDerivatives));
        }
    }
}

} // namespace tokay::structure
