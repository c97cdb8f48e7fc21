// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/trimming/PatchQuadrature.hpp"
#include "geometry/trimming/TrimmedPatch.hpp"
#include "igaStructure/assembly/TabulatedBasis.hpp"
#include "igaStructure/kinematics/shell/element/ShellSection.hpp"

#include <memory>
#include <vector>

namespace tokay::structure {

/// One patch of a shell as it is integrated: degree + 1 Gauss points a direction
/// in full elements, the points of PatchQuadrature in cut ones.
class ShellPatch {
  public:
    /// A quadrature point of a cut element.
    struct CutPoint {
        double xi, eta, weight;
        Eigen::MatrixXd functions; ///< 6 rows, as SurfaceFunctions
    };

    /// @param nodes  of each control point of the patch's basis
    /// @throws InputError if the patch has an area of zero at a point
    ShellPatch(geometry::TrimmedPatch patch, std::vector<int> nodes,
               std::shared_ptr<const ShellSection> section, double massPerArea,
               const geometry::QuadratureOptions& cutRule);

    const geometry::TrimmedPatch& patch() const { return patch_; }
    const geometry::NurbsSurface& surface() const { return patch_.basis(); }
    const std::vector<int>& nodes() const { return nodes_; }
    const ShellSection& section() const { return *section_; }
    double massPerArea() const { return massPerArea_; } ///< [kg/m^2]
    const TabulatedBasis& u() const { return u_; }
    const TabulatedBasis& v() const { return v_; }

    int nFunctions() const { return u_.nFunctions() * v_.nFunctions(); }
    /// Nodes of the elements in a row (of equal eta) that are not empty.
    std::vector<int> nodesOfRow(int row) const;
    /// Quadrature points of a cut element, empty for others.
    const std::vector<CutPoint>& cutPoints(int element) const { return cutPoints_[element]; }

  private:
    void requireRegular() const;

    geometry::TrimmedPatch patch_;
    std::vector<int> nodes_;
    std::shared_ptr<const ShellSection> section_;
    double massPerArea_;
    TabulatedBasis u_, v_;
    std::vector<std::vector<CutPoint>> cutPoints_;
};

} // namespace tokay::structure
