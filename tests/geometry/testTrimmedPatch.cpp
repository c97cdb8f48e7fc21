#include "geometry/TrimmedPatch.hpp"

#include "expectInputError.hpp"
#include "geometry/elementQuadrature.hpp"
#include "geometry/primitives.hpp"
#include "geometry/refinement.hpp"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace tokay::geometry {

namespace {

const double pi = std::acos(-1.0);
using Function = std::function<double(double, double)>;

/// Integral over the patch of a flat rectangle, whose parameters are positions / size.
double integral(const TrimmedPatch& patch, int degree, const Function& f) {
    double sum = 0;
    for (int element = 0; element < patch.nElements(); ++element)
        for (const ParameterPoint& point : elementQuadrature(patch, element, degree))
            sum += point.weight * f(point.xi, point.eta);
    return sum;
}

TrimmingLoop circle(double x, double y, double radius) {
    return {arc(Point(x, y, 0), radius, 0, 2 * pi)};
}

NurbsSurface unitSquare(int nSpans) {
    return refine(rectangle(Point::Zero(), 1, 1), 2, 2, nSpans, nSpans);
}

const TrimmingLoop outline = rectangularLoop({0, 0}, {1, 1});

} // namespace

TEST(TrimmedPatch, withoutLoopsEveryElementIsFull) {
    const TrimmedPatch patch(unitSquare(5));
    for (int element = 0; element < 25; ++element)
        EXPECT_EQ(patch.state(element), ElementState::full);
    EXPECT_NEAR(integral(patch, 4, [](double x, double y) { return x * x * y; }), 1.0 / 6, 1e-15);
}

TEST(TrimmedPatch, aDiscWithAHoleHasItsAreaAndMoments) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
        const TrimmedPatch patch(
            unitSquare(7), {circle(0.5, 0.5, 0.4), reversed(circle(0.55, 0.45, 0.15))}, tolerance);
        const double disc = pi * 0.16, hole = pi * 0.0225;
        const double error = 4 * tolerance; // chord tolerance times the circumferences
        EXPECT_NEAR(integral(patch, 2, [](double, double) { return 1; }), disc - hole, error);
        EXPECT_NEAR(integral(patch, 2, [](double x, double) { return x; }),
                    0.5 * disc - 0.55 * hole, error);
        const auto secondMoment = [](double x, double) { return (x - 0.5) * (x - 0.5); };
        EXPECT_NEAR(integral(patch, 2, secondMoment),
                    pi / 4 * (std::pow(0.4, 4) - std::pow(0.15, 4)) - hole * 0.0025, error);
    }
}

TEST(TrimmedPatch, straightLoopsAreIntegratedExactlyWhereverTheyRun) {
    // On a knot line, a little beside it, and far from one.
    for (const double offset : {0.0, 1e-12, -1e-12, 1e-8, -1e-4, 0.07}) {
        const double x = 0.4 + offset;
        const TrimmedPatch patch(unitSquare(5), {rectangularLoop({x, 0.2}, {1, 0.8 - offset})});
        const auto f = [](double a, double b) { return a * a * b; };
        const double exact = (1 - x * x * x) / 3 * (std::pow(0.8 - offset, 2) - 0.04) / 2;
        EXPECT_NEAR(integral(patch, 4, f), exact, 1e-15) << offset;
    }
}

TEST(TrimmedPatch, aTrimLineOnKnotLinesCutsNoElement) {
    const TrimmedPatch patch(unitSquare(5), {rectangularLoop({0.4, 0}, {1, 1})});
    int nFull = 0;
    for (int element = 0; element < 25; ++element) {
        EXPECT_NE(patch.state(element), ElementState::cut);
        nFull += patch.state(element) == ElementState::full;
    }
    EXPECT_EQ(nFull, 15);
}

TEST(TrimmedPatch, aHoleSmallerThanAnElementCutsItsElementOnly) {
    const TrimmedPatch patch(unitSquare(4), {outline, reversed(circle(0.6, 0.6, 0.05))}, 1e-9);
    for (int element = 0; element < 16; ++element)
        EXPECT_EQ(patch.state(element),
                  element == patch.elementNumber(2, 2) ? ElementState::cut : ElementState::full);
    EXPECT_NEAR(integral(patch, 2, [](double, double) { return 1; }), 1 - pi * 0.0025, 1e-9);
    EXPECT_FALSE(patch.contains({0.6, 0.6}));
    EXPECT_TRUE(patch.contains({0.6, 0.66}));
}

TEST(TrimmedPatch, anOutlineThatIsNotConvexAndAHoleInOneElementAddUp) {
    Points points(7, 3); // an L with its closing point
    points << 0.1, 0.1, 0, 0.9, 0.1, 0, 0.9, 0.4, 0, 0.4, 0.4, 0, 0.4, 0.9, 0, 0.1, 0.9, 0, 0.1,
        0.1, 0;
    const NurbsCurve outer(KnotVector(1, {0, 0, 1, 2, 3, 4, 5, 6, 6}), points);
    const TrimmedPatch patch(unitSquare(1),
                             {{outer}, reversed(rectangularLoop({0.2, 0.2}, {0.3, 0.3}))});
    EXPECT_NEAR(integral(patch, 1, [](double, double) { return 1; }), 0.24 + 0.15 - 0.01, 1e-15);
    EXPECT_NEAR(integral(patch, 1, [](double x, double) { return x; }),
                0.24 * 0.5 + 0.15 * 0.25 - 0.01 * 0.25, 1e-15);
}

TEST(TrimmedPatch, refusesLoopsThatAreOpenOutsideOrTheWrongWayRound) {
    const NurbsSurface square = unitSquare(2);
    expectInputError([&] { TrimmedPatch(square, {{}}); }, {"loop 0", "no curve"});
    expectInputError([&] { TrimmedPatch(square, {{arc(Point(0.5, 0.5, 0), 0.2, 0, 3)}}); },
                     {"loop 0", "not closed", "(0.7, 0.5)"});
    expectInputError(
        [&] {
            TrimmedPatch(square, {outline, circle(0.9, 0.5, 0.2)});
        },
        {"loop 1", "parameter range"});
    expectInputError([&] { TrimmedPatch(square, {reversed(outline)}); }, {"counter-clockwise"});
}

} // namespace tokay::geometry
