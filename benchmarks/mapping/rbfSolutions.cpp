// SPDX-License-Identifier: GPL-3.0-or-later
// Radial basis functions solved globally and by the partition of unity: seconds, memory
// and error of a smooth field, by kernel and numbers of points. The bounds of
// mapper::RbfSolution::automatic follow from it. Usage: rbfSolutions RESULTS.csv [quick]
#include "interfaces.hpp"
#include "mapper/rbf/RbfMapping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace tokay::benchmark {

namespace {

using Eigen::VectorXd;
using mapper::RadialKernel;
using mapper::RbfSolution;

struct Clouds {
    const char* shape;
    Points from, to;
};

VectorXd smoothAt(const Points& points) {
    return (4 * points.col(0)).array().sin() * (3 * points.col(1)).array().cos();
}

struct Cost {
    double seconds, megabytes, error;
};

/// The fastest of some builds with one map each.
Cost costOf(const Clouds& clouds, RadialKernel kernel, RbfSolution solution) {
    mapper::RbfOptions options;
    options.kernel = kernel;
    options.solution = solution;
    options.gapLimit = {0.5, false};
    Cost cost{1e300, 0, 0};
    for (int i = 0; i < 3; ++i) {
        const mapper::RbfMapping mapping(clouds.from, clouds.to, options);
        const VectorXd error = mapping.apply(smoothAt(clouds.from)) - smoothAt(clouds.to);
        cost = {std::min(cost.seconds, mapping.report().seconds), mapping.report().bytes / 1e6,
                error.norm() / std::sqrt(static_cast<double>(error.size()))};
    }
    return cost;
}

void measure(const Clouds& clouds, RadialKernel kernel, std::ofstream& csv) {
    const Cost global = costOf(clouds, kernel, RbfSolution::global),
               partition = costOf(clouds, kernel, RbfSolution::partitionOfUnity);
    const std::string name = nameOf(kernel);
    csv << fmt::format("{},{},{},{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g}\n", clouds.shape,
                       name, clouds.from.rows(), clouds.to.rows(), global.seconds,
                       partition.seconds, global.megabytes, partition.megabytes, global.error,
                       partition.error);
    fmt::print("{:<8} {:<10} {:>6} {:>7} {:>9.2g} {:>9.2g} {:>8.2g} {:>8.2g} {:>9.2g} {:>9.2g}\n",
               clouds.shape, name, clouds.from.rows(), clouds.to.rows(), global.seconds,
               partition.seconds, global.megabytes, partition.megabytes, global.error,
               partition.error);
    std::fflush(stdout);
}

Points surface(int n, int seed) {
    return quadrilaterals(n, seed, mapper::ValuesAt::vertices).coordinates();
}

std::vector<Clouds> allClouds(bool quick) {
    std::vector<Clouds> all;
    for (const int n : {50, 100, 200, 400, 800}) {
        for (const int nTo : {n / 2, 20 * n}) {
            all.push_back({"curve", lines(n, 0).coordinates(), lines(nTo - 1, 1).coordinates()});
        }
    }
    for (const int n : {7, 10, 13, 16, 20, 28, 40}) {
        for (const int ratio : {1, 5}) {
            if (!quick || n < 20) {
                all.push_back({"surface", surface(n, 0), surface(ratio * n - 1, 1)});
            }
        }
    }
    return all;
}

} // namespace

} // namespace tokay::benchmark

int main(int argc, char** argv) {
    using namespace tokay::benchmark;
    try {
        std::ofstream csv(argc > 1 ? argv[1] : "rbfSolutions.csv");
        csv << "shape,kernel,nFrom,nTo,global_s,partition_s,global_MB,partition_MB,globalError,"
               "partitionError\n";
        fmt::print("{:<8} {:<10} {:>6} {:>7} {:>19} {:>17} {:>19}\n{:>34}{:>10} {:>9} {:>8} {:>8} "
                   "{:>9} {:>9}\n",
                   "shape", "kernel", "from", "to", "seconds", "MB", "error", "", "global", "parts",
                   "global", "parts", "global", "parts");
        for (const RadialKernel kernel :
             {RadialKernel::thinPlate, RadialKernel::compactC2, RadialKernel::compactC6}) {
            for (const Clouds& clouds : allClouds(argc > 2)) {
                measure(clouds, kernel, csv);
            }
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
