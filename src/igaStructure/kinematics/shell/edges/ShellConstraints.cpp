// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"

#include "common/errors.hpp"
#include "igaStructure/assembly/RigidMotions.hpp"
#include "igaStructure/kinematics/curvePoints.hpp"
#include "igaStructure/kinematics/shell/edges/GhostStabilisation.hpp"
#include "igaStructure/kinematics/shell/edges/MultiplierCoupling.hpp"
#include "igaStructure/kinematics/shell/edges/NitscheCoupling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace tokay::structure {

namespace {

constexpr double sameDirection = 1e-10;
constexpr double sameNormal = 1e-6; // sine of an angle to a plane of space

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
        : description_(description), method_(description.weakEdgeMethod()), patches_(patches) {
        requirePossible();
        atRest_.assign(3 * nNodes, false);
        for (int node = 0; description.isPlane && node < nNodes; ++node) {
            atRest_[3 * node + 2] = true;
        }
        moving_ = atRest_;
    }

    ShellConstraints build() {
        for (const EdgeSupport& support : description_.edgeSupports) {
            for (const geometry::BrepTrim& trim : support.trims) {
                hold(support, trim);
            }
            ownTheRest();
        }
        for (const PointSupport& support : description_.pointSupports) {
            hold(support);
            ownTheRest();
        }
        constraints_.owners.resize(moving_.size(), -1);
        for (const geometry::BrepEdge& edge : description_.model.edges()) {
            for (std::size_t k = 1; k < edge.trims.size(); ++k) {
                join(edge.trims[0], edge.trims[k]);
            }
        }
        for (std::size_t face = 0; face < patches_.size() && description_.bending; ++face) {
            holdCreases(static_cast<int>(face));
        }
        addGhostStabilisations();
        constraints_.supported = atRest_;
        for (std::size_t k = 0; k < moving_.size(); ++k) {
            constraints_.supported[k] = atRest_[k] || moving_[k];
        }
        constraints_.trace = {std::move(points_), movingOnly(moving_, atRest_), 3};
        constraints_.couplingOwners.resize(constraints_.couplings.size(), -1);
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
        const double t = description_.thickness[face];
        const double membrane = description_.materialOf(face).planeStressModulus() * t;
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

    // What has been held since the last support is this one's.
    void ownTheRest() {
        addOwner(constraints_.owners, atRest_, nSupports_);
        addOwner(constraints_.owners, moving_, nSupports_);
        constraints_.couplingOwners.resize(constraints_.couplings.size(), nSupports_);
        ++nSupports_;
    }

    void fix(const ShellPatch& patch, const std::vector<int>& controlPoints, int component,
             const SupportMotion& motion) {
        for (int k : controlPoints) {
            (motion ? moving_ : atRest_)[3 * patch.nodes()[k] + component] = true;
        }
    }

    // The rim follows the motion; where it is clamped across an axis, so does the next row.
    void follow(const ShellPatch& patch, const std::vector<EdgePoint>& points,
                const std::array<bool, 3>& components, const SupportMotion& motion,
                const Rows& rows, std::optional<int> clampedAxis) {
        for (const EdgePoint& point : points) {
            points_.push_back({point.side.nodes, point.side.N.row(0), point.weight,
                               point.side.position, components, motion});
        }
        for (std::size_t k = 0; points.empty() && k < rows.rim.size(); ++k) { // a pole
            points_.push_back({{patch.nodes()[rows.rim[k]]},
                               Eigen::VectorXd::Ones(1),
                               1,
                               patch.surface().controlPoints().row(rows.rim[k]),
                               components,
                               motion});
        }
        if (!clampedAxis) {
            return;
        }
        std::map<int, int> nextOf;
        for (std::size_t k = 0; k < rows.rim.size(); ++k) {
            nextOf[patch.nodes()[rows.rim[k]]] = patch.nodes()[rows.next[k]];
        }
        std::array<bool, 3> across = {};
        across[*clampedAxis] = true;
        for (const EdgePoint& point : points) {
            SupportPoint next{{},    point.side.N.row(0), point.weight, point.side.position, across,
                              motion};
            for (std::size_t k = 0; k < point.side.nodes.size(); ++k) {
                const auto found = nextOf.find(point.side.nodes[k]);
                next.nodes.push_back(found == nextOf.end() ? point.side.nodes[k] : found->second);
                next.N[static_cast<Eigen::Index>(k)] *= found == nextOf.end() ? 0 : 1;
            }
            points_.push_back(std::move(next));
        }
    }

    void hold(const EdgeSupport& support, const geometry::BrepTrim& trim) {
        const ShellPatch& patch = patchOf(trim);
        const std::vector<EdgePoint> points = edgePoints(patch, curveOf(trim));
        const auto side = rimOf(curveOf(trim), patch.surface());
        const bool exact = side && !support.weak;
        const bool trims = trim.curve < nTrimmingCurves(patch.patch());
        if (description_.chosenEdgeMethod() == EdgeMethod::egm && !exact && !support.weak &&
            trims) {
            holdByExtension(support, trim, points);
            return;
        }
        if (exact) {
            for (int c = 0; c < 3; ++c) {
                if (support.fixed[c]) {
                    fix(patch, rowsAt(patch, *side).rim, c, support.motion);
                }
            }
        }
        bool clamped = support.clamped && description_.bending;
        std::optional<int> clampedAxis;
        const std::optional<int> axis = normalAxis(points);
        if (clamped && exact && axis && support.fixed[*axis]) {
            fix(patch, rowsAt(patch, *side).next, *axis, support.motion);
            clamped = false;
            clampedAxis = axis;
        }
        if (exact && support.motion) {
            follow(patch, points, support.fixed, support.motion, rowsAt(patch, *side), clampedAxis);
        }
        const std::size_t first = constraints_.couplings.size();
        holdWeakly(points, exact ? std::array<bool, 3>{} : support.fixed, clamped,
                   {trim.face, trim.face}, trims);
        if (!exact) {
            move(first, support.motion);
        }
    }

    // Couplings from a number on.
    void move(std::size_t first, const SupportMotion& motion) {
        for (std::size_t k = first; motion && k < constraints_.couplings.size(); ++k) {
            constraints_.moved.push_back({k, motion});
        }
    }

    // The two conditions at an edge of a plate go with its deflection; without it the
    // rotation is held as usual.
    void holdByExtension(const EdgeSupport& support, const geometry::BrepTrim& trim,
                         const std::vector<EdgePoint>& points) {
        const bool deflection = holdsDeflection(support.fixed, points);
        if (description_.bending) {
            requireTwoConditions(support, trim, deflection, points);
        }
        constraints_.trimmedSupports.push_back({trim, support.fixed,
                                                support.clamped && description_.bending,
                                                support.motion, nSupports_, points});
        for (const EdgePoint& point : points) {
            if (support.fixed[0] && support.fixed[1] &&
                (support.fixed[2] || description_.isPlane)) {
                extended_.emplace(trim.face, point.side.element);
            }
        }
        if (support.clamped && description_.bending && !deflection) {
            holdWeakly(points, {}, true, {trim.face, trim.face}, true);
        }
    }

    static bool holdsDeflection(const std::array<bool, 3>& fixed,
                                const std::vector<EdgePoint>& points) {
        return std::all_of(points.begin(), points.end(), [&](const EdgePoint& point) {
            const Eigen::Vector3d normal = point.side.normal();
            for (int c = 0; c < 3; ++c) {
                if (!fixed[c] && std::abs(normal[c]) > sameNormal) {
                    return false;
                }
            }
            return true;
        });
    }

    void requireTwoConditions(const EdgeSupport& support, const geometry::BrepTrim& trim,
                              bool deflection, const std::vector<EdgePoint>& points) const {
        bool touches = false;
        for (const EdgePoint& point : points) {
            for (int c = 0; c < 3; ++c) {
                touches =
                    touches || (support.fixed[c] && std::abs(point.side.normal()[c]) > sameNormal);
            }
        }
        if (touches && !deflection) {
            throw InputError("supports: edgeMethod egm holds a part of the deflection of a curved "
                             "shell's trimmed edge only together with all of it: fix x, y and z, "
                             "or take another edgeMethod");
        }
        if (deflection && !support.clamped && description_.strains == Strains::nonlinear) {
            throw InputError("supports: edgeMethod egm cannot leave a shell with nonlinear "
                             "strains free to turn about a trimmed edge: fix rotation too, or "
                             "take another edgeMethod");
        }
        for (const ShellLoads::EdgeMoment& load : description_.loads.edgeMoments) {
            if (deflection && load.trim.face == trim.face && load.trim.curve == trim.curve) {
                throw InputError("loads: lineMoment acts on an edge that edgeMethod egm supports: "
                                 "take another edgeMethod");
            }
        }
    }

    void hold(const PointSupport& support) {
        const ShellPatch& patch = *patches_[support.face];
        const PatchLocation place(patch, support.at, Eigen::Vector2d::Zero());
        Eigen::Index k = 0;
        const bool interpolates = place.N.row(0).maxCoeff(&k) > 1 - 1e-12;
        for (int c = 0; c < 3 && interpolates; ++c) {
            if (support.fixed[c]) {
                (support.motion ? moving_ : atRest_)[3 * place.nodes[k] + c] = true;
            }
        }
        if (interpolates && support.motion) {
            points_.push_back(
                {place.nodes, place.N.row(0), 1, place.position, support.fixed, support.motion});
        }
        if (!interpolates) {
            const std::size_t first = constraints_.couplings.size();
            constraints_.couplings.push_back(std::make_unique<DisplacementPenalty>(
                place, nullptr, support.fixed,
                factor(EdgeMethod::penalty) * stiffness(support.face).membrane *
                    Eigen::Matrix3d::Identity()));
            move(first, support.motion);
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
            append(nitscheCouplings(points, {}, true, true, factor(EdgeMethod::nitsche)));
        } else {
            addPenalties(points, {}, true, {factor(method_), own.membrane, own.bending});
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
            addPenalties(points, components, rotation,
                         {factor(EdgeMethod::penalty), softer.membrane, softer.bending});
        } else if (method_ == EdgeMethod::nitsche && trims) {
            append(nitscheCouplings(points, components, rotation, description_.bending,
                                    factor(EdgeMethod::nitsche)));
        } else {
            append(multiplierCouplings(
                points, components, rotation,
                {factor(EdgeMethod::lagrange), softer.membrane, softer.bending}));
            addTraceSprings(points, components, softer);
        }
    }

    void addPenalties(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                      bool rotation, const PenaltyStiffness& stiffness) {
        for (const EdgePoint& point : points) {
            const PatchLocation* other = point.other ? &*point.other : nullptr;
            if (components != std::array<bool, 3>{}) {
                constraints_.couplings.push_back(std::make_unique<DisplacementPenalty>(
                    point.side, other, components,
                    point.weight * stiffness.ofAnyDisplacement(point) *
                        Eigen::Matrix3d::Identity()));
            }
            if (rotation) {
                constraints_.couplings.push_back(std::make_unique<RotationPenalty>(
                    point.side, other, point.weight * stiffness.ofRotation(point)));
            }
        }
    }

    // What multipliers do not see of a trace: they hold its moments with fewer functions than
    // it has. Springs as stiff as some elements hold that too, and ask for nothing that the
    // solution does not fulfil; across the surface they scale with its bending, so a thin
    // shell does not lock.
    void addTraceSprings(const std::vector<EdgePoint>& points,
                         const std::array<bool, 3>& components, const SideStiffness& side) {
        if (components == std::array<bool, 3>{}) {
            return;
        }
        constexpr double elements = 10; // benchmarks/shells: from 100 on a coarse mesh locks
        const PenaltyStiffness springs = {elements, side.membrane, side.bending};
        for (const EdgePoint& point : points) {
            constraints_.couplings.push_back(std::make_unique<DisplacementPenalty>(
                point.side, point.other ? &*point.other : nullptr, components,
                point.weight * springs.ofDisplacement(point)));
        }
    }

    void addGhostStabilisations() {
        for (std::size_t face = 0; face < patches_.size(); ++face) {
            if (description_.sliverTreatment == SliverTreatment::extension) {
                const SideStiffness own = stiffness(static_cast<int>(face));
                const auto isTied = [&](int element) {
                    return extended_.count({static_cast<int>(face), element}) == 0;
                };
                append(ghostStabilisations(*patches_[face], own.membrane, own.bending, isTied));
            }
        }
    }

    void append(std::vector<std::unique_ptr<EdgeCoupling>> couplings) {
        std::move(couplings.begin(), couplings.end(), std::back_inserter(constraints_.couplings));
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
    /// Elements (face, number) none of whose functions equilibrium decides.
    std::set<std::pair<int, int>> extended_;
    ShellConstraints constraints_;
    int nSupports_ = 0;
    std::vector<bool> atRest_, moving_; ///< unknowns that supports hold
    std::vector<SupportPoint> points_;  ///< of exact supports that move
};

} // namespace

ShellConstraints shellConstraints(const ShellDescription& description, const ShellPatches& patches,
                                  int nNodes) {
    return ConstraintsBuilder(description, patches, nNodes).build();
}

namespace {

// What the support of an edge holds, if it belongs to a part of the shell.
void holdEdge(const TrimmedSupport& support, const std::vector<int>& nodes, RigidMotions& motions) {
    for (const EdgePoint& point : support.points) {
        const PatchLocation& at = point.side;
        if (!std::binary_search(nodes.begin(), nodes.end(), at.nodes.front())) {
            continue;
        }
        for (int c = 0; c < 3; ++c) {
            if (support.fixed[c]) {
                motions.holdPoint(at.position, Eigen::Vector3d::Unit(c));
            }
        }
        if (support.clamped) {
            motions.holdRotation((at.baseVectors * at.tangent).normalized());
        }
    }
}

} // namespace

std::vector<std::string> freeRigidMotions(const geometry::Points& positions,
                                          const ShellConstraints& constraints,
                                          const std::vector<int>& nodes) {
    RigidMotions motions(positions(nodes, Eigen::all));
    for (const int node : nodes) {
        for (int c = 0; c < 3; ++c) {
            if (constraints.supported[3 * static_cast<std::size_t>(node) + c]) {
                motions.hold(motions.at(positions.row(node)).row(c));
            }
        }
    }
    for (const auto& coupling : constraints.couplings) {
        if (!std::binary_search(nodes.begin(), nodes.end(), coupling->nodes().front())) {
            continue;
        }
        const Eigen::MatrixXd rows = coupling->restRows();
        Eigen::MatrixXd own(rows.cols(), 6);
        for (std::size_t k = 0; k < coupling->nodes().size(); ++k) {
            own.middleRows<3>(3 * static_cast<Eigen::Index>(k)) =
                motions.at(positions.row(coupling->nodes()[k]));
        }
        motions.hold(rows * own / std::sqrt(1e-300 + rows.squaredNorm()));
    }
    for (const TrimmedSupport& support : constraints.trimmedSupports) {
        holdEdge(support, nodes, motions);
    }
    return motions.freeOnes();
}

std::vector<ShellPart> shellParts(const geometry::BrepModel& model) {
    std::vector<int> first(model.faces().size()); // face of the part
    std::iota(first.begin(), first.end(), 0);
    for (const geometry::BrepEdge& edge : model.edges()) {
        for (const geometry::BrepTrim& trim : edge.trims) {
            const int from = std::max(first[trim.face], first[edge.trims[0].face]);
            const int to = std::min(first[trim.face], first[edge.trims[0].face]);
            std::replace(first.begin(), first.end(), from, to);
        }
    }
    std::vector<ShellPart> parts;
    for (std::size_t k = 0; k < first.size(); ++k) {
        if (first[k] == static_cast<int>(k)) {
            parts.emplace_back();
        }
    }
    std::map<int, std::size_t> partOf;
    for (std::size_t face = 0; face < first.size(); ++face) {
        const std::size_t part = partOf.try_emplace(first[face], partOf.size()).first->second;
        parts[part].faces.push_back(static_cast<int>(face));
    }
    for (ShellPart& part : parts) {
        constexpr std::size_t nNamed = 5;
        std::vector<std::string> names;
        for (std::size_t k = 0; k < std::min(nNamed, part.faces.size()); ++k) {
            names.push_back(model.patch(part.faces[k]).name());
        }
        part.name = fmt::format(
            "patch{} {}{}", part.faces.size() == 1 ? "" : "es", fmt::join(names, ", "),
            part.faces.size() > nNamed ? fmt::format(" and {} more", part.faces.size() - nNamed)
                                       : "");
    }
    return parts;
}

} // namespace tokay::structure
