// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/ExtensionFunctional.hpp"

#include <algorithm>

namespace tokay::structure {

using Eigen::MatrixXd;

ExtensionFunctional::ExtensionFunctional(int nUnknowns, const std::vector<int>& dependents)
    : nUnknowns_(nUnknowns), nDependents_(static_cast<int>(dependents.size())),
      rowOf_(nUnknowns, -1) {
    for (int k = 0; k < nDependents_; ++k) {
        rowOf_[dependents[k]] = k;
    }
}

void ExtensionFunctional::add(const std::vector<int>& nodes, const std::array<bool, 3>& components,
                              const Eigen::RowVectorXd& row, double weight, int data) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        for (int c = 0; c < 3; ++c) {
            const int own = components[c] ? rowOf_[3 * nodes[k] + c] : -1;
            if (own < 0) {
                continue;
            }
            const double left = weight * row[static_cast<Eigen::Index>(k)];
            for (std::size_t l = 0; l < nodes.size(); ++l) {
                matrix_.emplace_back(own, 3 * nodes[l] + c,
                                     left * row[static_cast<Eigen::Index>(l)]);
            }
            if (data >= 0) {
                dataMatrix_.emplace_back(own, 3 * data + c, left);
            }
        }
    }
}

void ExtensionFunctional::add(const std::vector<int>& nodes, const MatrixXd& rows) {
    MatrixXd square = MatrixXd::Zero(rows.cols(), rows.cols());
    square.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    for (Eigen::Index k = 0; k < square.rows(); ++k) {
        const int own = rowOf_[3 * nodes[k / 3] + k % 3];
        for (Eigen::Index l = 0; l < square.cols() && own >= 0; ++l) {
            const double value = square(std::max(k, l), std::min(k, l));
            if (value != 0) {
                matrix_.emplace_back(own, 3 * nodes[l / 3] + l % 3, value);
            }
        }
    }
}

void ExtensionFunctional::addData(const std::vector<int>& nodes, const MatrixXd& rows,
                                  const MatrixXd& onData, int data) {
    const MatrixXd right = rows.transpose() * onData;
    for (Eigen::Index k = 0; k < right.rows(); ++k) {
        const int own = rowOf_[3 * nodes[k / 3] + k % 3];
        for (int c = 0; c < 3 && own >= 0; ++c) {
            dataMatrix_.emplace_back(own, 3 * data + c, right(k, c));
        }
    }
}

void ExtensionFunctional::addLagged(const std::vector<int>& nodes,
                                    const std::array<bool, 3>& components,
                                    const Eigen::RowVectorXd& row,
                                    const std::vector<int>& otherNodes,
                                    const Eigen::RowVectorXd& other, double weight) {
    add(nodes, components, row, weight);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        for (int c = 0; c < 3; ++c) {
            const int own = components[c] ? rowOf_[3 * nodes[k] + c] : -1;
            for (std::size_t l = 0; l < otherNodes.size() && own >= 0; ++l) {
                laggedMatrix_.emplace_back(own, 3 * otherNodes[l] + c,
                                           -weight * row[static_cast<Eigen::Index>(k)] *
                                               other[static_cast<Eigen::Index>(l)]);
            }
        }
    }
}

SparseMatrix ExtensionFunctional::sumOf(const std::vector<Eigen::Triplet<double>>& entries,
                                        int nColumns) const {
    SparseMatrix matrix(nDependents_, nColumns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

SparseMatrix ExtensionFunctional::matrix() const {
    return sumOf(matrix_, nUnknowns_);
}

SparseMatrix ExtensionFunctional::laggedMatrix() const {
    return sumOf(laggedMatrix_, nUnknowns_);
}

SparseMatrix ExtensionFunctional::dataMatrix() const {
    return sumOf(dataMatrix_, 3 * nData_);
}

} // namespace tokay::structure
