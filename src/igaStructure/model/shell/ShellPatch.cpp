#include "igaStructure/model/shell/ShellPatch.hpp"

#include "common/errors.hpp"
#include "igaStructure/model/shell/ShellElement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

ShellPatch::ShellPatch(geometry::TrimmedPatch patch, std::vector<int> nodes,
                       std::shared_ptr<const ShellSection> section, double massPerArea,
                       const geometry::QuadratureOptions& cutRule)
    : patch_(std::move(patch)), nodes_(std::move(nodes)), section_(std::move(section)),
      massPerArea_(massPerArea), u_(surface().u(), surface().u().degree() + 1, 2),
      v_(surface().v(), surface().v().degree() + 1, 2), cutPoints_(patch_.nElements()) {
    const geometry::PatchQuadrature quadrature(patch_, cutRule);
    for (int element : patch_.elements(geometry::ElementState::cut)) {
        for (const geometry::ParameterPoint& point : quadrature.points(element)) {
            cutPoints_[element].push_back(
                {point.xi, point.eta, point.weight, surface().basis(point.xi, point.eta, 2).N});
        }
    }
    requireRegular();
}

std::vector<int> ShellPatch::nodesOfRow(int row) const {
    std::vector<int> found;
    ShellElement element;
    for (int i = 0; i < u_.nSpans(); ++i) {
        if (patch_.state(patch_.elementNumber(i, row)) != geometry::ElementState::empty) {
            element.moveTo(*this, i, row);
            found.insert(found.end(), element.nodes().begin(), element.nodes().end());
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void ShellPatch::requireRegular() const {
    ShellElement element;
    for (int number = 0; number < patch_.nElements(); ++number) {
        element.moveTo(*this, number % u_.nSpans(), number / u_.nSpans());
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const double size = element.reference().derivatives.leftCols<2>().squaredNorm();
            if (!(element.reference().normal.area() > 1e-14 * size)) {
                const Eigen::Vector3d x = element.position();
                throw InputError(fmt::format(
                    "the surface of patch \"{}\" is degenerate near ({:.6g}, {:.6g}, {:.6g}): "
                    "its parameter lines are parallel there; check its control points",
                    patch_.name(), x[0], x[1], x[2]));
            }
        }
    }
}

} // namespace tokay::structure
