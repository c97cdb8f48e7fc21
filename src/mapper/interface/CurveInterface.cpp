// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/CurveInterface.hpp"

#include "common/errors.hpp"
#include "geometry/projection/ClosestCandidate.hpp"

#include <fmt/format.h>

namespace tokay::mapper {

CurveInterface::CurveInterface(std::vector<std::unique_ptr<InterfaceCurve>> curves,
                               Points coordinates)
    : curves_(std::move(curves)), coordinates_(std::move(coordinates)) {
    if (curves_.empty()) {
        throw InputError("the interface has no piece: name at least one edge");
    }
    std::vector<geometry::Box> boxes;
    geometry::Box all = geometry::Box::empty();
    for (const auto& curve : curves_) {
        boxes.push_back(curve->box());
        all.include(boxes.back());
    }
    size_ = all.diagonal();
    tree_ = std::make_unique<geometry::BoxTree>(boxes);
}

CurveInterface::Projection CurveInterface::closest(const Point& point) const {
    geometry::ClosestCandidate candidate(size_);
    Projection best{};
    bool isAmbiguous = false;
    tree_->visitNearest(point, [&](int i) {
        const geometry::CurveProjection found = curves_[i]->closest(point);
        const Point place = curves_[i]->derivatives(found.xi, 0).row(0);
        if (candidate.offer(place - point)) {
            best = {i, found};
            isAmbiguous = found.ambiguous;
        }
        return candidate.squaredLimit();
    });
    best.onCurve.ambiguous = isAmbiguous || candidate.isAmbiguous();
    return best;
}

Location CurveInterface::locate(const Point& point) const {
    const Projection found = closest(point);
    return {curves_[found.piece]->functions(found.onCurve.xi), found.onCurve.distance,
            found.onCurve.converged, found.onCurve.ambiguous};
}

CurveInterface lineMesh(const Points& vertices, const std::vector<std::array<int, 2>>& elements,
                        ValuesAt valuesAt) {
    std::vector<std::unique_ptr<InterfaceCurve>> curves;
    Points centres(elements.size(), 3);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto [first, last] = elements[i];
        for (const int vertex : {first, last}) {
            if (vertex < 0 || vertex >= vertices.rows()) {
                throw InputError(
                    fmt::format("line element {} names the vertex {}, but there are {} "
                                "(indices start at 0)",
                                i, vertex, vertices.rows()));
            }
        }
        Points ends(2, 3);
        ends << vertices.row(first), vertices.row(last);
        if (!((ends.row(1) - ends.row(0)).norm() > 0)) {
            throw InputError(
                fmt::format("line element {} (vertices {} and {}) has no length", i, first, last));
        }
        const geometry::NurbsCurve line(geometry::KnotVector::uniform(1, 1), ends);
        curves.push_back(valuesAt == ValuesAt::vertices ? interfaceCurve(line, {first, last})
                                                        : interfaceCell(line, static_cast<int>(i)));
        centres.row(i) = ends.colwise().mean();
    }
    return CurveInterface(std::move(curves), valuesAt == ValuesAt::vertices ? vertices : centres);
}

} // namespace tokay::mapper
