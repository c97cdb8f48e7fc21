// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsSurface.hpp"
#include "igaStructure/assembly/PatchNodes.hpp"
#include "igaStructure/assembly/TabulatedBasis.hpp"

#include <Eigen/Core>

namespace tokay::structure {

/// The functions of a plane patch on one element (knot span), at one
/// quadrature point after the other, with their gradients in the reference
/// configuration.
class PlaneElement {
  public:
    using Gradients = Eigen::Matrix<double, 2, Eigen::Dynamic>;

    /// References are kept.
    PlaneElement(const geometry::NurbsSurface& surface, const PatchNodes& nodes,
                 const TabulatedBasis& u, const TabulatedBasis& v);

    int nFunctions() const { return u_.nFunctions() * v_.nFunctions(); }
    int nPoints() const { return u_.nPointsPerSpan() * v_.nPointsPerSpan(); }

    void moveToElement(int spanU, int spanV);
    void moveToPoint(int point);

    /// Node of each function.
    const std::vector<int>& nodes() const { return elementNodes_; }

    const Eigen::VectorXd& values() const { return values_; }
    /// Column a: gradient of function a [1/m].
    const Gradients& gradients() const { return gradients_; }
    Eigen::Vector2d position() const { return coordinates_ * values_; }
    /// Quadrature weight times area element [m^2].
    double area() const { return area_; }

    /// @throws InputError if the patch folds over at the point
    void requireRegular() const;

  private:
    void makeRational();

    const geometry::NurbsSurface& surface_;
    const PatchNodes& nodes_;
    const TabulatedBasis& u_;
    const TabulatedBasis& v_;
    int spanU_ = 0;
    int spanV_ = 0;
    std::vector<int> elementNodes_;
    Eigen::Matrix<double, 2, Eigen::Dynamic> coordinates_;
    Eigen::VectorXd weights_;
    Eigen::VectorXd values_;
    Gradients gradients_;
    double area_ = 0;
};

/// Gradients and area elements at all quadrature points of a patch, element by element, and
/// the nodes of each: the reference configuration stays, so they are evaluated once.
class PlaneElementTable {
  public:
    using Gradients = Eigen::Map<const PlaneElement::Gradients>;

    /// Adds the point at which an element stands; points of an element come one after the other.
    void add(const PlaneElement& element);

    int nElements() const { return static_cast<int>(nodes_.size()); }
    int nFunctions() const { return static_cast<int>(nodes_.front().size()); }
    /// Number of quadrature points per element.
    int nPoints() const { return nPoints_; }

    const std::vector<int>& nodes(int element) const { return nodes_[element]; }
    /// 2 x nFunctions; column a: gradient of function a [1/m].
    Gradients gradients(int element, int point) const {
        const std::size_t size = 2 * nodes_.front().size();
        return {&gradients_[size * index(element, point)], 2, nFunctions()};
    }
    /// Quadrature weight times area element [m^2].
    double area(int element, int point) const { return areas_[index(element, point)]; }

  private:
    std::size_t index(int element, int point) const {
        return static_cast<std::size_t>(element) * nPoints_ + point;
    }

    int nPoints_ = 0;
    std::vector<std::vector<int>> nodes_;
    std::vector<double> gradients_; ///< column after column, point after point
    std::vector<double> areas_;
};

} // namespace tokay::structure
