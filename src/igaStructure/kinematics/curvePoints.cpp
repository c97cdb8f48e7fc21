// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/curvePoints.hpp"

#include "igaStructure/assembly/TabulatedBasis.hpp"

namespace tokay::structure {

void addCurvePoints(const geometry::NurbsCurve& curve, const std::vector<int>& nodes,
                    const std::array<bool, 3>& components, const SupportMotion& motion,
                    std::vector<SupportPoint>& points) {
    // Formulas need not be polynomials: two points more than the basis needs.
    const TabulatedBasis gauss(curve.knotVector(), curve.degree() + 3);
    for (int span = 0; span < gauss.nSpans(); ++span) {
        for (int g = 0; g < gauss.nPointsPerSpan(); ++g) {
            const double xi = gauss.parameter(span, g);
            const geometry::Points derivatives = curve.derivatives(xi, 1);
            const geometry::CurveBasis basis = curve.basis(xi, 0);
            SupportPoint point{{},
                               basis.N.row(0),
                               gauss.weight(span, g) * derivatives.row(1).norm(),
                               derivatives.row(0),
                               components,
                               motion};
            for (Eigen::Index a = 0; a < basis.N.cols(); ++a) {
                point.nodes.push_back(nodes[basis.first + a]);
            }
            points.push_back(std::move(point));
        }
    }
}

std::vector<bool> movingOnly(std::vector<bool> moving, const std::vector<bool>& atRest) {
    for (std::size_t k = 0; k < moving.size(); ++k) {
        moving[k] = moving[k] && !atRest[k];
    }
    return moving;
}

} // namespace tokay::structure
