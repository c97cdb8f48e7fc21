// SPDX-License-Identifier: GPL-3.0-or-later
// A disc with a hole, biquadratic: what the two rules for cut elements cost and
// how accurate they are.
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/refinement.hpp"
#include "geometry/trimming/PatchQuadrature.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>

namespace {

using namespace tokay::geometry;

const double pi = std::acos(-1.0);

NurbsCurve circle(double x, double y, double radius) {
    return arc(Point(x, y, 0), radius, 0.3, 0.3 + 2 * pi);
}

TrimmedPatch discWithHole(int nSpans) {
    return TrimmedPatch(refine(rectangle(Point::Zero(), 1, 1), 2, 2, nSpans, nSpans),
                        {TrimmingLoop(LoopKind::outer, {circle(0.5, 0.5, 0.45)}),
                         TrimmingLoop(LoopKind::inner, {reversed(circle(0.55, 0.45, 0.15))})});
}

struct Result {
    std::size_t nPoints = 0;
    double areaError = 0, momentError = 0, seconds = 0;
};

Result measured(const TrimmedPatch& patch, const QuadratureOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const PatchQuadrature quadrature(patch, options);
    Result result;
    double area = 0, moment = 0;
    for (int element = 0; element < patch.nElements(); ++element) {
        for (const ParameterPoint& point : quadrature.points(element)) {
            ++result.nPoints;
            area += point.weight;
            moment += point.weight * point.xi * point.xi;
        }
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    result.seconds = time.count();
    const auto secondMoment = [](double x, double r) { return pi * r * r * (r * r / 4 + x * x); };
    result.areaError = std::abs(area - pi * (0.45 * 0.45 - 0.15 * 0.15));
    result.momentError = std::abs(moment - secondMoment(0.5, 0.45) + secondMoment(0.55, 0.15));
    return result;
}

} // namespace

int main(int argc, char** argv) {
    const std::string header =
        "rule,spans_a_side,option,cut_elements,points,area_error,second_moment_error,seconds\n";
    std::string table = header;
    const bool isQuick = argc > 2;
    for (const int nSpans : isQuick ? std::vector<int>{1, 10} : std::vector<int>{1, 10, 100}) {
        const TrimmedPatch patch = discWithHole(nSpans);
        const auto add = [&](const char* rule, const std::string& option,
                             const QuadratureOptions& options) {
            const Result r = measured(patch, options);
            table += fmt::format("{},{},{},{},{},{:.1e},{:.1e},{:.2g}\n", rule, nSpans, option,
                                 patch.elements(ElementState::cut).size(), r.nPoints, r.areaError,
                                 r.momentError, r.seconds);
        };
        for (const int nAlong : {2, 4, 6, 8, 10, 0}) {
            QuadratureOptions options;
            options.nAlong = nAlong;
            add("boundaryExact", fmt::format("nAlong {}", nAlong), options);
        }
        for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
            QuadratureOptions options;
            options.rule = CutRule::triangulated;
            options.chordTolerance = tolerance;
            add("triangulated", fmt::format("chordTolerance {:.0e}", tolerance), options);
        }
    }
    fmt::print("{}", table);
    if (argc > 1) {
        std::ofstream(argv[1]) << table;
    }
}
