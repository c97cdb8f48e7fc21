#include "igaStructure/model/shell/CutFractions.hpp"

#include <algorithm>
#include <cstdlib>

namespace tokay::structure {

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
            if (worth(k, l) > most) {
                most = worth(k, l);
                best = trimmed.elementNumber(k, l);
            }
        }
    }
    return best;
}

} // namespace tokay::structure
