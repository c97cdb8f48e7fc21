// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/SurfaceMesh.hpp"

#include "common/errors.hpp"
#include "geometry/projection/ClosestCandidate.hpp"
#include "mapper/GapStatistics.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::mapper {

using geometry::Barycentric;
using geometry::Box;
using geometry::Triangle;

namespace {

Box boxOf(const Triangle& triangle) {
    Box box = Box::empty();
    for (int i = 0; i < 3; ++i) {
        box.include(triangle.corner(i));
    }
    return box;
}

} // namespace

SurfaceMesh::SurfaceMesh(Points vertices, Faces faces, ValuesAt valuesAt)
    : vertices_(std::move(vertices)), faces_(std::move(faces)), valuesAt_(valuesAt),
      centroids_(Points::Zero(faces_.size(), 3)) {
    checkPoints(vertices_);
    if (faces_.empty()) {
        throw InputError("the mesh of the interface has no face");
    }
    for (int face = 0; face < nFaces(); ++face) {
        checkFace(face);
        addTriangles(face);
    }
    std::vector<Box> boxes;
    boxes.reserve(triangles_.size());
    Box all = Box::empty();
    for (const Triangle& triangle : triangles_) {
        boxes.push_back(boxOf(triangle));
        all.include(boxes.back());
    }
    size_ = all.diagonal();
    tree_ = std::make_unique<geometry::BoxTree>(std::move(boxes));
}

void SurfaceMesh::checkFace(int face) const {
    const std::vector<int>& corners = faces_[face];
    if (corners.size() < 3) {
        throw InputError(
            fmt::format("face {} has {} vertices: a face needs at least 3", face, corners.size()));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] < 0 || corners[i] >= vertices_.rows()) {
            throw InputError(fmt::format("face {} names the vertex {}, but there are {} (indices "
                                         "start at 0)",
                                         face, corners[i], vertices_.rows()));
        }
        if (std::count(corners.begin(), corners.end(), corners[i]) > 1) {
            throw InputError(fmt::format("face {} names the vertex {} twice", face, corners[i]));
        }
    }
}

void SurfaceMesh::addTriangles(int face) {
    const std::vector<int>& corners = faces_[face];
    const int n = static_cast<int>(corners.size());
    const Points points = vertices_(corners, Eigen::all);
    const Point centre = points.colwise().mean();
    double area = 0, longest = 0;
    for (int i = 0; i < (n == 3 ? 1 : n); ++i) {
        const Triangle triangle = n == 3 ? Triangle(points.row(0), points.row(1), points.row(2))
                                         : Triangle(points.row(i), points.row((i + 1) % n), centre);
        for (int j = 0; j < 3; ++j) {
            longest = std::max(longest, (triangle.corner(j) - triangle.corner((j + 1) % 3)).norm());
        }
        // A vertex in the middle of a side makes no flat triangle with the
        // centre, so a flat one means a broken face.
        if (!(triangle.area() > 1e-13 * longest * longest)) {
            throw InputError(fmt::format("face {} has no area at its vertices {} and {} (around "
                                         "({:.6g}, {:.6g}, {:.6g})): repair or remove it",
                                         face, corners[i], corners[(i + 1) % n], centre[0],
                                         centre[1], centre[2]));
        }
        area += triangle.area();
        centroids_.row(face) +=
            triangle.area() * triangle.at(Barycentric::Constant(1.0 / 3)).transpose();
        triangles_.push_back(triangle);
        faceOf_.push_back(face);
        startOf_.push_back(i);
    }
    centroids_.row(face) /= area;
}

const Points& SurfaceMesh::coordinates() const {
    return valuesAt_ == ValuesAt::vertices ? vertices_ : centroids_;
}

std::array<int, 3> SurfaceMesh::cornerNumbers(int triangle) const {
    const int face = faceOf_[triangle], start = startOf_[triangle];
    const std::vector<int>& corners = faces_[face];
    const int n = static_cast<int>(corners.size());
    if (n == 3) {
        return {corners[0], corners[1], corners[2]};
    }
    return {corners[start], corners[(start + 1) % n], static_cast<int>(vertices_.rows()) + face};
}

Functions SurfaceMesh::functions(int triangle, const Barycentric& at) const {
    Functions functions;
    evaluate(triangle, at, functions);
    return functions;
}

void SurfaceMesh::evaluate(int triangle, const Barycentric& at, Functions& functions) const {
    const int face = faceOf_[triangle];
    if (valuesAt_ == ValuesAt::faces) {
        functions.values.assign(1, face);
        functions.weights.setOnes(1);
        return;
    }
    functions.values = faces_[face];
    const int n = static_cast<int>(functions.values.size()), start = startOf_[triangle];
    if (n == 3) {
        functions.weights = at;
        return;
    }
    functions.weights.setConstant(n, at[2] / n);
    functions.weights[start] += at[0];
    functions.weights[(start + 1) % n] += at[1];
}

void SurfaceMesh::evaluateCorners(int triangle, CornerFunctions& functions) const {
    const int face = faceOf_[triangle];
    if (valuesAt_ == ValuesAt::faces) {
        functions.values.assign(1, face);
        functions.weights.setOnes(1, 3);
        return;
    }
    functions.values = faces_[face];
    const int n = static_cast<int>(functions.values.size()), start = startOf_[triangle];
    if (n == 3) {
        functions.weights.setIdentity(3, 3);
        return;
    }
    functions.weights.setZero(n, 3);
    functions.weights(start, 0) = 1;
    functions.weights((start + 1) % n, 1) = 1;
    functions.weights.col(2).setConstant(1.0 / n);
}

Location SurfaceMesh::locate(const Point& point) const {
    geometry::ClosestCandidate candidate(size_);
    int nearest = 0;
    Barycentric at = Barycentric::Zero();
    tree_->visitNearest(point, [&](int i) {
        const Barycentric found = triangles_[i].closest(point);
        if (candidate.offer(triangles_[i].at(found) - point)) {
            nearest = i;
            at = found;
        }
        return candidate.squaredLimit();
    });
    return {functions(nearest, at), candidate.distance(), true, candidate.isAmbiguous()};
}

} // namespace tokay::mapper
