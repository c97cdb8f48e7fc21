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

SurfaceMesh::SurfaceMesh(Points vertices, Faces faces, ValuesAt valuesAt)
    : vertices_(std::move(vertices)), faces_(std::move(faces)), valuesAt_(valuesAt),
      centres_(Points::Zero(faces_.size(), 3)), centroids_(centres_) {
    checkPoints(vertices_);
    if (faces_.empty()) {
        throw InputError("the mesh of the interface has no face");
    }
    std::vector<Box> boxes;
    boxes.reserve(faces_.size());
    Box all = Box::empty();
    firstTriangle_.assign(1, 0);
    for (int face = 0; face < nFaces(); ++face) {
        checkFace(face);
        addTriangles(face);
        // Triangles around the centre lie within the vertices' box.
        boxes.push_back(Box::around(vertices_(faces_[face], Eigen::all)));
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
    const Point centre = vertices_(corners, Eigen::all).colwise().mean();
    centres_.row(face) = centre;
    double area = 0, longest = 0;
    firstTriangle_.push_back(firstTriangle_[face] + (n == 3 ? 1 : n));
    faceOf_.resize(firstTriangle_[face + 1], face);
    for (int i = 0; firstTriangle_[face] + i < firstTriangle_[face + 1]; ++i) {
        const Triangle triangle = this->triangle(firstTriangle_[face] + i);
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
    }
    centroids_.row(face) /= area;
}

Triangle SurfaceMesh::triangle(int i) const {
    const int face = faceOf_[i], start = i - firstTriangle_[face];
    const std::vector<int>& corners = faces_[face];
    const std::size_t next = start + 1;
    return {vertices_.row(corners[start]), vertices_.row(corners[next < corners.size() ? next : 0]),
            corners.size() == 3 ? Point(vertices_.row(corners[2])) : Point(centres_.row(face))};
}

const Points& SurfaceMesh::coordinates() const {
    return valuesAt_ == ValuesAt::vertices ? vertices_ : centroids_;
}

std::array<int, 3> SurfaceMesh::cornerNumbers(int triangle) const {
    const int face = faceOf_[triangle], start = triangle - firstTriangle_[face];
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
    const int n = static_cast<int>(functions.values.size()),
              start = triangle - firstTriangle_[face];
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
    const int n = static_cast<int>(functions.values.size()),
              start = triangle - firstTriangle_[face];
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
    tree_->visitNearest(point, [&](int face) {
        for (int number = firstTriangle_[face]; number < firstTriangle_[face + 1]; ++number) {
            const Triangle triangle = this->triangle(number);
            const Barycentric found = triangle.closest(point);
            if (candidate.offer(triangle.at(found) - point)) {
                nearest = number;
                at = found;
            }
        }
        return candidate.squaredLimit();
    });
    return {functions(nearest, at), candidate.distance(), true, candidate.isAmbiguous()};
}

} // namespace tokay::mapper
