// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/CutFractions.hpp"

#include "igaStructure/kinematics/shell/edges/EdgePoint.hpp"

#include <algorithm>
#include <cstdlib>

namespace tokay::structure {

namespace {

geometry::Point positionFrom(const ShellPatch& patch, int element, const geometry::Parameters& at) {
    const int nU = patch.patch().nElementsU();
    return PatchLocation(patch, element % nU, element / nU, at, Eigen::Vector2d::Zero()).position;
}

// Whether the surface of one element is that of another one, continued.
bool continues(const ShellPatch& patch, int element, int other) {
    constexpr double rounding = 1e-10; // of the element's diagonal
    const geometry::ParameterBox box = patch.patch().elementBox(element);
    const geometry::Point lower = positionFrom(patch, element, box.lower);
    const geometry::Point upper = positionFrom(patch, element, box.upper);
    const double largest = rounding * (upper - lower).norm();
    return (positionFrom(patch, other, box.lower) - lower).norm() <= largest &&
           (positionFrom(patch, other, box.upper) - upper).norm() <= largest;
}

} // namespace

CutFractions::CutFractions(const ShellPatch& patch)
    : patch_(&patch), fractions_(patch.patch().nElements(), 0.0) {
    const geometry::TrimmedPatch& trimmed = patch.patch();
    for (int element = 0; element < trimmed.nElements(); ++element) {
        if (trimmed.state(element) == geometry::ElementState::full) {
            fractions_[element] = 1;
        }
        const double whole = trimmed.elementBox(element).area();
        for (const ShellPatch::CutPoint& point : patch.cutPoints(element)) {
            fractions_[element] += point.weight / whole;
        }
    }
}

int CutFractions::standIn(int element) const {
    if (!isSliver(element)) {
        return element;
    }
    const geometry::TrimmedPatch& trimmed = patch_->patch();
    const int nU = trimmed.nElementsU();
    const int i = element % nU;
    const int j = element / nU;
    int best = element;
    // Across a side extrapolation is shorter than across a corner.
    const auto worth = [&](int k, int l) {
        const double far = std::abs(k - i) + std::abs(l - j) > 1 ? 0.5 : 1;
        return far * fractions_[trimmed.elementNumber(k, l)];
    };
    double most = fractions_[element];
    for (int l = std::max(j - 1, 0); l <= std::min(j + 1, trimmed.nElementsV() - 1); ++l) {
        for (int k = std::max(i - 1, 0); k <= std::min(i + 1, nU - 1); ++k) {
            const int other = trimmed.elementNumber(k, l);
            if (worth(k, l) > most && continues(*patch_, element, other)) {
                most = worth(k, l);
                best = other;
            }
        }
    }
    return best;
}

} // namespace tokay::structure
