// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/ExtendedElements.hpp"

#include "common/errors.hpp"
#include "igaStructure/kinematics/shell/element/ShellElement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using geometry::ElementState;

namespace {

std::string nameOf(const TrimmedSupport& support, const geometry::BrepModel& model) {
    for (const geometry::BrepEdge& edge : model.edges()) {
        for (const geometry::BrepTrim& trim : edge.trims) {
            if (trim.face == support.trim.face && trim.curve == support.trim.curve) {
                return fmt::format("edge \"{}\"", edge.name);
            }
        }
    }
    return fmt::format("curve {} of patch \"{}\"", support.trim.curve,
                       model.patch(support.trim.face).name());
}

std::vector<int> nodesOf(const ShellPatch& patch, int element) {
    ShellElement here;
    here.moveTo(patch, element % patch.u().nSpans(), element / patch.u().nSpans());
    return here.nodes();
}

// The element at a point of a trimming curve, or if that is trimmed away the one that the
// curve bounds on its left; -1: none.
int elementWithBody(const geometry::TrimmedPatch& patch, const EdgePoint& point) {
    if (patch.state(point.side.element) != ElementState::empty) {
        return point.side.element;
    }
    constexpr double aside = 1e-6; // of an element
    const geometry::Parameters inside =
        point.side.parameters - aside * point.side.size * point.side.conormal();
    const int element = patch.elementAt(inside);
    return patch.state(element) == ElementState::empty ? -1 : element;
}

} // namespace

ExtendedElements::ExtendedElements(const ShellDescription& description, const ShellPatches& patches,
                                   const std::vector<TrimmedSupport>& supports,
                                   const std::vector<bool>& fixed)
    : description_(description), patches_(patches), isDependent_(fixed.size(), false) {
    for (const auto& patch : patches) {
        cut_.emplace_back(patch->patch().nElements(), Components{});
        nodes_.emplace_back();
        for (int element = 0; element < patch->patch().nElements(); ++element) {
            nodes_.back().push_back(nodesOf(*patch, element));
        }
    }
    for (const TrimmedSupport& support : supports) {
        requireLargeLoops(support);
        addTrace(support);
    }
    markDependents(fixed);
    requireInterior(supports, fixed);
}

void ExtendedElements::addTrace(const TrimmedSupport& support) {
    const ShellPatch& patch = *patches_[support.trim.face];
    const std::size_t before = trace_.size();
    for (const EdgePoint& point : support.points) {
        const int element = elementWithBody(patch.patch(), point);
        if (element < 0) {
            continue;
        }
        trace_.push_back({&support, point, element});
        for (int c = 0; c < 3; ++c) {
            Components& cut = cut_[support.trim.face][element];
            cut[c] = cut[c] || support.fixed[c];
        }
    }
    if (trace_.size() == before) {
        throw InputError(fmt::format("supports: {} cannot be supported by edgeMethod egm: no "
                                     "element of its patch reaches it; correct its curve, or "
                                     "remove the support",
                                     nameOf(support, description_.model)));
    }
}

void ExtendedElements::markDependents(const std::vector<bool>& fixed) {
    for (std::size_t face = 0; face < cut_.size(); ++face) {
        for (std::size_t element = 0; element < cut_[face].size(); ++element) {
            for (const int node : nodes_[face][element]) {
                for (int c = 0; c < 3; ++c) {
                    const std::size_t unknown = 3 * static_cast<std::size_t>(node) + c;
                    isDependent_[unknown] =
                        isDependent_[unknown] || (cut_[face][element][c] && !fixed[unknown]);
                }
            }
        }
    }
    for (std::size_t unknown = 0; unknown < isDependent_.size(); ++unknown) {
        if (isDependent_[unknown]) {
            dependents_.push_back(static_cast<int>(unknown));
        }
    }
}

// A hole within an element: one polynomial cannot follow what happens around it.
void ExtendedElements::requireLargeLoops(const TrimmedSupport& support) const {
    const geometry::TrimmedPatch& patch = patches_[support.trim.face]->patch();
    int curve = support.trim.curve;
    for (const geometry::TrimmingLoop& loop : patch.loops()) {
        const int nCurves = static_cast<int>(loop.curves().size());
        if (curve < nCurves && loop.kind() == geometry::LoopKind::inner) {
            const geometry::ParameterBox element =
                patch.elementBox(patch.elementAt(loop.box().centre()));
            const Eigen::Vector2d ratio = loop.box().size().cwiseQuotient(element.size());
            if (ratio.maxCoeff() < 1) {
                throw InputError(fmt::format(
                    "supports: {} belongs to a loop of {:.3g} x {:.3g} elements; edgeMethod egm "
                    "needs a loop larger than an element: take at least {} times as many "
                    "elements, or another edgeMethod",
                    nameOf(support, description_.model), ratio[0], ratio[1],
                    static_cast<int>(std::ceil(2 / ratio.maxCoeff()))));
            }
        }
        curve -= nCurves;
        if (curve < 0) {
            return;
        }
    }
}

void ExtendedElements::requireInterior(const std::vector<TrimmedSupport>& supports,
                                       const std::vector<bool>& fixed) const {
    for (const TrimmedSupport& support : supports) {
        const int face = support.trim.face;
        int nUncut = 0;
        bool hasFree = false;
        for (int element = 0; element < patches_[face]->patch().nElements(); ++element) {
            const Components& cut = cut_[face][element];
            if (!hasBody(face, element) || cut[0] || cut[1] || cut[2]) {
                continue;
            }
            ++nUncut;
            for (const int node : nodes_[face][element]) {
                for (int c = 0; c < 3; ++c) {
                    const std::size_t unknown = 3 * static_cast<std::size_t>(node) + c;
                    hasFree =
                        hasFree || (support.fixed[c] && !fixed[unknown] && !isDependent_[unknown]);
                }
            }
        }
        if (!hasFree) {
            throw InputError(fmt::format(
                "supports: next to {} the {} element{} of patch \"{}\" that no supported curve "
                "cuts do not suffice to extend the displacement from (edgeMethod egm): refine "
                "discretisation.elements",
                nameOf(support, description_.model), nUncut, nUncut == 1 ? "" : "s",
                patches_[face]->patch().name()));
        }
    }
}

ExtendedElements::Components ExtendedElements::dependsIn(int face, int element) const {
    Components depends{};
    for (const int node : nodes_[face][element]) {
        for (int c = 0; c < 3; ++c) {
            depends[c] = depends[c] || isDependent_[3 * static_cast<std::size_t>(node) + c];
        }
    }
    return depends;
}

bool ExtendedElements::hasBody(int face, int element) const {
    return patches_[face]->patch().state(element) != ElementState::empty;
}

} // namespace tokay::structure
