// SPDX-License-Identifier: GPL-3.0-or-later
#include "interfaces.hpp"
#include "mapper/Stopwatch.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/rbf/RbfMapping.hpp"
#include "pairs.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::benchmark {

namespace {

using Eigen::VectorXd;
using mapper::Mapping;

/// Points over a hole are counted, not refused.
const mapper::GapLimit gapLimit{0.01, false};
/// Between points, a cell.
const mapper::GapLimit pointGapLimit{0.1, false};
/// Beyond it the dense matrix of the thin plate takes minutes.
constexpr int mostThinPlatePoints = 4500;

struct Method {
    std::string name;
    std::function<std::unique_ptr<Mapping>(const Setup&)> make;
    /// Whether it gives values of the destination, not samples.
    bool givesValues = false;
    /// Whether it takes coefficients of splines.
    bool takesSplines = false;
};

Method radial(const std::string& name, mapper::RadialKernel kernel, mapper::RbfSolution solution) {
    return {name, [=](const Setup& setup) {
                mapper::RbfOptions options;
                options.kernel = kernel;
                options.solution = solution;
                options.gapLimit = pointGapLimit;
                return std::make_unique<mapper::RbfMapping>(setup.from->coordinates(),
                                                            setup.samples, options);
            }};
}

Method mortar(const std::string& name, mapper::MortarBasis basis) {
    return {name,
            [=](const Setup& setup) {
                mapper::MortarOptions options;
                options.basis = basis;
                options.singular = mapper::SingularMass::minimumNorm;
                options.gapLimit = gapLimit;
                return setup.mortar(options);
            },
            true, true};
}

std::vector<Method> methodsFor(const Pair& pair) {
    std::vector<Method> methods = {mortar("mortar", mapper::MortarBasis::standard)};
    if (pair.hasDual) {
        methods.push_back(mortar("mortarDual", mapper::MortarBasis::dual));
    }
    if (pair.onlyMortar) {
        return methods;
    }
    methods.push_back({"nearestNeighbour", [](const Setup& setup) {
                           return std::make_unique<mapper::NearestElementMapping>(
                               mapper::PointCloud(setup.from->coordinates()), setup.samples,
                               pointGapLimit);
                       }});
    methods.push_back({"nearestElement",
                       [](const Setup& setup) {
                           return std::make_unique<mapper::NearestElementMapping>(
                               *setup.from, setup.samples, gapLimit);
                       },
                       false, true});
    using mapper::RadialKernel;
    using mapper::RbfSolution;
    methods.push_back(radial("rbfThinPlate", RadialKernel::thinPlate, RbfSolution::global));
    methods.push_back(
        radial("rbfPartition", RadialKernel::thinPlate, RbfSolution::partitionOfUnity));
    methods.push_back(radial("rbfC2", RadialKernel::compactC2, RbfSolution::global));
    methods.push_back(radial("rbfC6", RadialKernel::compactC6, RbfSolution::global));
    return methods;
}

struct Errors {
    double mean, largest;
};

Errors errorsOf(const VectorXd& samples, const Setup& setup, Field field, bool leavesOutHole) {
    double squared = 0, largest = 0;
    int n = 0;
    for (Eigen::Index i = 0; i < samples.size(); ++i) {
        const Point x = setup.samples.row(i);
        if (leavesOutHole && isInHole(x)) {
            continue;
        }
        const double error = std::abs(samples[i] - valueOf(field, x));
        squared += error * error;
        largest = std::max(largest, error);
        ++n;
    }
    return {std::sqrt(squared / n), largest};
}

/// How far a result leaves the range of the shock, 0 to 1.
double overshootOf(const VectorXd& samples) {
    return std::max({0.0, samples.maxCoeff() - 1, -samples.minCoeff()});
}

double applySeconds(const Mapping& mapping, const VectorXd& values) {
    constexpr int nTimes = 5;
    const mapper::Stopwatch watch;
    for (int i = 0; i < nTimes; ++i) {
        mapping.apply(values);
    }
    return watch.seconds() / nTimes;
}

Row rowOf(const Pair& pair, int n, const Method& method, const Setup& setup) {
    const auto mapping = method.make(setup);
    const bool leavesOutHole = pair.name.find("trimmed") != std::string::npos;
    VectorXd samples[nFields];
    Errors errors[nFields];
    for (const Field field : {smooth, shock}) {
        const VectorXd mapped = mapping->apply(setup.values[field]);
        samples[field] = method.givesValues ? setup.sampled(mapped) : mapped;
        errors[field] = errorsOf(samples[field], setup, field, leavesOutHole);
    }
    const mapper::MappingReport& report = mapping->report();
    const auto expected = pair.orders.find(method.name);
    return {pair.name,
            method.name,
            n,
            setup.from->nValues(),
            setup.nTo,
            report.seconds,
            applySeconds(*mapping, setup.values[smooth]),
            report.bytes / 1e6,
            errors[smooth].mean,
            errors[smooth].largest,
            errors[shock].mean,
            overshootOf(samples[shock]),
            report.forceSumError,
            report.momentError,
            expected == pair.orders.end() ? 0 : expected->second};
}

} // namespace

void measure(const Pair& pair, int n, Table& table) {
    const Setup setup = pair.make(n);
    for (const Method& method : methodsFor(pair)) {
        if (setup.hasSplinesFrom && !method.takesSplines) {
            continue;
        }
        if (method.name == "rbfThinPlate" && setup.from->nValues() > mostThinPlatePoints) {
            continue;
        }
        table.add(rowOf(pair, n, method, setup));
    }
}

} // namespace tokay::benchmark
