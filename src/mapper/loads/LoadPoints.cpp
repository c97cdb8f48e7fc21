// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/loads/LoadPoints.hpp"

#include <Eigen/Geometry>

namespace tokay::mapper {

namespace {

// A polygon's value at its centre is the mean of its vertices'.
Eigen::VectorXd integralsOfFunctions(const Points& corners) {
    const Eigen::Index n = corners.rows();
    if (n < 3) {
        return Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
    }
    const Point centre = corners.colwise().mean();
    Eigen::VectorXd ofSides(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Point a = corners.row(i).transpose() - centre;
        const Point b = corners.row((i + 1) % n).transpose() - centre;
        ofSides[i] = a.cross(b).norm();
    }
    const double area = ofSides.sum();
    if (!(area > 0)) {
        return Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
    }
    Eigen::VectorXd integrals = Eigen::VectorXd::Constant(n, 1.0 / (3 * static_cast<double>(n)));
    for (Eigen::Index i = 0; i < n; ++i) {
        integrals[i] += (ofSides[i] + ofSides[(i + n - 1) % n]) / (3 * area);
    }
    return integrals;
}

} // namespace

LoadPoints loadsAtVertices(const FaceMesh& mesh) {
    std::vector<Eigen::Triplet<double>> shares;
    for (int face = 0; face < mesh.nFaces(); ++face) {
        const std::vector<int>& corners = mesh.faces[face];
        const Eigen::VectorXd integrals = integralsOfFunctions(mesh.vertices(corners, Eigen::all));
        for (std::size_t i = 0; i < corners.size(); ++i) {
            shares.emplace_back(corners[i], face, integrals[i]);
        }
    }
    LoadPoints loads{mesh.vertices, RowSparseMatrix(mesh.vertices.rows(), mesh.nFaces())};
    loads.shares.setFromTriplets(shares.begin(), shares.end());
    return loads;
}

} // namespace tokay::mapper
