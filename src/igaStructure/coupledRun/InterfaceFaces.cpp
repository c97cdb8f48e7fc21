// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/InterfaceFaces.hpp"

#include "channel/PeerError.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tokay::structure {

using Eigen::Vector3d;
using geometry::Points;

namespace {

// A triangle with corners that go straight: its mean motion times the mean over
// time of its area vector.
double sweptByTriangle(const Vector3d& p, const Vector3d& q, const Vector3d& r, const Vector3d& dp,
                       const Vector3d& dq, const Vector3d& dr) {
    const Vector3d a = q - p, b = r - p;
    const Vector3d da = dq - dp, db = dr - dp;
    const Vector3d area = 0.5 * (a.cross(b) + 0.5 * (a.cross(db) + da.cross(b)) + da.cross(db) / 3);
    return (dp + dq + dr).dot(area) / 3;
}

using PointRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// That the arrays fit each other was checked when the message arrived.
mapper::FaceMesh faceMesh(const channel::Interface& fluid) {
    const Eigen::Map<const PointRows> given(fluid.points.data(),
                                            fluid.points.size() / fluid.dimension, fluid.dimension);
    mapper::FaceMesh mesh{Points::Zero(given.rows(), 3), {}};
    mesh.vertices.leftCols(fluid.dimension) = given;
    for (std::size_t face = 0; face + 1 < fluid.faceOffsets.size(); ++face) {
        const auto first = fluid.facePoints.begin() + fluid.faceOffsets[face];
        mesh.faces.emplace_back(first, fluid.facePoints.begin() + fluid.faceOffsets[face + 1]);
        if (mesh.faces.back().empty()) {
            throw channel::PeerError(
                fmt::format("face {} of the fluid's interface has no points", face));
        }
    }
    return mesh;
}

} // namespace

InterfaceFaces::InterfaceFaces(const channel::Interface& fluid)
    : isPlane_(fluid.dimension == 2), mesh_(faceMesh(fluid)),
      atVertices_(mapper::loadsAtVertices(mesh_)) {}

double InterfaceFaces::sweptVolume(const Points& from, const Points& to) const {
    double volume = 0;
    for (int face = 0; face < count(); ++face) {
        volume += isPlane_ ? sweptByEdge(face, from, to) : sweptByPolygon(face, from, to);
    }
    return volume;
}

// The fluid lies left of an edge.
double InterfaceFaces::sweptByEdge(int face, const Points& from, const Points& to) const {
    const int a = mesh_.faces[face].front();
    const int b = mesh_.faces[face].back();
    const Vector3d across = to.row(b) - from.row(a);
    const Vector3d back = to.row(a) - from.row(b);
    return -0.5 * across.cross(back).z();
}

// Triangles around the mean of the points.
double InterfaceFaces::sweptByPolygon(int face, const Points& from, const Points& to) const {
    const std::vector<int>& corners = mesh_.faces[face];
    const auto n = static_cast<int>(corners.size());
    const auto motion = [&](int point) -> Vector3d { return to.row(point) - from.row(point); };
    Vector3d centre = Vector3d::Zero();
    Vector3d centreMotion = Vector3d::Zero();
    for (const int point : corners) {
        centre += from.row(point) / n;
        centreMotion += motion(point) / n;
    }
    double volume = 0;
    for (int k = 0; k < n; ++k) {
        const int p = corners[k];
        const int q = corners[(k + 1) % n];
        volume +=
            sweptByTriangle(centre, from.row(p), from.row(q), centreMotion, motion(p), motion(q));
    }
    return volume;
}

} // namespace tokay::structure
