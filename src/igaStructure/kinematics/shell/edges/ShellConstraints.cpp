// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"

#include "common/errors.hpp"
#include "igaStructure/assembly/RigidMotions.hpp"
#include "igaStructure/kinematics/shell/edges/LagrangeSpring.hpp"
#include "igaStructure/kinematics/shell/edges/NitscheSpring.hpp"
#include "igaStructure/kinematics/shell/edges/SliverSpring.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace tokay::structure {

namespace {

constexpr double sameDirection = 1e-10;

// Control points of a side of a patch, and of the row next to it.
struct Rows {
    std::vector<int> rim, next;
};

Rows rowsAt(const ShellPatch& patch, geometry::Edge edge) {
    const geometry::NurbsSurface& surface = patch.surface();
    Rows rows{surface.boundaryCurve(edge).controlPoints, {}};
    const int nU = surface.u().nBasis();
    const int step = edge == geometry::Edge::left     ? 1
                     : edge == geometry::Edge::right  ? -1
                     : edge == geometry::Edge::bottom ? nU
                                                      : -nU;
    for (int k : rows.rim) {
        rows.next.push_back(k + step);
    }
    return rows;
}

// The axis of space along which all normals of an edge are.
std::optional<int> normalAxis(const std::vector<EdgePoint>& points) {
    for (int axis = 0; axis < 3; ++axis) {
        bool all = !points.empty();
        for (const EdgePoint& point : points) {
            all = all && std::abs(point.side.normal()[axis]) > 1 - sameDirection;
        }
        if (all) {
            return axis;
        }
    }
    return std::nullopt;
}

// Of a patch.
struct SideStiffness {
    double membrane; ///< E t / (1 - nu^2) [N/m]
    double bending;  ///< E t^3 / 12 / (1 - nu^2) [N m]; 0: a membrane
};

class ConstraintsBuilder {
  public:
    ConstraintsBuilder(const ShellDescription& description, const ShellPatches& patches, int nNodes)
        : description_(description), method_(description.chosenEdgeMethod()), patches_(patches) {
        requirePossible();
        constraints_.supported.assign(3 * nNodes, false);
    }

    ShellConstraints build() {
        for (const EdgeSupport& support : description_.edgeSupports) {
            for (const geometry::BrepTrim& trim : support.trims) {
                hold(support, trim);
            }
        }
        for (const PointSupport& support : description_.pointSupports) {
            hold(support);
        }
        for (const geometry::BrepEdge& edge : description_.model.edges()) {
            for (std::size_t k = 1; k < edge.trims.size(); ++k) {
                join(edge.trims[0], edge.trims[k]);
            }
        }
        for (std::size_t face = 0; face < patches_.size() && description_.bending; ++face) {
            holdCreases(static_cast<int>(face));
        }
        addSliverSprings();
        constraints_.fixed = constraints_.supported;
        fixNodesWithoutBody();
        return std::move(constraints_);
    }

  private:
    const ShellPatch& patchOf(const geometry::BrepTrim& trim) const { return *patches_[trim.face]; }
    const geometry::NurbsCurve& curveOf(const geometry::BrepTrim& trim) const {
        return description_.model.curve(trim.face, trim.curve);
    }
    SideStiffness stiffness(int face) const {
        const ShellMaterial& material = description_.materialOf(face);
        const double nu = material.poissonsRatio;
        const double t = description_.thickness[face];
        const double membrane = material.youngsModulus * t / (1 - nu * nu);
        return {membrane, description_.bending ? membrane * t * t / 12 : 0};
    }
    double factor(EdgeMethod method) const {
        const double usual = method == EdgeMethod::penalty    ? 1e3
                             : method == EdgeMethod::lagrange ? 1e6
                                                              : 1;
        return method_ == method ? description_.penalty.value_or(usual) : usual;
    }

    void requirePossible() const {
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

    void fix(const ShellPatch& patch, const std::vector<int>& controlPoints, int component) {
        for (int k : controlPoints) {
            constraints_.supported[3 * patch.nodes()[k] + component] = true;
        }
    }

    void hold(const EdgeSupport& support, const geometry::BrepTrim& trim) {
        const ShellPatch& patch = patchOf(trim);
        const std::vector<EdgePoint> points = edgePoints(patch, curveOf(trim));
        const auto side = rimOf(curveOf(trim), patch.surface());
        const bool exact = side && !support.weak;
        if (exact) {
            for (int c = 0; c < 3; ++c) {
                if (support.fixed[c]) {
                    fix(patch, rowsAt(patch, *side).rim, c);
                }
            }
        }
        bool clamped = support.clamped && description_.bending;
        const std::optional<int> axis = normalAxis(points);
        if (clamped && exact && axis && support.fixed[*axis]) {
            fix(patch, rowsAt(patch, *side).next, *axis);
            clamped = false;
        }
        const bool trims = trim.curve < nTrimmingCurves(patch.patch());
        holdWeakly(points, exact ? std::array<bool, 3>{} : support.fixed, clamped,
                   {trim.face, trim.face}, trims);
    }

    void hold(const PointSupport& support) {
        const ShellPatch& patch = *patches_[support.face];
        const PatchPlace place(patch, support.at, Eigen::Vector2d::Zero());
        Eigen::Index k = 0;
        const bool interpolates = place.N.row(0).maxCoeff(&k) > 1 - 1e-12;
        for (int c = 0; c < 3 && interpolates; ++c) {
            if (support.fixed[c]) {
                constraints_.supported[3 * place.nodes[k] + c] = true;
            }
        }
        if (!interpolates) {
            constraints_.springs.push_back(std::make_unique<DisplacementSpring>(
                place, nullptr, support.fixed,
                factor(EdgeMethod::penalty) * stiffness(support.face).membrane *
                    Eigen::Matrix3d::Identity()));
        }
    }

    void join(const geometry::BrepTrim& first, const geometry::BrepTrim& second) {
        const double gap =
            std::max(description_.model.tolerance(), 1e-3 * description_.model.size());
        const std::vector<EdgePoint> points =
            edgePoints(patchOf(first), curveOf(first), patchOf(second), curveOf(second), gap);
        const bool trims = first.curve < nTrimmingCurves(patchOf(first).patch()) &&
                           second.curve < nTrimmingCurves(patchOf(second).patch());
        holdWeakly(points, {true, true, true}, description_.bending, {first.face, second.face},
                   trims);
        ++constraints_.nJoints;
    }

    // Both sides have the same functions along a crease, so springs at its points ask
    // for no more than these can do.
    void holdCreases(int face) {
        const std::vector<EdgePoint> points = creasePoints(*patches_[face]);
        const SideStiffness own = stiffness(face);
        if (method_ == EdgeMethod::nitsche) {
            append(nitscheSprings(points, {}, true, true, factor(EdgeMethod::nitsche)));
        } else {
            addPenaltySprings(points, {}, true, {factor(method_), own.membrane, own.bending});
        }
    }

    static int nTrimmingCurves(const geometry::TrimmedPatch& patch) {
        std::size_t count = 0;
        for (const geometry::TrimmingLoop& loop : patch.loops()) {
            count += loop.curves().size();
        }
        return static_cast<int>(count);
    }

    // Across an edge inside of a patch tractions jump, so Nitsche's method has none to
    // take there.
    void holdWeakly(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                    bool rotation, const std::array<int, 2>& faces, bool trims) {
        const bool nothing = components == std::array<bool, 3>{} && !rotation;
        if (points.empty() || nothing) {
            return;
        }
        const std::array<SideStiffness, 2> sides = {stiffness(faces[0]), stiffness(faces[1])};
        // The softer patch decides: springs are stiff enough for it, and no stiffer.
        const SideStiffness& softer = sides[sides[1].membrane < sides[0].membrane ? 1 : 0];
        if (method_ == EdgeMethod::penalty) {
            addPenaltySprings(points, components, rotation,
                              {factor(EdgeMethod::penalty), softer.membrane, softer.bending});
        } else if (method_ == EdgeMethod::nitsche && trims) {
            append(nitscheSprings(points, components, rotation, description_.bending,
                                  factor(EdgeMethod::nitsche)));
        } else {
            append(
                lagrangeSprings(points, components, rotation,
                                {factor(EdgeMethod::lagrange), softer.membrane, softer.bending}));
        }
    }

    void addPenaltySprings(const std::vector<EdgePoint>& points,
                           const std::array<bool, 3>& components, bool rotation,
                           const SpringStiffness& stiffness) {
        for (const EdgePoint& point : points) {
            const PatchPlace* other = point.other ? &*point.other : nullptr;
            if (components != std::array<bool, 3>{}) {
                constraints_.springs.push_back(std::make_unique<DisplacementSpring>(
                    point.side, other, components,
                    point.weight * stiffness.ofAnyDisplacement(point) *
                        Eigen::Matrix3d::Identity()));
            }
            if (rotation) {
                constraints_.springs.push_back(std::make_unique<RotationSpring>(
                    point.side, other, point.weight * stiffness.ofRotation(point)));
            }
        }
    }

    void addSliverSprings() {
        for (std::size_t face = 0; face < patches_.size(); ++face) {
            if (description_.sliverTreatment == SliverTreatment::extension) {
                const SideStiffness own = stiffness(static_cast<int>(face));
                append(sliverSprings(*patches_[face], own.membrane, own.bending));
            }
        }
    }

    void append(std::vector<std::unique_ptr<EdgeSpring>> springs) {
        std::move(springs.begin(), springs.end(), std::back_inserter(constraints_.springs));
    }

    void fixNodesWithoutBody() {
        std::vector<bool> hasBody(constraints_.fixed.size() / 3, false);
        for (const auto& patch : patches_) {
            for (int j = 0; j < patch->v().nSpans(); ++j) {
                for (int node : patch->nodesOfRow(j)) {
                    hasBody[node] = true;
                }
            }
        }
        for (std::size_t k = 0; k < constraints_.fixed.size(); ++k) {
            constraints_.fixed[k] = constraints_.fixed[k] || !hasBody[k / 3];
        }
    }

    const ShellDescription& description_;
    const EdgeMethod method_;
    const ShellPatches& patches_;
    ShellConstraints constraints_;
};

} // namespace

ShellConstraints shellConstraints(const ShellDescription& description, const ShellPatches& patches,
                                  int nNodes) {
    return ConstraintsBuilder(description, patches, nNodes).build();
}

std::vector<std::string> freeRigidMotions(const geometry::Points& nodes,
                                          const ShellConstraints& constraints) {
    RigidMotions motions(nodes);
    for (std::size_t k = 0; k < constraints.supported.size(); ++k) {
        if (constraints.supported[k]) {
            motions.hold(motions.at(nodes.row(static_cast<Eigen::Index>(k / 3)))
                             .row(static_cast<Eigen::Index>(k % 3)));
        }
    }
    for (const auto& spring : constraints.springs) {
        const Eigen::MatrixXd rows = spring->restRows();
        Eigen::MatrixXd own(rows.cols(), 6);
        for (std::size_t k = 0; k < spring->nodes().size(); ++k) {
            own.middleRows<3>(3 * static_cast<Eigen::Index>(k)) =
                motions.at(nodes.row(spring->nodes()[k]));
        }
        motions.hold(rows * own / std::sqrt(1e-300 + rows.squaredNorm()));
    }
    return motions.freeOnes();
}

} // namespace tokay::structure
