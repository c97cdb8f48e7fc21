// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/MembraneSection.hpp"

#include <cmath>

namespace tokay::structure {

using Eigen::Vector3d;

namespace {

// Contravariant components from those in the frame along the first base vector.
Vector3d contravariantStress(const Vector3d& metric, const Vector3d& stress) {
    const double length = std::sqrt(metric[0]);
    const double height = std::sqrt(metric[1] - metric[2] * metric[2] / metric[0]);
    Eigen::Matrix2d dual; // row a: A^a in the frame
    dual << 1 / length, -metric[2] / (length * length * height), 0, 1 / height;
    Eigen::Matrix2d sigma;
    sigma << stress[0], stress[2], stress[2], stress[1];
    const Eigen::Matrix2d components = dual * sigma * dual.transpose();
    return {components(0, 0), components(1, 1), components(0, 1)};
}

} // namespace

SectionResponse MembraneSection::response(const FundamentalForms& reference,
                                          const Vector6d& strains) const {
    Vector6d flat = strains;
    flat.tail<3>().setZero();
    const SectionResponse whole = whole_->response({reference.metric, Vector3d::Zero()}, flat);
    const Vector3d initial = contravariantStress(reference.metric, prestress_);
    SectionResponse response;
    response.tangent.topLeftCorner<3, 3>() = whole.tangent.topLeftCorner<3, 3>();
    response.resultants.head<3>() = whole.resultants.head<3>() + initial;
    response.energy = whole.energy + initial.dot(flat.head<3>());
    return response;
}

} // namespace tokay::structure
