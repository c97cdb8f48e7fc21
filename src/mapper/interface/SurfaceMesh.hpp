// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/projection/BoxTree.hpp"
#include "geometry/quadrature/Triangle.hpp"
#include "mapper/Discretisation.hpp"

#include <memory>

namespace tokay::mapper {

/// A mesh of triangles, quadrilaterals and polygons, mixed as may be. A face of
/// more than three vertices is cut into triangles around its centre, where the
/// value is the mean of its vertices': so functions are continuous, linear
/// fields exact, and warped faces have a definite shape. Values on faces are
/// constant over them.
class SurfaceMesh : public Discretisation {
  public:
    using Faces = std::vector<std::vector<int>>;

    /// @param vertices  n x 3 [m]
    /// @param faces     vertices of each, in order around it
    /// @throws InputError naming the first face with too few vertices, one twice,
    /// one that does not exist, or no area; or a vertex that is not finite
    SurfaceMesh(Points vertices, Faces faces, ValuesAt valuesAt);

    int nValues() const override { return static_cast<int>(coordinates().rows()); }
    /// Vertices, or centroids of the faces.
    const Points& coordinates() const override;
    double size() const override { return size_; }
    Location locate(const Point& point) const override;

    const Points& vertices() const { return vertices_; }
    int nFaces() const { return static_cast<int>(faces_.size()); }
    /// Triangles of all faces; those of one face follow each other.
    int nTriangles() const { return static_cast<int>(faceOf_.size()); }
    geometry::Triangle triangle(int i) const;
    int faceOf(int triangle) const { return faceOf_[triangle]; }
    /// Its triangles are those from here to the first one of the next face.
    int firstTriangle(int face) const { return firstTriangle_[face]; }
    /// Corners that triangles share have the same number: the vertex, or for the
    /// centre of a face the number of vertices plus that of the face.
    std::array<int, 3> cornerNumbers(int triangle) const;

    /// Functions of the triangle's face; their list is the same for all of a
    /// face's triangles. Outside the triangle they are continued linearly.
    Functions functions(int triangle, const geometry::Barycentric& at) const;

    /// Functions written into memory of the caller.
    void evaluate(int triangle, const geometry::Barycentric& at, Functions& functions) const;

    /// Functions at the triangle's corners, written into memory of the caller.
    void evaluateCorners(int triangle, CornerFunctions& functions) const;

    /// Degree of the functions on a triangle.
    int degree() const { return valuesAt_ == ValuesAt::vertices ? 1 : 0; }

    /// Tree over the boxes of the faces.
    const geometry::BoxTree& tree() const { return *tree_; }

  private:
    void checkFace(int face) const;
    void addTriangles(int face);

    Points vertices_;
    Faces faces_;
    ValuesAt valuesAt_;
    /// Of each face: the mean of its vertices, and the centre of its area.
    Points centres_, centroids_;
    std::vector<int> faceOf_;        ///< of each triangle; the triangles themselves would take
                                     ///< more memory than all the rest
    std::vector<int> firstTriangle_; ///< nFaces + 1
    double size_;
    std::unique_ptr<geometry::BoxTree> tree_;
};

} // namespace tokay::mapper
