// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/NodePattern.hpp"

#include "common/errors.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace tokay::structure {

std::vector<std::vector<int>>
tensorNeighbours(const std::vector<geometry::KnotVector>& directions) {
    std::vector<std::vector<int>> all = {{0}};
    int stride = 1; // of the direction
    for (const geometry::KnotVector& knots : directions) {
        std::vector<std::vector<int>> product;
        product.reserve(all.size() * knots.nBasis());
        for (int i = 0; i < knots.nBasis(); ++i) {
            const int first = std::max(0, i - knots.degree());
            const int last = std::min(knots.nBasis() - 1, i + knots.degree());
            for (const std::vector<int>& others : all) {
                std::vector<int>& own = product.emplace_back();
                own.reserve(others.size() * (last - first + 1));
                for (int j = first; j <= last; ++j) {
                    for (const int other : others) {
                        own.push_back(other + stride * j);
                    }
                }
            }
        }
        all = std::move(product);
        stride *= knots.nBasis();
    }
    return all;
}

NodePattern::NodePattern(int nComponents, std::vector<std::vector<int>> neighbours)
    : nComponents_(nComponents) {
    starts_.push_back(0);
    for (std::size_t node = 0; node < neighbours.size(); ++node) {
        std::vector<int>& own = neighbours[node];
        own.push_back(static_cast<int>(node));
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        neighbours_.insert(neighbours_.end(), own.begin(), own.end());
        starts_.push_back(static_cast<std::ptrdiff_t>(neighbours_.size()));
        std::vector<int>().swap(own);
    }
    if (nComponents * nComponents * starts_.back() > std::numeric_limits<int>::max()) {
        throw InputError("the discretisation is too fine: its matrix has more than 2^31 entries");
    }
}

SparseMatrix NodePattern::zeroMatrix() const {
    const auto nNodes = static_cast<Eigen::Index>(starts_.size() - 1);
    SparseMatrix matrix(nComponents_ * nNodes, nComponents_ * nNodes);
    matrix.resizeNonZeros(nComponents_ * nComponents_ * starts_.back());
    int* columnStarts = matrix.outerIndexPtr();
    int* rows = matrix.innerIndexPtr();
    int entry = 0;
    *columnStarts++ = 0;
    for (Eigen::Index node = 0; node < nNodes; ++node) {
        for (int c = 0; c < nComponents_; ++c) {
            for (std::ptrdiff_t k = starts_[node]; k < starts_[node + 1]; ++k) {
                for (int r = 0; r < nComponents_; ++r) {
                    rows[entry++] = nComponents_ * neighbours_[k] + r;
                }
            }
            *columnStarts++ = entry;
        }
    }
    std::fill(matrix.valuePtr(), matrix.valuePtr() + entry, 0.0);
    return matrix;
}

void NodePattern::findRows(int column, const std::vector<int>& nodes,
                           std::vector<int>& rows) const {
    const auto begin = neighbours_.begin() + starts_[column];
    const auto end = neighbours_.begin() + starts_[column + 1];
    auto entry = begin;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const bool follows = k > 0 && entry + 1 < end && *(entry + 1) == nodes[k];
        entry = follows ? entry + 1 : std::lower_bound(begin, end, nodes[k]);
        assert(entry != end && *entry == nodes[k]);
        rows[k] = static_cast<int>(entry - begin);
    }
}

void NodePattern::add(const std::vector<int>& nodes, const Eigen::MatrixXd& element,
                      double* values) const {
    std::vector<int> rows(nodes.size());
    const int n = nComponents_;
    for (std::size_t l = 0; l < nodes.size(); ++l) {
        findRows(nodes[l], nodes, rows);
        const std::ptrdiff_t height = n * (starts_[nodes[l] + 1] - starts_[nodes[l]]);
        double* block = values + n * n * starts_[nodes[l]];
        for (int c = 0; c < n; ++c) {
            const double* source = &element(0, n * static_cast<Eigen::Index>(l) + c);
            double* target = block + c * height;
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                for (int r = 0; r < n; ++r) {
                    target[n * rows[k] + r] += source[n * k + r];
                }
            }
        }
    }
}

} // namespace tokay::structure
