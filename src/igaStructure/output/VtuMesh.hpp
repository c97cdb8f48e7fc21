// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/VtuFile.hpp"
#include "geometry/spline/NurbsSurface.hpp"
#include "igaStructure/output/Location.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace tokay::structure {

/// Cells of one kind of a .vtu file, and the locations of a body where its points lie.
struct VtuMesh {
    std::vector<Location> points; ///< where fields are evaluated
    std::vector<std::int64_t> connectivity;
    int cellSize = 4; ///< points per cell
    VtkCell cellType = VtkCell::quadrilateral;

    /// Bezier cells only: degrees of each cell; weight of each control point;
    /// the rational functions' denominator at each point (empty: polynomial);
    /// and the matrices that turn values at the points of a cell (xi fastest)
    /// into Bernstein coefficients along each direction.
    Eigen::Vector3i degrees = {0, 0, 0};
    Eigen::VectorXd weights;
    Eigen::VectorXd denominators;
    Eigen::MatrixXd toBernsteinXi;
    Eigen::MatrixXd toBernsteinEta = Eigen::MatrixXd::Ones(1, 1);
    Eigen::MatrixXd toBernsteinZeta = Eigen::MatrixXd::Ones(1, 1);

    /// Sets weights and denominators from the rational functions' denominator.
    void setDenominators(const std::function<double(const Location&)>& denominator);

    bool isBezier() const { return degrees[0] > 0; }
};

/// Each element of the patch cut into subdivision x subdivision quadrilaterals.
/// Elements do not share points, so that a field may jump between them.
VtuMesh quadMesh(const geometry::NurbsSurface& surface, int subdivision, int patch = 0);

/// A VTK_BEZIER_QUADRILATERAL for each element, exact for the geometry and for
/// fields of the patch's own basis, interpolating for others.
VtuMesh bezierMesh(const geometry::NurbsSurface& surface, int patch = 0);

/// Values that the file has at a mesh's points: those of a field, or for Bezier
/// cells its control values.
/// @param values  a column a point
Eigen::MatrixXd fileValues(const VtuMesh& mesh, const Eigen::MatrixXd& values);

} // namespace tokay::structure
