// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/solid/SolidElement.hpp"

#include "igaStructure/assembly/GeometryError.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

namespace tokay::structure {

namespace {

TabulatedBasis tabulated(const geometry::KnotVector& knots, int additionalPoints) {
    return TabulatedBasis(knots, knots.degree() + 1 + additionalPoints);
}

} // namespace

SolidGrid::SolidGrid(const geometry::NurbsVolume& volume_, const PatchNodes& nodes_,
                     int additionalPoints)
    : volume(volume_), nodes(nodes_),
      basis{tabulated(volume.u(), additionalPoints), tabulated(volume.v(), additionalPoints),
            tabulated(volume.w(), additionalPoints)} {}

int SolidGrid::nFunctions() const {
    return basis[0].nFunctions() * basis[1].nFunctions() * basis[2].nFunctions();
}

int SolidGrid::nPointsPerElement() const {
    return basis[0].nPointsPerSpan() * basis[1].nPointsPerSpan() * basis[2].nPointsPerSpan();
}

SolidElement::SolidElement(const SolidGrid& grid)
    : grid_(&grid), nodes_(grid.nFunctions()), coordinates_(3, grid.nFunctions()),
      weights_(grid.nFunctions()), values_(grid.nFunctions()), derivatives_(3, grid.nFunctions()),
      gradients_(3, grid.nFunctions()) {}

void SolidElement::moveToElement(const Eigen::Vector3i& spans) {
    spans_ = spans;
    const geometry::NurbsVolume& volume = grid_->volume;
    const auto number = [&](int axis, int function) {
        return grid_->basis[axis].firstFunction(spans[axis]) + function;
    };
    int a = 0;
    for (int k = 0; k < grid_->basis[2].nFunctions(); ++k) {
        for (int j = 0; j < grid_->basis[1].nFunctions(); ++j) {
            for (int i = 0; i < grid_->basis[0].nFunctions(); ++i, ++a) {
                const int point =
                    number(0, i) +
                    volume.u().nBasis() * (number(1, j) + volume.v().nBasis() * number(2, k));
                nodes_[a] = grid_->nodes.of(point);
                coordinates_.col(a) = volume.controlPoints().row(point).transpose();
                weights_[a] = volume.isRational() ? volume.weights()[point] : 1;
            }
        }
    }
}

void SolidElement::setProducts(const std::array<const Eigen::MatrixXd*, 3>& N) {
    const Eigen::MatrixXd &u = *N[0], &v = *N[1], &w = *N[2];
    int a = 0;
    for (int k = 0; k < w.cols(); ++k) {
        for (int j = 0; j < v.cols(); ++j) {
            const double both = v(0, j) * w(0, k);
            const double byEta = v(1, j) * w(0, k);
            const double byZeta = v(0, j) * w(1, k);
            for (int i = 0; i < u.cols(); ++i, ++a) {
                values_[a] = u(0, i) * both;
                derivatives_(0, a) = u(1, i) * both;
                derivatives_(1, a) = u(0, i) * byEta;
                derivatives_(2, a) = u(0, i) * byZeta;
            }
        }
    }
}

void SolidElement::moveToPoint(int point) {
    std::array<const Eigen::MatrixXd*, 3> N;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const TabulatedBasis& basis = grid_->basis[axis];
        const int own = point % basis.nPointsPerSpan();
        point /= basis.nPointsPerSpan();
        N[axis] = &basis.at(spans_[axis], own);
        weight *= basis.weight(spans_[axis], own);
    }
    setProducts(N);
    if (grid_->volume.isRational()) {
        makeRational();
    }
    const Eigen::Matrix3d jacobian = derivatives_ * coordinates_.transpose(); // dX_j / dxi_i
    volume_ = jacobian.determinant() * weight;
    gradients_.noalias() = jacobian.inverse() * derivatives_;
}

// Quotient rule, Piegl & Tiller equation 4.20 for each function.
void SolidElement::makeRational() {
    values_.array() *= weights_.array();
    derivatives_.array().rowwise() *= weights_.transpose().array();
    const double sum = values_.sum();
    const Eigen::Vector3d sumDerivative = derivatives_.rowwise().sum();
    values_ /= sum;
    derivatives_ = (derivatives_ - sumDerivative * values_.transpose()).eval() / sum;
}

void SolidElement::gather(const Eigen::VectorXd& values, Coefficients& local) const {
    local.resize(3, nFunctions());
    for (int a = 0; a < nFunctions(); ++a) {
        local.col(a) = values.segment<3>(3 * nodes_[a]);
    }
}

void SolidElement::scatter(const Coefficients& local, Eigen::VectorXd& values) const {
    for (int a = 0; a < nFunctions(); ++a) {
        values.segment<3>(3 * nodes_[a]) += local.col(a);
    }
}

void SolidElement::requireRegular() const {
    if (volume_ > 0) {
        return;
    }
    const Eigen::Vector3d x = position();
    throw GeometryError(fmt::format(
        "the geometry is turned inside out near x = {:.6g}, y = {:.6g}, z = {:.6g} (element {} of "
        "{} along xi, {} of {} along eta, {} of {} along zeta): its volume element (that of the "
        "point, with its quadrature weight) is {:.3g} m^3 and must be positive; xi, eta and zeta "
        "must be a right-handed system everywhere, and a thickened surface must be thinner than "
        "twice its radius of curvature",
        x[0], x[1], x[2], spans_[0] + 1, grid_->basis[0].nSpans(), spans_[1] + 1,
        grid_->basis[1].nSpans(), spans_[2] + 1, grid_->basis[2].nSpans(), volume_));
}

} // namespace tokay::structure
