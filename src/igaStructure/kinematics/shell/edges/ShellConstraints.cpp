// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"

#include "common/errors.hpp"
#include "igaStructure/kinematics/curvePoints.hpp"
#include "igaStructure/kinematics/shell/edges/GhostStabilisation.hpp"
#include "igaStructure/kinematics/shell/edges/WeakConstraints.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

class ConstraintsBuilder {
  public:
    ConstraintsBuilder(const ShellDescription& description, const ShellPatches& patches, int nNodes)
        : description_(description), patches_(patches), weak_(description) {
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
            weak_.holdCreases(*patches_[face], static_cast<int>(face), constraints_.couplings);
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
        weak_.holdEdge(points, exact ? std::array<bool, 3>{} : support.fixed, clamped,
                       {trim.face, trim.face}, trims, constraints_.couplings);
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
            weak_.holdEdge(points, {}, true, {trim.face, trim.face}, true, constraints_.couplings);
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
            weak_.holdPoint(place, support.fixed, support.face, constraints_.couplings);
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
        weak_.holdEdge(points, {true, true, true}, description_.bending, {first.face, second.face},
                       trims, constraints_.couplings);
        ++constraints_.nJoints;
    }

    static int nTrimmingCurves(const geometry::TrimmedPatch& patch) {
        std::size_t count = 0;
        for (const geometry::TrimmingLoop& loop : patch.loops()) {
            count += loop.curves().size();
        }
        return static_cast<int>(count);
    }

    void addGhostStabilisations() {
        for (std::size_t face = 0; face < patches_.size(); ++face) {
            if (description_.sliverTreatment == SliverTreatment::extension) {
                const WeakConstraints::Stiffness own = weak_.stiffness(static_cast<int>(face));
                const auto isTied = [&](int element) {
                    return extended_.count({static_cast<int>(face), element}) == 0;
                };
                append(ghostStabilisations(*patches_[face], own.membrane, own.bending, isTied),
                       constraints_.couplings);
            }
        }
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
    const ShellPatches& patches_;
    const WeakConstraints weak_;
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

} // namespace tokay::structure
