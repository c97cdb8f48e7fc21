// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/sampleLoops.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/refinement.hpp"
#include "geometry/trimming/PatchQuadrature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace tokay::geometry {

namespace {

const double pi = std::acos(-1.0);
using Function = std::function<double(double, double)>;

double integral(const PatchQuadrature& quadrature, const Function& f) {
    double sum = 0;
    for (int element = 0; element < quadrature.patch().nElements(); ++element) {
        for (const ParameterPoint& point : quadrature.points(element)) {
            sum += point.weight * f(point.xi, point.eta);
        }
    }
    return sum;
}

struct Moments {
    double area, x, y, xx, xy, yy;
};

Moments moments(const PatchQuadrature& quadrature) {
    return {integral(quadrature, [](double, double) { return 1; }),
            integral(quadrature, [](double x, double) { return x; }),
            integral(quadrature, [](double, double y) { return y; }),
            integral(quadrature, [](double x, double) { return x * x; }),
            integral(quadrature, [](double x, double y) { return x * y; }),
            integral(quadrature, [](double, double y) { return y * y; })};
}

Moments ofDisc(double x, double y, double radius) {
    const double area = pi * radius * radius, own = area * radius * radius / 4;
    return {area, area * x, area * y, own + area * x * x, area * x * y, own + area * y * y};
}

/// Largest difference of the two discs to what was computed.
double error(const Moments& computed, const Moments& disc, const Moments& hole) {
    return std::max(
        {std::abs(computed.area - disc.area + hole.area), std::abs(computed.x - disc.x + hole.x),
         std::abs(computed.y - disc.y + hole.y), std::abs(computed.xx - disc.xx + hole.xx),
         std::abs(computed.xy - disc.xy + hole.xy), std::abs(computed.yy - disc.yy + hole.yy)});
}

TrimmedPatch discWithHole(int nSpans) {
    return TrimmedPatch(square(nSpans), {circleLoop(LoopKind::outer, {0.5, 0.5}, 0.45),
                                         circleLoop(LoopKind::inner, {0.55, 0.45}, 0.15)});
}

double discWithHoleError(const TrimmedPatch& patch, const QuadratureOptions& options) {
    return error(moments(PatchQuadrature(patch, options)), ofDisc(0.5, 0.5, 0.45),
                 ofDisc(0.55, 0.45, 0.15));
}

/// By Green's theorem on straight sides, two Gauss points each.
double polygonIntegral(const Polygon& corners, const Function& integralOverX) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Parameters a = corners[i], side = corners[(i + 1) % corners.size()] - a;
        for (const double t : {0.5 - std::sqrt(0.6) / 2, 0.5, 0.5 + std::sqrt(0.6) / 2}) {
            const Parameters at = a + t * side;
            sum += (t == 0.5 ? 8.0 / 18 : 5.0 / 18) * side[1] * integralOverX(at[0], at[1]);
        }
    }
    return sum;
}

} // namespace

TEST(PatchQuadrature, boundary_exact_rule_integrates_a_disc_with_a_hole) {
    for (const int nSpans : {1, 2, 7, 20}) {
        EXPECT_LT(discWithHoleError(discWithHole(nSpans), {}), 1e-12) << nSpans;
    }
}

TEST(PatchQuadrature, error_of_the_boundary_exact_rule_falls_exponentially) {
    const TrimmedPatch patch = discWithHole(1);
    QuadratureOptions options;
    double before = 1;
    for (const int nAlong : {2, 4, 6, 8, 10, 12}) {
        options.nAlong = nAlong;
        const double now = discWithHoleError(patch, options);
        EXPECT_LT(now, std::max(before / 20, 1e-14)) << nAlong;
        before = now;
    }
    EXPECT_LT(before, 1e-13);
}

TEST(PatchQuadrature, error_of_the_triangulated_rule_falls_with_the_chord_tolerance) {
    for (const int nSpans : {1, 7}) {
        const TrimmedPatch patch = discWithHole(nSpans);
        QuadratureOptions options;
        options.rule = CutRule::triangulated;
        for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
            options.chordTolerance = tolerance;
            const double error = discWithHoleError(patch, options);
            // A chord of sag s loses 2/3 s over its length; circumferences 3.8.
            EXPECT_LT(error, 0.7 * tolerance / nSpans * 3.8);
            EXPECT_GT(error, 0.01 * tolerance / nSpans) << "the tolerance must matter";
        }
    }
}

TEST(PatchQuadrature, both_rules_are_exact_for_polygons) {
    // A rotated square whose corners lie anywhere, with a rotated square hole.
    Polygon outer, inner;
    for (int i = 0; i < 4; ++i) {
        const double angle = 0.3 + i * pi / 2;
        outer.push_back({0.5 + 0.47 * std::cos(angle), 0.5 + 0.47 * std::sin(angle)});
        inner.push_back({0.5 + 0.1 * std::cos(2 - angle), 0.45 + 0.1 * std::sin(2 - angle)});
    }
    const auto f = [](double x, double y) { return x * x * y * y; };
    const auto overX = [](double x, double y) { return x * x * x / 3 * y * y; };
    const double exact = polygonIntegral(outer, overX) + polygonIntegral(inner, overX);
    for (const int nSpans : {1, 3, 8}) {
        for (const CutRule rule : {CutRule::boundaryExact, CutRule::triangulated}) {
            const TrimmedPatch patch(square(nSpans), {polygonLoop(LoopKind::outer, outer),
                                                      polygonLoop(LoopKind::inner, inner)});
            QuadratureOptions options;
            options.rule = rule;
            options.degree = 2;
            EXPECT_NEAR(integral(PatchQuadrature(patch, options), f), exact, 1e-15);
        }
    }
}

TEST(PatchQuadrature, polynomial_trimming_curves_and_integrands_are_exact) {
    // Under the parabola y = x (1 - x): the integral of x^m y^n is known.
    Points points(3, 3);
    points << 1, 0, 0, 0.5, 0.5, 0, 0, 0, 0;
    const NurbsCurve parabola(KnotVector::uniform(2, 1), points);
    const TrimmingLoop loop(LoopKind::outer, {line(Point(0, 0, 0), Point(1, 0, 0)), parabola});
    for (const int nSpans : {1, 5}) {
        const TrimmedPatch patch(square(nSpans), {loop});
        // x^4 y^4: B(10, 6) / 5
        const double exact = std::tgamma(10) * std::tgamma(6) / std::tgamma(16) / 5;
        const double computed =
            integral(PatchQuadrature(patch), [](double x, double y) { return std::pow(x * y, 4); });
        EXPECT_NEAR(computed, exact, 1e-14 * exact);
    }
}

TEST(PatchQuadrature, trim_lines_on_and_beside_knot_lines_are_exact) {
    for (const double offset : {0.0, 1e-12, -1e-12, 1e-8, -1e-8, 1e-4, -1e-4}) {
        for (const CutRule rule : {CutRule::boundaryExact, CutRule::triangulated}) {
            const double x = 0.4 + 0.2 * offset, y = 0.8 - 0.2 * offset;
            const TrimmedPatch patch(
                square(5), {polygonLoop(LoopKind::outer, {{x, 0.2}, {1, 0.2}, {1, y}, {x, y}})});
            QuadratureOptions options;
            options.rule = rule;
            const double exact = (1 - x * x * x) / 3 * (y * y - 0.04) / 2;
            // Slivers of 1e-12 of an element may be left out, the rest may not.
            EXPECT_NEAR(integral(PatchQuadrature(patch, options),
                                 [](double a, double b) { return a * a * b; }),
                        exact, std::abs(offset) < 1e-11 ? 4e-13 : 2e-15)
                << offset;
        }
    }
}

TEST(PatchQuadrature, loops_anywhere_on_and_about_knot_lines_keep_their_area) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    const std::vector<double> offsets = {0,     1e-16, -1e-16, 1e-14, 1e-12, -1e-12,
                                         1e-10, 1e-8,  -1e-8,  1e-4,  -1e-4};
    for (int trial = 0; trial < 300; ++trial) {
        const int nSpans = 1 + trial % 9;
        // More than half of the coordinates lie on a knot line or about one.
        const auto place = [&](double x) {
            if (uniform(random) > 0.6) {
                return x;
            }
            const auto k = static_cast<std::size_t>(uniform(random) * offsets.size());
            return std::clamp(std::round(x * nSpans) / nSpans + offsets[k], 0.0, 1.0);
        };
        Polygon corners;
        const int nCorners = 3 + trial % 7;
        for (int i = 0; i < nCorners; ++i) {
            const double radius = 0.15 + 0.33 * uniform(random), angle = 2 * pi * i / nCorners;
            corners.push_back(
                {place(0.5 + radius * std::cos(angle)), place(0.5 + radius * std::sin(angle))});
        }
        std::vector<TrimmingLoop> loops;
        try {
            loops.push_back(polygonLoop(LoopKind::outer, corners));
        } catch (const InputError&) {
            continue; // moving the corners made them cross
        }
        const TrimmedPatch patch(square(nSpans), loops);
        const double exact = loops[0].signedArea();
        for (const CutRule rule : {CutRule::boundaryExact, CutRule::triangulated}) {
            QuadratureOptions options;
            options.rule = rule;
            options.degree = 1;
            const PatchQuadrature quadrature(patch, options);
            for (int element = 0; element < patch.nElements(); ++element) {
                for (const ParameterPoint& point : quadrature.points(element)) {
                    EXPECT_GT(point.weight, 0);
                }
            }
            // Left-out slivers: 1e-11 of each of at most 40 elements on the loop.
            EXPECT_NEAR(integral(quadrature, [](double, double) { return 1; }), exact,
                        1e-11 * 40 / (nSpans * nSpans) + 1e-15)
                << trial;
        }
    }
}

TEST(PatchQuadrature, weights_are_positive_and_points_inside) {
    const TrimmedPatch patch = discWithHole(6);
    for (const CutRule rule : {CutRule::boundaryExact, CutRule::triangulated}) {
        QuadratureOptions options;
        options.rule = rule;
        const PatchQuadrature quadrature(patch, options);
        for (int element = 0; element < patch.nElements(); ++element) {
            for (const ParameterPoint& point : quadrature.points(element)) {
                const Parameters place(point.xi, point.eta);
                const double sag = rule == CutRule::triangulated ? 1e-3 / 6 : 1e-15;
                EXPECT_GT(point.weight, 0);
                EXPECT_LT((place - Parameters(0.5, 0.5)).norm(), 0.45 + sag);
                EXPECT_GT((place - Parameters(0.55, 0.45)).norm(), 0.15 - sag);
            }
        }
    }
}

TEST(PatchQuadrature, a_cusp_keeps_positive_weights_and_its_area) {
    const TrimmingLoop cusp(LoopKind::outer,
                            {arc(Point(0.2, 0.5, 0), 0.4, -pi / 2, pi / 2),
                             line(Point(0.2, 0.9, 0), Point(0.2, 0.5, 0)),
                             reversed(arc(Point(0.2, 0.3, 0), 0.2, -pi / 2, pi / 2))});
    const TrimmedPatch patch(square(1), {cusp});
    const PatchQuadrature quadrature(patch);
    for (const ParameterPoint& point : quadrature.points(0)) {
        EXPECT_GT(point.weight, 0);
    }
    EXPECT_NEAR(integral(quadrature, [](double, double) { return 1; }), pi / 2 * (0.16 - 0.04),
                1e-13);
}

TEST(PatchQuadrature, a_hole_smaller_than_an_element_is_exact) {
    for (const double radius : {0.05, 1e-3, 1e-5}) {
        const TrimmedPatch patch(square(3), {circleLoop(LoopKind::inner, {0.55, 0.52}, radius)});
        const double area = integral(PatchQuadrature(patch), [](double, double) { return 1; });
        EXPECT_NEAR(area, 1 - pi * radius * radius, 2e-15);
    }
}

TEST(PatchQuadrature, cylinder_and_sphere_have_their_areas) {
    const double radius = 0.7, height = 2.5;
    const TrimmedPatch cylinder(cylinderPatch(Point(1, 2, 3), radius, height, 0, 2 * pi));
    QuadratureOptions options;
    options.degree = 30; // the Jacobian of a rational surface is no polynomial
    EXPECT_NEAR(area(PatchQuadrature(cylinder, options)), 2 * pi * radius * height, 1e-12);
    const TrimmedPatch fine = TrimmedPatch(cylinder).refined(2, 2, 8, 2);
    options.degree = 12;
    EXPECT_NEAR(area(PatchQuadrature(fine, options)), 2 * pi * radius * height, 1e-12);
}

TEST(PatchQuadrature, a_sphere_has_its_area_whole_and_trimmed) {
    const double radius = 1.3;
    const TrimmedPatch whole = TrimmedPatch(sphere(Point(4, 5, 6), radius)).refined(2, 2, 4, 4);
    QuadratureOptions options;
    options.degree = 16;
    EXPECT_NEAR(area(PatchQuadrature(whole, options)), 4 * pi * radius * radius, 1e-12);
    // Between two circles of latitude, as trim lines inside elements: h = 2 pi r z.
    const double from = 0.27, to = 0.71;
    const TrimmedPatch zone =
        TrimmedPatch(sphere(Point::Zero(), radius),
                     {polygonLoop(LoopKind::outer, {{0, from}, {1, from}, {1, to}, {0, to}})})
            .refined(2, 2, 4, 4);
    const double height = zone.surface().point(0, to)[2] - zone.surface().point(0, from)[2];
    EXPECT_NEAR(area(PatchQuadrature(zone, options)), 2 * pi * radius * height, 1e-12);
}

TEST(PatchQuadrature, refuses_impossible_options) {
    const TrimmedPatch patch = discWithHole(1);
    const auto with = [&](auto change) {
        return [&patch, change] {
            QuadratureOptions options;
            change(options);
            PatchQuadrature(patch, options);
        };
    };
    expectInputError(with([](auto& o) { o.degree = -1; }), {"degree", "-1"});
    expectInputError(with([](auto& o) { o.nAlong = 1000; }), {"1000"});
    expectInputError(with([](auto& o) { o.chordTolerance = 0; }), {"chord tolerance", "0"});
    expectInputError([] { cutRuleFromName("exact"); }, {"exact", "boundaryExact", "triangulated"});
}

} // namespace tokay::geometry
