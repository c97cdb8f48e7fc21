// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"
#include "geometry/spline/Points.hpp"

#include <Eigen/SparseCore>

namespace tokay::structure {

/// The faces of the fluid's interface: each moves as the mean of its points. Its
/// force goes to its points in equal parts, the transpose, so that force times
/// motion of the faces is force times motion of the points.
class InterfaceFaces {
  public:
    /// @throws channel::PeerError if a face has no points
    explicit InterfaceFaces(const channel::Interface& fluid);

    int count() const { return static_cast<int>(mean_.rows()); }

    /// @param ofPoints  nPoints x 3
    /// @return          nFaces x 3
    geometry::Points means(const geometry::Points& ofPoints) const { return mean_ * ofPoints; }

    /// @param onFaces  nFaces x 3 [N]
    /// @return         nPoints x 3 [N]
    geometry::Points onPoints(const geometry::Points& onFaces) const {
        return mean_.transpose() * onFaces;
    }

    /// Volume (a plane scene: area) over which the faces move along their normals,
    /// out of the fluid, while the points go straight from one place to another.
    /// @param from  nPoints x 3 [m]
    /// @param to    nPoints x 3 [m]
    double sweptVolume(const geometry::Points& from, const geometry::Points& to) const;

  private:
    double sweptByEdge(int face, const geometry::Points& from, const geometry::Points& to) const;
    double sweptByPolygon(int face, const geometry::Points& from, const geometry::Points& to) const;

    bool isPlane_;
    std::vector<std::uint32_t> offsets_;
    std::vector<std::uint32_t> points_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> mean_;
};

} // namespace tokay::structure
