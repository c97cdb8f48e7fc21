// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/restart/interfaceRenumbering.hpp"

#include "mapper/interface/PointCloud.hpp"

#include <numeric>

namespace tokay::structure {

namespace {

constexpr double relativeTolerance = 1e-6;

double extentOf(const geometry::Points& points) {
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

} // namespace

std::optional<std::vector<int>> interfaceRenumbering(const geometry::Points& before,
                                                     const geometry::Points& now) {
    if (before.rows() != now.rows()) {
        return std::nullopt;
    }
    const double tolerance = relativeTolerance * extentOf(before);
    std::vector<int> numbers(static_cast<std::size_t>(now.rows()));
    std::iota(numbers.begin(), numbers.end(), 0);
    if ((before - now).rowwise().norm().maxCoeff() <= tolerance) {
        return numbers; // as before, even where points coincide
    }
    const mapper::PointCloud cloud(before);
    std::vector<bool> found(numbers.size(), false);
    for (Eigen::Index point = 0; point < now.rows(); ++point) {
        const mapper::Location location = cloud.locate(now.row(point));
        const int number = location.values.front();
        if (location.gap > tolerance || found[static_cast<std::size_t>(number)]) {
            return std::nullopt;
        }
        found[static_cast<std::size_t>(number)] = true;
        numbers[static_cast<std::size_t>(point)] = number;
    }
    return numbers;
}

std::vector<int> componentNumbers(const std::vector<int>& points, int dimension) {
    std::vector<int> components;
    components.reserve(points.size() * static_cast<std::size_t>(dimension));
    for (const int point : points) {
        for (int c = 0; c < dimension; ++c) {
            components.push_back(point * dimension + c);
        }
    }
    return components;
}

} // namespace tokay::structure
