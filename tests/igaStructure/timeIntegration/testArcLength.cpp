// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "igaStructure/kinematics/beam/exampleBeam.hpp"
#include "igaStructure/timeIntegration/ArcLength.hpp"
#include "igaStructure/timeIntegration/ImplicitStepper.hpp"
#include "igaStructure/timeIntegration/SpringChain.hpp"
#include "igaStructure/timeIntegration/Springs.hpp"
#include "igaStructure/timeIntegration/findLimitPoint.hpp"

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;
using testing::HasSubstr;
using testing::Not;

namespace {

// Half of von Mises' truss: a bar that rises by h over its base b, its upper end
// on a vertical slider. With the strain of Green and Lagrange the force is
// E A / 2 L^3 ((h + w)^3 - h^2 (h + w)), w the slider's displacement.
Beam truss(double h, double EA, const std::string& load = "-t") {
    BeamSection section;
    section.axialStiffness = EA;
    section.mass = 1;
    BeamLoads loads;
    loads.ends.push_back(endForce("0", load));
    return {geometry::line({0, 0, 0}, {1, h, 0}),
            section,
            Strains::nonlinear,
            {{BeamEnd::start, true, true, false}, {BeamEnd::end, true, false, false}},
            loads};
}

// Load at which the truss snaps.
double limitLoad(double h, double EA) {
    return EA * std::pow(h / std::hypot(1, h), 3) / (3 * std::sqrt(3));
}

// The spline of degree 3 that interpolates a sin(pi x / L) at its Greville
// abscissae, over the half span.
geometry::NurbsCurve sineArch(double rise, double span, int elements) {
    const geometry::NurbsCurve straight =
        geometry::refine(geometry::line({0, 0, 0}, {0.5 * span, 0, 0}), 4, elements);
    const std::vector<double> xi = straight.knotVector().grevilleAbscissae();
    const auto n = static_cast<int>(xi.size());
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, n);
    VectorXd heights(n);
    for (int i = 0; i < n; ++i) {
        const geometry::CurveBasis basis = straight.basis(xi[i], 0);
        values.block(i, basis.first, 1, basis.N.cols()) = basis.N.row(0);
        heights[i] = rise * std::sin(0.5 * M_PI * xi[i]);
    }
    geometry::Points points = straight.controlPoints();
    points.col(1) = values.partialPivLu().solve(heights);
    return straight.withControlPoints(points);
}

} // namespace

TEST(ArcLength, follows_von_Mises_truss_through_both_limit_points) {
    const double h = 0.1;
    const double EA = 1000;
    Beam line = truss(h, EA);
    ArcLength path(line, NewtonOptions{1e-10, 25, true}, {2000, 2}, 0.02, 0.5);
    const double L = std::hypot(1, h);
    double highest = 0;
    double lowest = 0;
    int nSteps = 0;
    while (path.state().time < 0.5 && ++nSteps < 2000) {
        path.advance();
        const double height = h + endDisplacement(line, path.state().displacement)[1];
        const double exact = -EA / (2 * std::pow(L, 3)) * (std::pow(height, 3) - h * h * height);
        ASSERT_NEAR(path.state().time, exact, 1e-8);
        highest = std::max(highest, height > 0 ? path.state().time : 0);
        lowest = std::min(lowest, path.state().time);
    }
    EXPECT_LT(nSteps, 2000);
    EXPECT_EQ(path.state().time, 0.5);
    const double limit = limitLoad(h, EA);
    // The path passes the limit between two steps: an error of their square.
    EXPECT_NEAR(highest, limit, 0.01 * limit);
    EXPECT_LE(highest, limit * (1 + 1e-8));
    EXPECT_NEAR(lowest, -limit, 0.01 * limit);
    EXPECT_LT(endDisplacement(line, path.state().displacement)[1], -2 * h); // snapped through
}

TEST(ArcLength, does_not_jump_to_an_equilibrium_at_the_end_beyond_its_arc) {
    // The first arc passes the end, at which the truss is in balance only where it has
    // snapped through, by more than 2 h; under this load Newton's method finds that at once.
    const double h = 0.1;
    const double EA = 1000;
    const double end = 6 * limitLoad(h, EA);
    Beam line = truss(h, EA);
    ArcLength path(line, NewtonOptions{1e-10, 25, true}, {2000, 1}, 1.05 * end, end);
    double before = 0;
    while (path.state().time < end) {
        path.advance();
        const double w = endDisplacement(line, path.state().displacement)[1];
        // The limit load would move the linear truss by h / sqrt(27): the first step's makes an
        // arc of 1.05 * 6 / sqrt(27) h = 1.212 h
        EXPECT_LT(std::abs(w - before), 1.22 * h);
        before = w;
    }
    EXPECT_LT(before, -2 * h);
}

TEST(ArcLength, shallow_sine_arch_snaps_at_the_load_of_the_shallow_theory) {
    // y = a sin(pi x / L) under q sin(pi x / L): with the amplitude b,
    // q = (pi/L)^4 (E I (a - b) + E A (a^2 - b^2) b / 4), largest at
    // b^2 = (a^2 - 4 I / A) / 3. The rise is 5 radii of gyration: beyond 7 the arch
    // would buckle into three half waves first.
    const double a = 0.1;
    const double L = 10;
    BeamSection section;
    section.thickness = 0.07;
    section.axialStiffness = 1e6 * 0.07;
    section.bendingStiffness = 1e6 * std::pow(0.07, 3) / 12;
    section.mass = 1;
    const double b = std::sqrt((a * a - 4 * section.bendingStiffness / section.axialStiffness) / 3);
    const double limit = std::pow(M_PI / L, 4) * (section.bendingStiffness * (a - b) +
                                                  section.axialStiffness * (a * a - b * b) * b / 4);
    BeamLoads loads;
    loads.tractions.push_back({Formula("0", ""), Formula("-t*sin(pi*x/10)", "")});
    Beam line(sineArch(a, L, 16), section, Strains::nonlinear,
              {{BeamEnd::start, true, true, false}, {BeamEnd::end, true, false, true}}, loads);
    ArcLength path(line, NewtonOptions{1e-9, 25, true}, {500, 1}, 0.02 * limit, 10 * limit);
    double highest = 0;
    double previous = 0;
    for (int step = 0; step < 500 && path.state().time >= previous; ++step) {
        previous = path.state().time;
        path.advance();
        highest = std::max(highest, path.state().time);
    }
    EXPECT_LT(path.state().time, previous); // the load fell after the limit
    // Terms that the shallow theory leaves out: the slope squared, 1e-3.
    EXPECT_NEAR(highest, limit, 0.005 * limit);
}

TEST(ArcLength, energy_of_the_path_is_the_work_of_the_loads) {
    Beam line = truss(0.1, 1000);
    ArcLength path(line, NewtonOptions{1e-10, 25, true}, {60, 1}, 0.002, 1);
    for (int step = 0; step < 60; ++step) {
        path.advance();
    }
    // Trapezoidal sums of a smooth path of 60 steps.
    const Energies energies = path.energies();
    EXPECT_NEAR(energies.strain, energies.externalWork, 1e-3 * energies.strain);
}

TEST(ArcLength, loads_without_a_factor_of_time_are_reported) {
    ExampleBeam kind;
    kind.loads.ends.push_back(endForce("0", "1"));
    Beam line = kind.build();
    ArcLength path(line, {}, {}, 0.1, 1);
    try {
        path.advance();
        FAIL();
    } catch (const SolverError& error) {
        EXPECT_THAT(error.what(), HasSubstr("give them a factor t"));
    }
}

TEST(ArcLength, ends_exactly_at_the_end_although_loads_are_defined_up_to_there_only) {
    // The load is no number beyond the end, where it is 0.12; its limit is 0.19.
    for (const double firstStep : {0.15, 0.04, 0.011}) {
        Beam line = truss(0.1, 1000, "t > 0.15 ? sqrt(-1) : -0.8*t");
        ArcLength path(line, NewtonOptions{1e-10, 25, true}, {}, firstStep, 0.15);
        for (int step = 0; step < 200 && path.state().time < 0.15; ++step) {
            ASSERT_NO_THROW(path.advance()) << firstStep;
        }
        EXPECT_EQ(path.state().time, 0.15) << firstStep;
    }
}

TEST(ArcLength, iterate_outside_the_range_of_loads_is_a_failed_step_and_not_the_formulas_fault) {
    // A path that turns back at t = 0.19: the prediction of a long first step goes beyond
    // 0.25, where the load is no number.
    Beam line = truss(0.1, 1000, "t > 0.25 ? 1/0 : -t");
    ArcLength path(line, NewtonOptions{1e-10, 25, true}, {100, 1}, 0.5, 1);
    for (int step = 0; step < 3; ++step) {
        ASSERT_NO_THROW(path.advance());
    }
    EXPECT_LE(path.state().time, limitLoad(0.1, 1000) * (1 + 1e-8));
}

TEST(ArcLength, steps_grow_on_an_easy_path_up_to_their_limit) {
    Springs springs(
        1, [](double u) { return u + 0.01 * u * u * u; },
        [](double u) { return 1 + 0.03 * u * u; });
    springs.load = [](double t) { return t; };
    ArcLength path(springs, NewtonOptions{1e-10}, {100, 4}, 0.01, 1);
    double before = 0;
    std::vector<double> steps;
    while (path.state().time < 1) {
        path.advance();
        steps.push_back(path.state().displacement[0] - before);
        before = path.state().displacement[0];
    }
    EXPECT_NEAR(steps[0], 0.01, 1e-5);
    EXPECT_NEAR(*std::max_element(steps.begin(), steps.end()), 0.04, 1e-5);
    EXPECT_LT(steps.size(), 35u); // 100 of the first one
    EXPECT_EQ(path.state().time, 1);
}

TEST(ArcLength, steps_double_at_most_where_no_iteration_is_needed) {
    Springs springs(
        1, [](double u) { return u; }, [](double) { return 1; });
    // No formula is asked for a time before the start.
    springs.load = [](double t) { return t < 0 ? NAN : t; };
    ArcLength path(springs, NewtonOptions{1e-10}, {100, 8}, 0.01, 1);
    double before = 0;
    for (const double length : {0.01, 0.02, 0.04, 0.08, 0.08}) { // eight times the first at most
        const StepEffort effort = path.advance();
        EXPECT_NEAR(path.state().displacement[0] - before, length, 1e-10);
        EXPECT_EQ(effort.nIterations, 1); // the prediction
        EXPECT_EQ(effort.note,
                  "arcLength, arc " + std::to_string(std::lround(length / 0.01)) + " of the first");
        before = path.state().displacement[0];
    }
}

namespace {

/// Two bodies on cubic springs, under loads that grow.
SpringChain stiffeningChain() {
    SpringChain chain({[](double) { return 0.0; }, std::nullopt, std::nullopt});
    chain.cubic = 300;
    chain.load = [](double t) { return t; };
    return chain;
}

} // namespace

TEST(ArcLength, steps_grow_with_the_root_of_five_over_their_iterations) {
    SpringChain chain = stiffeningChain();
    ArcLength path(chain, NewtonOptions{1e-12}, {100, 1e9}, 1, 1e4);
    double expected = 0;
    std::set<int> counts;
    for (int step = 0; step < 6; ++step) {
        const VectorXd before = path.state().displacement;
        const StepEffort effort = path.advance();
        const double arc = (path.state().displacement - before).norm();
        if (step > 0) {
            EXPECT_NEAR(arc, expected, 1e-6 * expected);
        }
        const int nIterations = effort.nIterations - 1; // but for the prediction
        counts.insert(nIterations);
        expected = arc * std::min(2.0, std::sqrt(5.0 / nIterations));
    }
    EXPECT_GE(counts.size(), 2U);
}

TEST(ArcLength, steps_end_on_their_arc_however_loose_the_tolerance_of_forces) {
    SpringChain chain = stiffeningChain();
    constexpr double tolerance = 0.3;
    ArcLength path(chain, NewtonOptions{tolerance}, {100, 1}, 10, 1e4);
    double first = 0;
    for (int step = 0; step < 5; ++step) {
        const VectorXd before = path.state().displacement;
        EXPECT_LE(path.advance().residual, tolerance);
        const double arc = (path.state().displacement - before).norm();
        first = step == 0 ? arc : first;
        EXPECT_NEAR(arc, first, 1e-6 * first); // of the square of the arc
    }
}

TEST(ArcLength, iterations_are_as_many_as_are_allowed) {
    SpringChain chain = stiffeningChain();
    const auto firstStep = [&](int maxIterations) {
        ArcLength path(chain, NewtonOptions{1e-12, maxIterations}, {}, 10, 1e4);
        const int nSolutions = path.advance().nIterations;
        return std::pair(nSolutions, path.state().displacement.norm());
    };
    const auto [nSolutions, arc] = firstStep(25);
    const int needed = nSolutions - 1; // but for the prediction
    ASSERT_GE(needed, 2);
    EXPECT_NEAR(firstStep(needed).second, arc, 1e-9 * arc);
    EXPECT_LT(firstStep(needed - 1).second, 0.51 * arc); // failed, and half of it taken or less
}

TEST(ArcLength, never_leaves_the_body_inside_out) {
    // A neo-Hookean bar that is pressed, whose first arc leads beyond its length: there the
    // equation of forces has another solution.
    Springs bar(
        1, [](double u) { return 1 + u - 1 / (1 + u); },
        [](double u) { return 1 + 1 / ((1 + u) * (1 + u)); });
    bar.ratio = [](double u) { return 1 + u; };
    bar.load = [](double t) { return -t; };
    ArcLength path(bar, NewtonOptions{1e-10}, {}, 3, 100); // an arc of 1.5
    for (int step = 0; step < 5; ++step) {
        path.advance();
        EXPECT_GT(path.state().displacement[0], -1);
    }
}

namespace {

/// A spring of stiffness 1 on which a load of t and another one of t u act: u = t / (1 - t).
class FollowedSpring : public Springs {
  public:
    FollowedSpring()
        : Springs(
              1, [](double u) { return u; }, [](double) { return 1; }) {
        load = [](double t) { return t; };
    }
    void addFollowerForce(const VectorXd& displacement, double time,
                          VectorXd& force) const override {
        force += time * displacement;
    }
    void subtractFollowerDerivative(const VectorXd&, double time,
                                    SparseMatrix& tangent) const override {
        tangent.coeffRef(0, 0) -= time;
    }
};

} // namespace

TEST(ArcLength, loads_that_follow_the_displacement_are_in_balance_on_the_path) {
    FollowedSpring spring;
    ArcLength path(spring, NewtonOptions{1e-12}, {100, 4}, 0.05, 0.8);
    double before = 0;
    double work = 0;
    while (path.state().time < 0.8) {
        EXPECT_LE(path.advance().nIterations, 6); // of Newton's method with the exact tangent
        const double t = path.state().time;
        const double u = path.state().displacement[0];
        EXPECT_NEAR(u, t / (1 - t), 1e-9 * u);
        work += 0.5 * (u + before) * (u - before); // the force is u: exact by the trapezoidal rule
        EXPECT_NEAR(path.energies().externalWork, work, 1e-9 * work);
        before = u;
    }
    EXPECT_NEAR(path.state().displacement[0], 4, 1e-8);
}

TEST(ArcLength, ends_iterations_at_the_rounding_error_of_internal_forces) {
    // A noise of a fifth of the rounding error of a stiffness of 1e6, and no tolerance.
    Springs springs(
        2,
        [](double u) {
            return 1e6 * (u + 0.1 * u * u) +
                   0.2e6 * std::numeric_limits<double>::epsilon() * std::sin(1e18 * u);
        },
        [](double u) { return 1e6 * (1 + 0.2 * u); });
    springs.load = [](double t) { return 1e6 * t; };
    ArcLength path(springs, NewtonOptions{1e-30}, {}, 0.3, 1);
    while (path.state().time < 1) {
        EXPECT_LT(path.advance().nIterations, 10); // in the first attempt
    }
    EXPECT_NEAR(path.state().displacement[0], std::sqrt(35.0) - 5, 1e-12);
}

TEST(ArcLength, reactions_are_in_balance_with_loads_on_supports_too) {
    // A body on a spring beside its support, a load t on each.
    SpringChain chain({[](double) { return 0.0; }, std::nullopt});
    chain.cubic = 3;
    chain.load = [](double t) { return t; };
    ArcLength path(chain, NewtonOptions{1e-12}, {}, 0.3, 1);
    while (path.state().time < 1) {
        path.advance();
        EXPECT_NEAR(path.state().reaction[0], -2 * path.state().time, 1e-11);
        EXPECT_EQ(path.state().reaction[1], 0);
    }
}

namespace {

/// Two springs of stiffness 1 under loads t and, from t = 1, tan(angle) (t - 1): the path
/// (u1, u2) is straight but for one turn.
class TurningPath : public Springs {
  public:
    explicit TurningPath(double degrees)
        : Springs(
              2, [](double u) { return u; }, [](double) { return 1; }),
          slope_(std::tan(degrees * M_PI / 180)) {}
    const VectorXd& externalForce(double time) override {
        loads_ = Eigen::Vector2d(time, slope_ * std::max(0.0, time - 1));
        return loads_;
    }

  private:
    double slope_;
    VectorXd loads_;
};

/// Length of the step over the turn, which begins 0.01 before it, in arcs of 0.33.
double arcsOverTurn(double degrees, double end) {
    constexpr double arc = 0.33;
    TurningPath springs(degrees);
    ArcLength path(springs, NewtonOptions{1e-12}, {100, 1}, arc, end);
    for (int step = 0; step < 3; ++step) {
        path.advance();
    }
    const VectorXd before = path.state().displacement;
    EXPECT_NEAR(before[0], 0.99, 1e-12);
    path.advance();
    return (path.state().displacement - before).norm() / arc;
}

} // namespace

TEST(ArcLength, steps_turn_by_60_degrees_at_most) {
    // Chords over a turn of a, by the law of sines: a - asin(0.01 sin(a) / arc) degrees.
    EXPECT_NEAR(arcsOverTurn(55, 100), 1, 1e-6);
    EXPECT_NEAR(arcsOverTurn(61, 100), 1, 1e-6);    // 59.5
    EXPECT_NEAR(arcsOverTurn(63, 100), 0.5, 1e-6);  // 61.5, then 59.9
    EXPECT_NEAR(arcsOverTurn(65, 100), 0.25, 1e-6); // 63.4, 61.9, then 58.7
}

TEST(ArcLength, step_to_the_end_turns_by_60_degrees_at_most_too) {
    // To the end at t = 1.05 the chord is (0.06, 0.05 tan(a)), well within the arc.
    const double chord = std::hypot(0.06, 0.05 * std::tan(64 * M_PI / 180)); // by 59.7 degrees
    EXPECT_NEAR(arcsOverTurn(64, 1.05), chord / 0.33, 1e-9);
    EXPECT_NEAR(arcsOverTurn(65, 1.05), 0.25, 1e-6); // not by 60.8, but as without an end
}

namespace {

/// Factorisations on the way of a thin cantilever that an end moment, which grows with time,
/// rolls up to a half circle, by arcs.
int nSolutionsRollingUp(bool mixedStresses) {
    ExampleBeam kind;
    kind.elements = 16;
    BeamSection section = kind.section();
    section.thickness = 0.01;
    section.axialStiffness = 1e6 * section.thickness;
    section.bendingStiffness = 1e6 * std::pow(section.thickness, 3) / 12;
    BeamLoads loads;
    loads.ends.push_back(
        endMoment(std::to_string(1e6 * M_PI / 10 * section.bendingStiffness) + "e-6*t"));
    Beam line(kind.curve(), section, Strains::nonlinear, kind.supports, loads);
    NewtonOptions newton{1e-9, 100, false};
    newton.mixedStresses = mixedStresses;
    ArcLength path(line, newton, {1000, 1}, 0.1, 1);
    int nSolutions = 0;
    for (int step = 0; step < 1000 && path.state().time < 1; ++step) {
        nSolutions += path.advance().nIterations;
    }
    const Eigen::Vector2d end = endDisplacement(line, path.state().displacement);
    // A half circle, by 16 elements of degree 4.
    EXPECT_NEAR(end[0], -10, 1e-3);
    EXPECT_NEAR(end[1], 20 / M_PI, 1e-3);
    return nSolutions;
}

} // namespace

TEST(ArcLength, thin_beam_rolls_up_in_fewer_iterations_by_mixed_stresses) {
    const int exact = nSolutionsRollingUp(false);
    const int mixed = nSolutionsRollingUp(true);
    EXPECT_LT(5 * mixed, exact);
}

namespace {

/// Two bodies on cubic springs, which note between which displacements stresses are
/// predicted.
class PredictedChain : public SpringChain {
  public:
    PredictedChain() : SpringChain({[](double) { return 0.0; }, std::nullopt, std::nullopt}) {
        cubic = 300;
        load = [](double t) { return t; };
    }
    Internal mixedInternalForce(const VectorXd& displacement, const VectorXd& linearisedAt,
                                SparseMatrix& tangent) const override {
        from.push_back(linearisedAt);
        to.push_back(displacement);
        return internalForce(displacement, tangent);
    }
    mutable std::vector<VectorXd> from, to;
};

} // namespace

TEST(ArcLength, mixed_stresses_are_predicted_from_iterate_to_iterate) {
    PredictedChain chain;
    ArcLength path(chain, NewtonOptions{1e-12}, {100, 1}, 10, 1e4);
    for (int step = 0; step < 3; ++step) {
        const VectorXd start = path.state().displacement;
        chain.from.clear();
        chain.to.clear();
        const int nIterations = path.advance().nIterations - 1; // but for the prediction
        ASSERT_EQ(static_cast<int>(chain.from.size()), nIterations);
        ASSERT_GE(nIterations, 2);
        EXPECT_EQ(chain.from[0], start);
        for (int k = 1; k < nIterations; ++k) {
            EXPECT_EQ(chain.from[k], chain.to[k - 1]);
            EXPECT_NE(chain.from[k], start);
        }
    }
}

TEST(ArcLength, path_that_ends_is_reported_with_the_reason) {
    Springs springs(
        1, [](double u) { return u < 0.5 ? u : NAN; }, [](double) { return 1; });
    springs.load = [](double t) { return t; };
    ArcLength path(springs, {}, {}, 0.1, 1);
    try {
        for (int step = 0; step < 1000; ++step) {
            path.advance();
        }
        FAIL();
    } catch (const SolverError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the equilibrium path cannot be followed"));
        EXPECT_THAT(error.what(), HasSubstr("relative residual"));
        EXPECT_NEAR(path.state().time, 0.5, 1e-3);
    }
}

TEST(FindLimitPoint, finds_the_trusses_limit_and_none_below_it) {
    const double limit = limitLoad(0.1, 1000);
    Beam line = truss(0.1, 1000);
    MotionState rest;
    rest.displacement = VectorXd::Zero(line.nUnknowns());
    rest.velocity = rest.acceleration = rest.displacement;
    const auto found = findLimitPoint(line, {}, rest, 2 * limit);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(*found, limit, 0.01 * limit); // a parabola through three points of the path
    EXPECT_FALSE(findLimitPoint(line, {}, rest, 0.9 * limit).has_value());
}

TEST(FindLimitPoint, is_exact_where_the_path_is_a_parabola) {
    Springs spring(
        1, [](double u) { return 2 * u - u * u; }, [](double u) { return 2 - 2 * u; });
    spring.load = [](double t) { return t; };
    MotionState rest;
    rest.displacement = rest.velocity = rest.acceleration = VectorXd::Zero(1);
    const auto found = findLimitPoint(spring, NewtonOptions{1e-13}, rest, 1.5);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(*found, 1, 1e-9); // points of the path have 1e-13, differences of them less
    // The same from a point on the way.
    MotionState onTheWay = rest;
    onTheWay.time = 0.96;
    onTheWay.displacement[0] = 0.8; // 1.6 - 0.64
    const auto later = findLimitPoint(spring, NewtonOptions{1e-13}, onTheWay, 1.5);
    ASSERT_TRUE(later.has_value());
    EXPECT_NEAR(*later, 1, 1e-9);
}

TEST(FindLimitPoint, is_named_where_static_load_steps_fail) {
    Beam line = truss(0.1, 1000, "-t");
    ImplicitStepper stepper(line, TimeScheme::quasiStatic(), {}, 0.05);
    std::string message;
    try {
        for (int step = 1; step <= 4; ++step) {
            stepper.advance(0.05 * step, 0.05);
        }
    } catch (const SolverError& error) {
        message = error.what();
    }
    // EA (h/L)^3 / (3 sqrt 3) = 0.1896; steps reach 0.15.
    EXPECT_THAT(message, HasSubstr("limit point at t = 0.1896"));
    EXPECT_THAT(message, HasSubstr("time.scheme arcLength"));
}

TEST(FindLimitPoint, is_not_named_where_there_is_none) {
    // A column that buckles has a second path, but its own does not end.
    ExampleBeam kind;
    kind.loads.ends.push_back(endForce("-10*t", "0"));
    Beam line = kind.build();
    ImplicitStepper stepper(line, TimeScheme::quasiStatic(), {}, 1);
    try {
        stepper.advance(1, 1);
        FAIL();
    } catch (const SolverError& error) {
        EXPECT_THAT(error.what(), HasSubstr("buckles"));
        EXPECT_THAT(error.what(), Not(HasSubstr("limit point")));
    }
}
