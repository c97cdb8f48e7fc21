// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <map>
#include <vector>

namespace tokay::structure {

/// Nodes of several elements, each once.
class NodeUnion {
  public:
    /// @return place of each node among nodes()
    std::vector<Eigen::Index> add(const std::vector<int>& nodes) {
        std::vector<Eigen::Index> places;
        for (const int node : nodes) {
            const auto [found, isNew] =
                locations_.try_emplace(node, static_cast<Eigen::Index>(nodes_.size()));
            if (isNew) {
                nodes_.push_back(node);
            }
            places.push_back(found->second);
        }
        return places;
    }

    const std::vector<int>& nodes() const { return nodes_; }
    Eigen::Index size() const { return static_cast<Eigen::Index>(nodes_.size()); }

  private:
    std::map<int, Eigen::Index> locations_;
    std::vector<int> nodes_;
};

/// Adds the columns of some nodes, three each, to those of a union.
/// @param places  as NodeUnion::add returns them
inline void addColumns(const Eigen::MatrixXd& from, const std::vector<Eigen::Index>& places,
                       double factor, Eigen::MatrixXd& to) {
    for (std::size_t k = 0; k < places.size(); ++k) {
        to.middleCols<3>(3 * places[k]) +=
            factor * from.middleCols<3>(3 * static_cast<Eigen::Index>(k));
    }
}

} // namespace tokay::structure
