// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "channel/messages.hpp"
#include "mapper/loads/LoadPoints.hpp"

namespace tokay::structure {

/// The faces of the fluid's interface. Each moves as the mean over its area of the motion
/// of its points.
class InterfaceFaces {
  public:
    /// @throws channel::PeerError if a face has no points
    explicit InterfaceFaces(const channel::Interface& fluid);

    int count() const { return mesh_.nFaces(); }
    const mapper::FaceMesh& mesh() const { return mesh_; }

    /// @param ofPoints  nPoints x 3
    /// @return          nFaces x 3
    geometry::Points means(const geometry::Points& ofPoints) const {
        return atVertices_.shares.transpose() * ofPoints;
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
    mapper::FaceMesh mesh_;
    mapper::LoadPoints atVertices_;
};

} // namespace tokay::structure
