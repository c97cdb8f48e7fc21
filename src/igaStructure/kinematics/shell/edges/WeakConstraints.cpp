// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/WeakConstraints.hpp"

#include "common/errors.hpp"
#include "igaStructure/kinematics/shell/edges/MultiplierCoupling.hpp"
#include "igaStructure/kinematics/shell/edges/NitscheCoupling.hpp"

#include <Eigen/Geometry>

#include <iterator>

namespace tokay::structure {

void append(EdgeCouplings added, EdgeCouplings& couplings) {
    std::move(added.begin(), added.end(), std::back_inserter(couplings));
}

namespace {

// Area of the element at a location [m^2].
double elementArea(const PatchLocation& at) {
    return at.baseVectors.col(0).cross(at.baseVectors.col(1)).norm() *
           at.patch->patch().elementBox(at.element).area();
}

void addPenalties(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                  bool rotation, const PenaltyStiffness& stiffness, EdgeCouplings& couplings) {
    for (const EdgePoint& point : points) {
        const PatchLocation* other = point.other ? &*point.other : nullptr;
        if (components != std::array<bool, 3>{}) {
            couplings.push_back(std::make_unique<DisplacementPenalty>(
                point.side, other, components,
                point.weight * stiffness.ofAnyDisplacement(point) * Eigen::Matrix3d::Identity(),
                point.weight * stiffness.massOfDisplacement(point)));
        }
        if (rotation) {
            couplings.push_back(std::make_unique<RotationPenalty>(
                point.side, other, point.weight * stiffness.ofRotation(point)));
        }
    }
}

// What multipliers do not see of a trace: they hold its moments with fewer functions than
// it has. Springs as stiff as some elements hold that too, and ask for nothing that the
// solution does not fulfil; across the surface they scale with its bending, so a thin
// shell does not lock.
void addTraceSprings(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                     const WeakConstraints::Stiffness& side, EdgeCouplings& couplings) {
    if (components == std::array<bool, 3>{}) {
        return;
    }
    constexpr double elements = 10; // benchmarks/shells: from 100 on a coarse mesh locks
    const PenaltyStiffness springs = {elements, side.membrane, side.bending};
    // In a step so short that inertia decides there is no bending to be locked.
    constexpr double masses = 1e4; // 1000 leave 1.5 % of the displacement at a corner
    const PenaltyStiffness inertia = {masses, side.membrane, side.bending};
    for (const EdgePoint& point : points) {
        couplings.push_back(std::make_unique<DisplacementPenalty>(
            point.side, point.other ? &*point.other : nullptr, components,
            point.weight * springs.ofDisplacement(point),
            point.weight * inertia.massOfDisplacement(point)));
    }
}

} // namespace

WeakConstraints::WeakConstraints(const ShellDescription& description)
    : description_(description), method_(description.weakEdgeMethod()) {
    requirePossible();
}

void WeakConstraints::requirePossible() const {
    if (method_ != EdgeMethod::nitsche) {
        return;
    }
    if (description_.strains == Strains::nonlinear) {
        throw InputError("edgeMethod nitsche is for linear strains; with nonlinear ones take "
                         "lagrange or penalty");
    }
    if (description_.bending && description_.material.law != MaterialLaw::stVenantKirchhoff) {
        throw InputError("edgeMethod nitsche needs the material StVenantKirchhoff for a shell "
                         "that bends (with linear strains all materials are the same); or "
                         "take lagrange or penalty");
    }
}

WeakConstraints::Stiffness WeakConstraints::stiffness(int face) const {
    const double t = description_.thickness[face];
    const double membrane = description_.materialOf(face).planeStressModulus() * t;
    return {membrane, description_.bending ? membrane * t * t / 12 : 0};
}

double WeakConstraints::factor(EdgeMethod method) const {
    const double usual = method == EdgeMethod::penalty    ? 1e3
                         : method == EdgeMethod::lagrange ? 1e6
                                                          : 1;
    return method_ == method ? description_.penalty.value_or(usual) : usual;
}

void WeakConstraints::holdEdge(const std::vector<EdgePoint>& points,
                               const std::array<bool, 3>& components, bool rotation,
                               const std::array<int, 2>& faces, bool trims,
                               EdgeCouplings& couplings) const {
    const bool nothing = components == std::array<bool, 3>{} && !rotation;
    if (points.empty() || nothing) {
        return;
    }
    const std::array<Stiffness, 2> sides = {stiffness(faces[0]), stiffness(faces[1])};
    // The softer patch decides: springs are stiff enough for it, and no stiffer.
    const Stiffness& softer = sides[sides[1].membrane < sides[0].membrane ? 1 : 0];
    if (method_ == EdgeMethod::penalty) {
        addPenalties(points, components, rotation,
                     {factor(EdgeMethod::penalty), softer.membrane, softer.bending}, couplings);
    } else if (method_ == EdgeMethod::nitsche && trims) {
        append(nitscheCouplings(points, components, rotation, description_.bending,
                                factor(EdgeMethod::nitsche)),
               couplings);
    } else {
        append(multiplierCouplings(points, components, rotation,
                                   {factor(EdgeMethod::lagrange), softer.membrane, softer.bending}),
               couplings);
        addTraceSprings(points, components, softer, couplings);
    }
}

void WeakConstraints::holdCreases(const ShellPatch& patch, int face,
                                  EdgeCouplings& couplings) const {
    const std::vector<EdgePoint> points = creasePoints(patch);
    const Stiffness own = stiffness(face);
    if (method_ == EdgeMethod::nitsche) {
        append(nitscheCouplings(points, {}, true, true, factor(EdgeMethod::nitsche)), couplings);
    } else {
        addPenalties(points, {}, true, {factor(method_), own.membrane, own.bending}, couplings);
    }
}

void WeakConstraints::holdPoint(const PatchLocation& place, const std::array<bool, 3>& components,
                                int face, EdgeCouplings& couplings) const {
    const double springs = factor(EdgeMethod::penalty);
    couplings.push_back(std::make_unique<DisplacementPenalty>(
        place, nullptr, components,
        springs * stiffness(face).membrane * Eigen::Matrix3d::Identity(),
        springs * place.patch->massPerArea() * elementArea(place)));
}

} // namespace tokay::structure
