// SPDX-License-Identifier: GPL-3.0-or-later
// What the rules that integrate cut elements cost and bring in a trimmed plate whose exact
// solution is known: the clamped disc that is cut out of a square patch. Points of the
// cut elements, seconds of the processor for the points and for model and solution, and
// errors over the disc, integrated by points of their own.
// Usage: cutRules FILE [quick]
#include "common/errors.hpp"
#include "exampleShell.hpp"
#include "geometry/projection/SurfaceProjector.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/trimming/PatchQuadrature.hpp"
#include "trimmedDisc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace tokay;
using namespace tokay::structure;
using geometry::CutRule;
using geometry::QuadratureOptions;

double secondsSince(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Errors of w and u over the disc, relative to the norms of the solution.
struct Errors {
    double deflection = 0, displacement = 0;
};

Errors errorsOnDisc(const Shell& shell, const Eigen::VectorXd& d) {
    const geometry::SurfaceProjector projector(shell.patches()[0]->surface());
    const geometry::QuadratureRule& radial = geometry::gaussLegendre(40);
    constexpr int nAngles = 80;
    Eigen::Array2d error = Eigen::Array2d::Zero(), size = Eigen::Array2d::Zero();
    for (std::size_t k = 0; k < radial.points.size(); ++k) {
        const double radius = radial.points[k];
        for (int j = 0; j < nAngles; ++j) {
            const double angle = 2 * M_PI * j / nAngles;
            const double x = radius * std::cos(angle);
            const double y = radius * std::sin(angle);
            const geometry::SurfaceProjection place = projector.closest({x, y, 0});
            const Eigen::Vector3d u = shell.stateAt(0, place.xi, place.eta, d).displacement;
            const Eigen::Vector3d exact = TrimmedDisc::displacement(x, y);
            const double weight = radial.weights[k] * radius;
            error += weight * Eigen::Array2d(std::pow(u[2] - exact[2], 2),
                                             (u - exact).head<2>().squaredNorm());
            size += weight * Eigen::Array2d(exact[2] * exact[2], exact.head<2>().squaredNorm());
        }
    }
    const Eigen::Array2d relative = (error / size).sqrt();
    return {relative[0], relative[1]};
}

struct Rule {
    const char* name;
    std::string option;
    QuadratureOptions options;
};

std::vector<Rule> rules() {
    std::vector<Rule> all;
    for (const int nAlong : {1, 2, 3, 4, 6, 0}) {
        QuadratureOptions options;
        options.nAlong = nAlong;
        all.push_back(
            {"boundaryExact", nAlong == 0 ? "default" : fmt::format("nAlong {}", nAlong), options});
    }
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
        QuadratureOptions options;
        options.rule = CutRule::triangulated;
        options.chordTolerance = tolerance;
        all.push_back({"triangulated", fmt::format("chordTolerance {:.0e}", tolerance), options});
    }
    return all;
}

struct Cost {
    std::size_t nPoints = 0;
    double area = 0, seconds = 0;
};

/// Of the points of cut elements; the best of a few times.
Cost costOf(const geometry::TrimmedPatch& patch, const QuadratureOptions& options) {
    Cost cost;
    cost.seconds = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < 3; ++repetition) {
        const std::clock_t start = std::clock();
        const geometry::PatchQuadrature quadrature(patch, options);
        std::size_t nPoints = 0;
        for (const int element : patch.elements(geometry::ElementState::cut)) {
            nPoints += quadrature.points(element).size();
        }
        cost.nPoints = nPoints;
        cost.seconds = std::min(cost.seconds, secondsSince(start));
    }
    cost.area = area(geometry::PatchQuadrature(patch, options));
    return cost;
}

std::string row(const Rule& rule, int degree, int nElements) {
    ShellDescription disc = discShell({}, degree, nElements, 1);
    disc.cutRule = rule.options;
    const geometry::TrimmedPatch patch = disc.model.patch(0);
    const Cost cost = costOf(patch, rule.options);
    const std::clock_t start = std::clock();
    Shell shell(std::move(disc));
    double seconds = 0;
    std::string errors = "fails,fails"; // of so few points that the springs do not hold the rim
    try {
        const Eigen::VectorXd d = solveStatic(shell);
        seconds = secondsSince(start);
        const Errors found = errorsOnDisc(shell, d);
        errors = fmt::format("{:.3e},{:.3e}", found.deflection, found.displacement);
    } catch (const SolverError&) {
        seconds = secondsSince(start);
    }
    return fmt::format("{},{},{},{},{},{},{:.2e},{:.3f},{:.1e},{}\n", rule.name, rule.option,
                       degree, nElements, patch.elements(geometry::ElementState::cut).size(),
                       cost.nPoints, cost.seconds, seconds, std::abs(cost.area / M_PI - 1), errors);
}

} // namespace

int main(int argc, char** argv) {
    try {
        std::ofstream file(argv[1]);
        const auto write = [&](const std::string& line) {
            fmt::print("{}", line);
            std::fflush(stdout);
            file << line;
        };
        write("rule,option,degree,elements,cut_elements,cut_points,points_processor_seconds,"
              "processor_seconds,area_error,w_error,u_error\n");
        for (const int degree : {2, 3, 4}) {
            for (const int n : argc > 2 ? std::vector<int>{12} : std::vector<int>{12, 24, 48}) {
                for (const Rule& rule : rules()) {
                    write(row(rule, degree, n));
                }
            }
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
