// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/NodePattern.hpp"

#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;

TEST(NodePattern, element_matrices_arrive_where_a_dense_assembly_puts_them) {
    const int nU = 5;
    const int nV = 4;
    const geometry::KnotVector u(2, {0, 0, 0, 0.2, 0.6, 1, 1, 1}), v(1, {0, 0, 0.5, 0.7, 1, 1});
    ASSERT_EQ(u.nBasis(), nU);
    ASSERT_EQ(v.nBasis(), nV);
    const NodePattern pattern(2, tensorNeighbours({u, v}));
    SparseMatrix matrix = pattern.zeroMatrix();
    MatrixXd dense = MatrixXd::Zero(2 * nU * nV, 2 * nU * nV);
    const int nLocal = 2 * 3 * 2;
    double next = 1;
    for (int firstV = 0; firstV + 1 < nV; ++firstV) {
        for (int firstU = 0; firstU + 2 < nU; ++firstU) {
            MatrixXd element(nLocal, nLocal);
            for (double& value : element.reshaped()) {
                value = next++;
            }
            std::vector<int> nodes;
            for (int k = 0; k < 6; ++k) {
                nodes.push_back(firstU + k % 3 + nU * (firstV + k / 3));
            }
            pattern.add(nodes, element, matrix.valuePtr());
            const auto unknown = [&](int local) { return 2 * nodes[local / 2] + local % 2; };
            for (int column = 0; column < nLocal; ++column) {
                for (int row = 0; row < nLocal; ++row) {
                    dense(unknown(row), unknown(column)) += element(row, column);
                }
            }
        }
    }
    EXPECT_EQ((MatrixXd(matrix) - dense).norm(), 0);
}
