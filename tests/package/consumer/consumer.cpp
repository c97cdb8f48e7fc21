// SPDX-License-Identifier: GPL-3.0-or-later
// Someone else's program: a field of a fluid's faces on a structure's vertices.
#include <mapper/mortar/MortarMapping.hpp>

#include <iostream>

using namespace tokay::mapper;

int main() {
    const SurfaceMesh::Faces faces = {{0, 1, 2, 3}};
    Points square(4, 3);
    square << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    const SurfaceMesh fluid(square, faces, ValuesAt::faces);
    const SurfaceMesh structure(square, faces, ValuesAt::vertices);

    const MortarMapping mapping(fluid, structure);
    const Eigen::MatrixXd pressure = mapping.apply(Eigen::MatrixXd::Constant(1, 1, 3));
    std::cout << mapping.report().text() << pressure.transpose() << '\n';
    return (pressure.array() - 3).abs().maxCoeff() < 1e-12 ? 0 : 1;
}
