// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/FaceJump.hpp"

namespace tokay::structure {

using geometry::ElementState;

namespace {

const geometry::KnotVector& knotsAlong(const geometry::NurbsSurface& surface, int axis) {
    return axis == 0 ? surface.u() : surface.v();
}

} // namespace

bool hasFourthDerivativeInKnots(const geometry::NurbsSurface& surface, int axis) {
    return knotsAlong(surface, axis).degree() == 3;
}

std::array<int, 2> neighboursAlong(const geometry::TrimmedPatch& patch, int element, int axis) {
    const int nU = patch.nElementsU();
    const int index = axis == 0 ? element % nU : element / nU;
    const int count = axis == 0 ? nU : patch.nElementsV();
    const int stride = axis == 0 ? 1 : nU;
    const auto withBody = [&](bool exists, int neighbour) {
        return exists && patch.state(neighbour) != ElementState::empty ? neighbour : -1;
    };
    return {withBody(index > 0, element - stride), withBody(index < count - 1, element + stride)};
}

FaceJump::FaceJump(const ShellPatch& patch, int axis, const std::array<int, 2>& pair)
    : patch_(patch), axis_(axis), pair_(pair) {
    const geometry::ParameterBox before = patch.patch().elementBox(pair[0]);
    const geometry::ParameterBox after = patch.patch().elementBox(pair[1]);
    knot_ = after.lower[axis];
    size_ = 0.5 * (before.size()[axis] + after.size()[axis]);
}

bool FaceJump::isSmooth() const {
    return knotsAlong(patch_.surface(), axis_).multiplicity(knot_) == 1;
}

void FaceJump::add(const geometry::Parameters& place, int order, double factor, NodeUnion& nodes,
                   Eigen::RowVectorXd& row) const {
    const geometry::NurbsSurface& surface = patch_.surface();
    const int nU = patch_.patch().nElementsU();
    const int derivative =
        axis_ == 0 ? geometry::derivativeRow(order, 0) : geometry::derivativeRow(0, order);
    geometry::Parameters at = place;
    at[axis_] = knot_;
    for (int side = 0; side < 2; ++side) {
        const int element = pair_[side];
        const geometry::SurfaceBasis basis = geometry::spanBasis(
            surface, surface.u().findSpan(surface.u().breakpoints()[element % nU]),
            surface.v().findSpan(surface.v().breakpoints()[element / nU]), at[0], at[1], order);
        std::vector<int> own;
        for (const int k : basis.controlPoints) {
            own.push_back(patch_.nodes()[k]);
        }
        const std::vector<Eigen::Index> places = nodes.add(own);
        const Eigen::Index before = row.size();
        row.conservativeResize(nodes.size());
        row.tail(nodes.size() - before).setZero();
        for (std::size_t k = 0; k < places.size(); ++k) {
            row[places[k]] +=
                (side == 0 ? -factor : factor) * basis.N(derivative, static_cast<Eigen::Index>(k));
        }
    }
}

} // namespace tokay::structure
