// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/plane/PlaneElement.hpp"

#include "igaStructure/assembly/GeometryError.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

namespace tokay::structure {

PlaneElement::PlaneElement(const geometry::NurbsSurface& surface, const PatchNodes& nodes,
                           const TabulatedBasis& u, const TabulatedBasis& v)
    : surface_(surface), nodes_(nodes), u_(u), v_(v), elementNodes_(nFunctions()),
      coordinates_(2, nFunctions()), weights_(nFunctions()), values_(nFunctions()),
      gradients_(2, nFunctions()) {}

void PlaneElement::moveToElement(int spanU, int spanV) {
    spanU_ = spanU;
    spanV_ = spanV;
    for (int b = 0; b < v_.nFunctions(); ++b) {
        for (int a = 0; a < u_.nFunctions(); ++a) {
            const int local = a + u_.nFunctions() * b;
            const int k =
                u_.firstFunction(spanU) + a + surface_.u().nBasis() * (v_.firstFunction(spanV) + b);
            elementNodes_[local] = nodes_.of(k);
            coordinates_.col(local) = surface_.controlPoints().row(k).head<2>().transpose();
            weights_[local] = surface_.isRational() ? surface_.weights()[k] : 1;
        }
    }
}

void PlaneElement::moveToPoint(int point) {
    const int pointU = point % u_.nPointsPerSpan();
    const int pointV = point / u_.nPointsPerSpan();
    const Eigen::MatrixXd& basisU = u_.at(spanU_, pointU);
    const Eigen::MatrixXd& basisV = v_.at(spanV_, pointV);
    const int nU = u_.nFunctions();
    for (int b = 0; b < v_.nFunctions(); ++b) {
        for (int a = 0; a < nU; ++a) {
            values_[a + nU * b] = basisU(0, a) * basisV(0, b);
            gradients_(0, a + nU * b) = basisU(1, a) * basisV(0, b);
            gradients_(1, a + nU * b) = basisU(0, a) * basisV(1, b);
        }
    }
    if (surface_.isRational()) {
        makeRational();
    }
    const Eigen::Matrix2d jacobian = gradients_ * coordinates_.transpose(); // dX_j / dxi_i
    area_ = jacobian.determinant() * u_.weight(spanU_, pointU) * v_.weight(spanV_, pointV);
    gradients_ = (jacobian.inverse() * gradients_).eval();
}

// Quotient rule, Piegl & Tiller equation 4.20 for each function.
void PlaneElement::makeRational() {
    values_.array() *= weights_.array();
    gradients_.array().rowwise() *= weights_.transpose().array();
    const double sum = values_.sum();
    const Eigen::Vector2d sumGradient = gradients_.rowwise().sum();
    values_ /= sum;
    gradients_ = (gradients_ - sumGradient * values_.transpose()).eval() / sum;
}

void PlaneElement::requireRegular() const {
    if (area_ > 0) {
        return;
    }
    const Eigen::Vector2d x = position();
    throw GeometryError(fmt::format(
        "the geometry folds over near x = {:.6g}, y = {:.6g} (element {} of {} along xi, {} of {} "
        "along eta): its area element (that of the point, with its quadrature weight) is {:.3g} "
        "m^2 and must be positive; control points must run so that xi turns to eta "
        "counter-clockwise",
        x[0], x[1], spanU_ + 1, u_.nSpans(), spanV_ + 1, v_.nSpans(), area_));
}

void PlaneElementTable::add(const PlaneElement& element) {
    nPoints_ = element.nPoints();
    if (areas_.size() % nPoints_ == 0) {
        nodes_.push_back(element.nodes());
    }
    const PlaneElement::Gradients& gradients = element.gradients();
    gradients_.insert(gradients_.end(), gradients.data(), gradients.data() + gradients.size());
    areas_.push_back(element.area());
}

} // namespace tokay::structure
