// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/GhostStabilisation.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"
#include "igaStructure/kinematics/shell/edges/CutFractions.hpp"
#include "igaStructure/kinematics/shell/edges/NodeUnion.hpp"

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

namespace {

PatchLocation placeIn(const ShellPatch& patch, int element, const geometry::Parameters& at) {
    const int nU = patch.patch().nElementsU();
    return {patch, element % nU, element / nU, at, Eigen::Vector2d::Zero()};
}

double areaAt(const PatchLocation& place) {
    return place.baseVectors.col(0).cross(place.baseVectors.col(1)).norm();
}

// visit(place, weight in the parameters) at Gauss points of a whole element.
template <class Visit>
void forEachPointOfWhole(const ShellPatch& patch, int element, Visit visit) {
    const geometry::ParameterBox box = patch.patch().elementBox(element);
    const auto& u = geometry::gaussLegendre(patch.surface().u().degree() + 1);
    const auto& v = geometry::gaussLegendre(patch.surface().v().degree() + 1);
    for (std::size_t j = 0; j < v.points.size(); ++j) {
        for (std::size_t i = 0; i < u.points.size(); ++i) {
            const geometry::Parameters inside(u.points[i], v.points[j]);
            visit(geometry::Parameters(box.lower + box.size().cwiseProduct(inside)),
                  u.weights[i] * v.weights[j] * box.area());
        }
    }
}

} // namespace

GhostStabilisation::GhostStabilisation(const ShellPatch& patch, int sliver, int whole,
                                       double tangential, double normal)
    : EdgeCoupling(std::vector<int>()) {
    NodeUnion nodes;
    const geometry::Parameters centre = patch.patch().elementBox(sliver).centre();
    const auto own = nodes.add(placeIn(patch, sliver, centre).nodes);
    const auto continued = nodes.add(placeIn(patch, whole, centre).nodes);
    nodes_ = nodes.nodes();
    const Eigen::Index n = nodes.size();
    stiffness_ = MatrixXd::Zero(3 * n, 3 * n);
    forEachPointOfWhole(patch, sliver, [&](const geometry::Parameters& at, double weight) {
        const PatchLocation here = placeIn(patch, sliver, at);
        const PatchLocation there = placeIn(patch, whole, at);
        RowVectorXd difference = RowVectorXd::Zero(n);
        difference(own) += here.N.row(0);
        difference(continued) -= there.N.row(0);
        const Eigen::Matrix3d across = here.normal() * here.normal().transpose();
        const Eigen::Matrix3d k =
            weight * areaAt(here) *
            (tangential * (Eigen::Matrix3d::Identity() - across) + normal * across);
        for (Eigen::Index b = 0; b < n; ++b) {
            for (Eigen::Index a = 0; a < n; ++a) {
                stiffness_.block<3, 3>(3 * a, 3 * b) += difference[a] * difference[b] * k;
            }
        }
    });
}

EdgeCoupling::Answer GhostStabilisation::answer(const VectorXd& displacement, Strains,
                                                bool withTangent) const {
    const VectorXd u = gathered(displacement);
    const VectorXd force = stiffness_ * u;
    return {force, withTangent ? stiffness_ : MatrixXd(), 0.5 * u.dot(force)};
}

MatrixXd GhostStabilisation::restRows() const {
    return MatrixXd::Zero(1, stiffness_.cols());
}

std::vector<std::unique_ptr<EdgeCoupling>>
ghostStabilisations(const ShellPatch& patch, double membrane, double bending,
                    const std::function<bool(int element)>& isTied) {
    constexpr double factor = 1;
    const CutFractions fractions(patch);
    std::vector<std::unique_ptr<EdgeCoupling>> couplings;
    for (const int element : patch.patch().elements(geometry::ElementState::cut)) {
        const int whole = fractions.standIn(element);
        if (whole == element || !isTied(element)) {
            continue;
        }
        const geometry::ParameterBox box = patch.patch().elementBox(element);
        const double square = box.area() * areaAt(placeIn(patch, element, box.centre()));
        const double tangential = factor * membrane / square;
        couplings.push_back(std::make_unique<GhostStabilisation>(
            patch, element, whole, tangential,
            bending > 0 ? factor * bending / (square * square) : tangential));
    }
    return couplings;
}

} // namespace tokay::structure
