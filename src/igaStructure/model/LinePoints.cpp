#include "igaStructure/model/LinePoints.hpp"

#include "common/errors.hpp"
#include "geometry/gaussLegendre.hpp"

#include <fmt/format.h>

namespace tokay::structure {

LineDerivatives LinePoint::derivatives(const Eigen::VectorXd& field) const {
    LineDerivatives sum{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (int a = 0; a < N.cols(); ++a) {
        for (int c = 0; c < dimension; ++c) {
            const double value = field[dimension * (first + a) + c];
            sum.first[c] += N(1, a) * value;
            sum.second[c] += N(2, a) * value;
        }
    }
    return sum;
}

std::vector<LinePoint> linePoints(const geometry::NurbsCurve& curve, int nPointsPerElement,
                                  int dimension) {
    const std::vector<double>& breakpoints = curve.knotVector().breakpoints();
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(nPointsPerElement);
    std::vector<LinePoint> points;
    for (std::size_t element = 0; element + 1 < breakpoints.size(); ++element) {
        const double span = breakpoints[element + 1] - breakpoints[element];
        for (int g = 0; g < nPointsPerElement; ++g) {
            const double xi = breakpoints[element] + rule.points[g] * span;
            const geometry::Points derivatives = curve.derivatives(xi, 2);
            geometry::CurveBasis basis = curve.basis(xi, 2);
            const double length = derivatives.row(1).norm() * rule.weights[g] * span;
            if (!(length > 0)) {
                throw InputError(fmt::format("the line has no tangent at x = {:.6g}, y = {:.6g}: "
                                             "control points coincide there",
                                             derivatives(0, 0), derivatives(0, 1)));
            }
            points.push_back({dimension,
                              static_cast<int>(element),
                              basis.first,
                              std::move(basis.N),
                              {derivatives.row(1), derivatives.row(2)},
                              derivatives.row(0),
                              length});
        }
    }
    return points;
}

} // namespace tokay::structure
