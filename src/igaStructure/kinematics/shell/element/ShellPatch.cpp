// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"

#include "igaStructure/assembly/GeometryError.hpp"
#include "igaStructure/kinematics/shell/element/ShellElement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

namespace {

// Whether the tangents are continuous where a knot span begins.
bool isSmooth(const geometry::KnotVector& knots, int span) {
    return knots.multiplicity(knots.breakpoints()[span]) < knots.degree();
}

} // namespace

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
    const auto error = [&](const ShellElement& element, const std::string& what) {
        const Eigen::Vector3d x = element.position();
        return GeometryError(fmt::format("the surface of patch \"{}\" {} near ({:.6g}, {:.6g}, "
                                         "{:.6g}); check its control points",
                                         patch_.name(), what, x[0], x[1], x[2]));
    };
    constexpr double foldedOver = -0.9; // cosine of normals of neighbouring points
    std::vector<Eigen::Vector3d> lastNormals(patch_.nElements(), Eigen::Vector3d::Zero());
    ShellElement element;
    for (int number = 0; number < patch_.nElements(); ++number) {
        const int i = number % u_.nSpans();
        const int j = number / u_.nSpans();
        element.moveTo(*this, i, j);
        std::vector<Eigen::Vector3d> before; // normals nearby, where the surface is smooth
        if (i > 0 && isSmooth(surface().u(), i)) {
            before.push_back(lastNormals[number - 1]);
        }
        if (j > 0 && isSmooth(surface().v(), j)) {
            before.push_back(lastNormals[number - u_.nSpans()]);
        }
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const UnitNormal& normal = element.reference().normal;
            const double size = element.reference().derivatives.leftCols<2>().squaredNorm();
            if (!(normal.area() > 1e-14 * size)) {
                throw error(element,
                            fmt::format("is degenerate (its parameter lines meet at an angle whose "
                                        "sine is {:.2g}, or one of them has no length)",
                                        size > 0 ? 2 * normal.area() / size : 0));
            }
            for (const Eigen::Vector3d& other : before) {
                const double cosine = other.dot(normal.value());
                if (cosine < foldedOver) {
                    throw error(element,
                                fmt::format("folds over (its normal turns by {:.3g} degrees from "
                                            "one quadrature point to the next)",
                                            180 / M_PI * std::acos(std::max(-1.0, cosine))));
                }
            }
            before = {normal.value()};
            lastNormals[number] = normal.value();
        }
    }
}

} // namespace tokay::structure
