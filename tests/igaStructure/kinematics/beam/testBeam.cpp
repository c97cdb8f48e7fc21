// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "exampleBeam.hpp"
#include "igaStructure/kinematics/beam/sectionMotion.hpp"

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using testing::HasSubstr;

namespace {

VectorXd randomVector(Eigen::Index size, double amplitude) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    VectorXd vector(size);
    for (double& value : vector) {
        value = uniform(generator);
    }
    return vector;
}

std::vector<ExampleBeam> kinds() {
    std::vector<ExampleBeam> kinds;
    for (Strains strains : {Strains::linear, Strains::nonlinear}) {
        for (bool arc : {false, true}) {
            ExampleBeam kind;
            kind.strains = strains;
            kind.arc = arc;
            kind.degree = 3;
            kind.elements = 4;
            kinds.push_back(kind);
        }
    }
    return kinds;
}

// Control displacements X -> R X - X + shift.
VectorXd rigidMotion(const Beam& line, double angle) {
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
    VectorXd displacement(line.nUnknowns());
    for (int k = 0; k < line.curve().nControlPoints(); ++k) {
        const Vector2d X = line.curve().controlPoints().row(k).head<2>();
        displacement.segment<2>(2 * k) = R * X - X + Vector2d(3, -2);
    }
    return displacement;
}

template <class Force>
MatrixXd differences(const VectorXd& d, double h, Force force) {
    MatrixXd result(d.size(), d.size());
    for (Eigen::Index k = 0; k < d.size(); ++k) {
        VectorXd shift = VectorXd::Zero(d.size());
        shift[k] = h;
        result.col(k) = (force(d + shift) - force(d - shift)) / (2 * h);
    }
    return result;
}

// Angular frequencies, ascending.
VectorXd frequencies(const Beam& line) {
    SparseMatrix tangent;
    line.internalForce(VectorXd::Zero(line.nUnknowns()), tangent);
    std::vector<int> free;
    for (int k = 0; k < line.nUnknowns(); ++k) {
        if (!line.fixed()[k]) {
            free.push_back(k);
        }
    }
    const MatrixXd K = MatrixXd(tangent)(free, free);
    const MatrixXd M = MatrixXd(line.massMatrix())(free, free);
    return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(K, M, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseSqrt();
}

} // namespace

TEST(Beam, mass_of_a_uniform_motion_is_the_mass_of_the_body) {
    for (ExampleBeam kind : kinds()) {
        kind.supports = {};
        const Beam line = kind.build();
        const SparseMatrix mass = line.massMatrix();
        const double exact = 10 * (kind.arc ? 0.5 * M_PI * 10 : 10);
        for (int c = 0; c < 2; ++c) {
            VectorXd uniform = VectorXd::Zero(line.nUnknowns());
            for (int k = c; k < line.nUnknowns(); k += 2) {
                uniform[k] = 1;
            }
            // 4 Gauss points an element; on the rational arc with an error of theirs.
            EXPECT_NEAR(uniform.dot(mass * uniform), exact, (kind.arc ? 1e-8 : 1e-13) * exact);
        }
    }
}

TEST(Beam, rigid_motion_gives_no_force_at_any_angle) {
    for (bool arc : {false, true}) {
        ExampleBeam kind;
        kind.arc = arc;
        kind.supports = {};
        const Beam line = kind.build();
        for (double angle : {0.1, 1.0, 0.5 * M_PI, 3.0, M_PI, 5.0, 7.0, 100.0}) {
            const VectorXd d = rigidMotion(line, angle);
            // Rounding of displacements of 20 m in strains of elements of 1 m.
            EXPECT_LT(line.internalForce(d).force.norm(), 1e-12 * kind.section().axialStiffness);
            EXPECT_LT(line.strainEnergy(d), 1e-20 * kind.section().axialStiffness);
        }
    }
}

TEST(Beam, small_rigid_rotation_gives_no_force_if_strains_are_linear) {
    ExampleBeam kind;
    kind.strains = Strains::linear;
    kind.arc = true;
    kind.supports = {};
    const Beam line = kind.build();
    VectorXd d(line.nUnknowns());
    for (int k = 0; k < line.curve().nControlPoints(); ++k) {
        d.segment<2>(2 * k) = turned(line.curve().controlPoints().row(k).head<2>().transpose());
    }
    EXPECT_LT(line.internalForce(d).force.norm(), 1e-12 * kind.section().axialStiffness * 10);
}

TEST(Beam, tangent_equals_finite_differences) {
    for (ExampleBeam kind : kinds()) {
        kind.supports.push_back({BeamEnd::end, false, false, true});
        const Beam line = kind.build();
        const VectorXd d = randomVector(line.nUnknowns(), 0.3);
        SparseMatrix tangent;
        const VectorXd force = line.internalForce(d, tangent).force;
        EXPECT_LT((force - line.internalForce(d).force).norm(), 1e-14 * force.norm());
        // Truncation and rounding errors of central differences are below 1e-8 here.
        const MatrixXd numeric =
            differences(d, 1e-5, [&](const VectorXd& x) { return line.internalForce(x).force; });
        EXPECT_LT((MatrixXd(tangent) - numeric).norm(), 1e-7 * numeric.norm());
    }
}

TEST(Beam, internal_force_is_the_derivative_of_strain_energy) {
    for (const ExampleBeam& kind : kinds()) {
        const Beam line = kind.build();
        const VectorXd d = randomVector(line.nUnknowns(), 0.3);
        const VectorXd direction = randomVector(line.nUnknowns(), 1);
        const double h = 1e-5;
        const double difference =
            (line.strainEnergy(d + h * direction) - line.strainEnergy(d - h * direction)) / (2 * h);
        const double derivative = line.internalForce(d).force.dot(direction);
        EXPECT_NEAR(difference, derivative, 1e-7 * std::abs(derivative));
    }
}

TEST(Beam, tangent_of_followers_equals_finite_differences_between_held_ends) {
    ExampleBeam kind;
    kind.arc = true;
    kind.loads.ends.push_back(endMoment("30"));
    kind.loads.pressures.emplace_back("7", "");
    kind.supports.push_back({BeamEnd::end, true, true, false});
    const Beam line = kind.build();
    VectorXd d = randomVector(line.nUnknowns(), 0.3);
    for (int k = 0; k < line.nUnknowns(); ++k) {
        if (line.fixed()[k]) {
            d[k] = 0;
        }
    }
    SparseMatrix tangent;
    line.internalForce(VectorXd::Zero(line.nUnknowns()), tangent);
    const SparseMatrix before = tangent;
    line.subtractFollowerDerivative(d, 0, tangent);
    MatrixXd numeric = differences(d, 1e-5, [&](const VectorXd& x) {
        VectorXd force = VectorXd::Zero(x.size());
        line.addFollowerForce(x, 0, force);
        return force;
    });
    MatrixXd exact = MatrixXd(before - tangent);
    for (int k = 0; k < line.nUnknowns(); ++k) {
        if (line.fixed()[k]) { // a pressure's derivative is symmetric inside only
            numeric.row(k).setZero();
            numeric.col(k).setZero();
            exact.row(k).setZero();
            exact.col(k).setZero();
        }
    }
    EXPECT_LT((exact - numeric).norm(), 1e-7 * numeric.norm());
}

TEST(Beam, end_moment_rolls_a_cantilever_up_to_a_full_circle) {
    ExampleBeam kind;
    kind.length = 12;
    kind.elements = 16;
    kind.loads.ends.push_back(endMoment("t*50*pi/3")); // 2 pi E I / L
    Beam line = kind.build();
    const std::vector<VectorXd> steps = loadSteps(line, 20);
    for (int step = 1; step <= 20; ++step) {
        const double kL = 2 * M_PI * step / 20;
        const Vector2d exact(12 * (std::sin(kL) / kL - 1), 12 * (1 - std::cos(kL)) / kL);
        // Discretisation error of degree 4 with 16 elements: 1e-5 for the full circle.
        EXPECT_LT((endDisplacement(line, steps[step - 1]) - exact).norm(), 2e-5 * 12) << step;
    }
    const BeamState state = line.stateAt(0.3, steps.back());
    EXPECT_NEAR(state.bendingMoment, 50 * M_PI / 3, 1e-4 * 50);
}

TEST(Beam, end_moment_rolls_a_cantilever_up_twice) {
    ExampleBeam kind;
    kind.elements = 32;
    kind.loads.ends.push_back(endMoment("t*40*pi")); // two full circles
    Beam line = kind.build();
    const Vector2d end = endDisplacement(line, loadSteps(line, 40).back());
    EXPECT_LT((end - Vector2d(-10, 0)).norm(), 1e-5 * 10);
}

TEST(Beam, cantilever_under_end_shear_bends_as_published) {
    ExampleBeam kind;
    kind.loads.ends.push_back(endForce("0", "4*t"));
    Beam line = kind.build();
    const std::vector<VectorXd> steps = loadSteps(line, 20);
    // Sze, Liu & Lo 2004: load share, -u, w.
    const double published[][3] = {
        {0.25, 0.563, 3.015}, {0.50, 1.604, 4.933}, {0.75, 2.541, 6.031}, {1.00, 3.286, 6.698}};
    for (const auto& row : published) {
        const Vector2d u = endDisplacement(line, steps[std::lround(row[0] * 20) - 1]);
        EXPECT_NEAR(-u[0], row[1], 0.005 * row[1]);
        EXPECT_NEAR(u[1], row[2], 0.005 * row[2]);
    }
}

TEST(Beam, resultants_balance_the_force_at_the_end_of_an_arc) {
    for (Strains strains : {Strains::linear, Strains::nonlinear}) {
        ExampleBeam kind;
        kind.strains = strains;
        kind.arc = true;
        kind.degree = 5;
        kind.elements = 64;
        kind.loads.ends.push_back(endForce("0.5*t", "0.8*t"));
        Beam line = kind.build();
        const VectorXd d = loadSteps(line, 5).back();
        const Vector2d force(0.5, 0.8);
        for (double xi : {0.21, 0.5, 0.83}) {
            // Linear: equilibrium of the reference.
            const Vector2d t =
                tangentAt(line, xi, strains == Strains::linear ? VectorXd(0 * d) : d);
            const BeamState state = line.stateAt(xi, d);
            // Discretisation error; N is 1e5 times a strain of 1e-5.
            EXPECT_NEAR(state.normalForce, force.dot(t), 2e-4 * force.norm());
            EXPECT_NEAR(state.shearForce, force.dot(turned(t)), 2e-4 * force.norm());
        }
    }
}

TEST(Beam, frequencies_of_a_cantilever_converge_with_order_2_p_minus_2) {
    for (int degree : {2, 3, 4}) {
        double errors[2];
        for (int k = 0; k < 2; ++k) {
            ExampleBeam kind;
            kind.strains = Strains::linear;
            kind.degree = degree;
            kind.elements = 4 << k;
            const double exact = std::pow(4.694091133 / 10, 2) * // second bending mode
                                 std::sqrt(kind.section().bendingStiffness / kind.section().mass);
            errors[k] = std::abs(frequencies(kind.build())[1] / exact - 1);
        }
        EXPECT_GT(std::log2(errors[0] / errors[1]), 2 * (degree - 1) - 0.3) << degree;
        EXPECT_LT(errors[1], degree == 2 ? 0.03 : 1e-3) << degree;
    }
}

TEST(Beam, rotary_inertia_lowers_a_frequency_as_Rayleighs_beam) {
    ExampleBeam kind;
    kind.strains = Strains::linear;
    kind.elements = 16;
    // Pinned ends: w_n^2 = (EI/m) k^4 / (1 + r^2 k^2), k = n pi / L, r^2 = I/A.
    kind.supports = {{BeamEnd::start, true, true, false}, {BeamEnd::end, false, true, false}};
    kind.rotaryInertia = true;
    const double k = 3 * M_PI / 10;
    const double exact = std::sqrt(kind.section().bendingStiffness / kind.section().mass *
                                   std::pow(k, 4) / (1 + 0.01 / 12 * k * k));
    EXPECT_NEAR(frequencies(kind.build())[2], exact, 1e-6 * exact); // degree 4, 16 elements
}

TEST(Beam, trapezoidal_rule_keeps_the_energy_of_a_linear_beam) {
    ExampleBeam kind;
    kind.strains = Strains::linear;
    kind.arc = true;
    kind.loads.ends.push_back(endForce("0", "0.3"));
    Beam line = kind.build();
    TimeIntegrator integrator(line, TimeScheme::newmark(0.25, 0.5), {}, 0);
    for (int step = 1; step <= 50; ++step) {
        integrator.beginTimeStep(step * 0.5, 0.5);
        integrator.solve();
        integrator.acceptTimeStep();
        const Energies& energies = integrator.energies();
        // The axial stiffness, 1e6 times the bending stiffness, loses digits.
        EXPECT_NEAR(energies.kinetic + energies.strain, energies.externalWork,
                    1e-8 * energies.externalWork);
    }
}

TEST(Beam, held_rotation_is_exact_however_far_the_end_moves) {
    ExampleBeam kind;
    kind.arc = true;
    // A slider: keeps its direction, moves freely.
    kind.supports.push_back({BeamEnd::end, false, false, true});
    kind.loads.ends.push_back(endForce("-3*t", "-3*t"));
    Beam line = kind.build();
    const VectorXd d = loadSteps(line, 10).back();
    EXPECT_GT(endDisplacement(line, d).norm(), 1);
    EXPECT_NEAR(cross(tangentAt(line, 1, d), {-1, 0}), 0, 1e-12);
    EXPECT_NEAR(cross(tangentAt(line, 0, d), {0, 1}), 0, 1e-12);
}

TEST(Beam, pressure_on_a_ring_gives_Barlows_hoop_force) {
    // A quarter of a ring with sliders on both ends under inner pressure: the
    // inside is left of the axis.
    ExampleBeam kind;
    kind.arc = true;
    kind.supports = {{BeamEnd::start, false, true, true}, {BeamEnd::end, true, false, true}};
    kind.loads.pressures.emplace_back("100*t", "");
    Beam line = kind.build();
    const VectorXd d = loadSteps(line, 1).back();
    const double radius = 10 + endDisplacement(line, d)[1];
    // The axial force is conjugate to Green-Lagrange strain: N = p r / stretch.
    const double stretch = radius / 10;
    EXPECT_NEAR(line.stateAt(0.4, d).normalForce, 100 * radius / stretch, 1e-3 * 1000);
    EXPECT_NEAR(endDisplacement(line, d)[1], 0.0833, 0.02 * 0.0833); // p r^2 / E A, small strain
}

TEST(Beam, free_rigid_motions_are_named) {
    ExampleBeam kind;
    EXPECT_TRUE(kind.build().freeRigidMotions().empty());
    kind.supports = {{BeamEnd::start, true, true, false}};
    EXPECT_EQ(kind.build().freeRigidMotions(),
              std::vector<std::string>{"rotation about z through (0, 0, 0)"});
    kind.supports = {{BeamEnd::start, false, true, true}};
    EXPECT_EQ(kind.build().freeRigidMotions(), std::vector<std::string>{"translation along x"});
    kind.supports.push_back({BeamEnd::end, true, false, false});
    EXPECT_TRUE(kind.build().freeRigidMotions().empty());
}

TEST(Beam, basis_that_would_be_a_hinge_is_refused) {
    ExampleBeam kind;
    const geometry::NurbsCurve half =
        geometry::refine(geometry::arc({0, 0, 0}, 1, 0, M_PI), 3, 2); // two pieces, C0
    try {
        Beam(half, kind.section(), Strains::linear, {}, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the basis has a hinge at x = "));
        EXPECT_THAT(error.what(), HasSubstr("y = 1"));
    }
    kind.degree = 1;
    EXPECT_THROW(kind.build(), InputError);
}

TEST(SectionMotion, velocity_and_acceleration_are_derivatives_of_the_displacement) {
    const BeamField reference{{0, 0}, {2, 0.5}};
    // u(t) = p t + q t^2 in value and slope.
    const auto at = [](double t) {
        return BeamField{Vector2d(0.3, -0.2) * t + Vector2d(0.1, 0.4) * t * t,
                         Vector2d(-0.5, 1.5) * t + Vector2d(0.7, 0.2) * t * t};
    };
    const double t = 0.8;
    const BeamField u = at(t);
    const BeamField v{Vector2d(0.3, -0.2) + 2 * t * Vector2d(0.1, 0.4),
                      Vector2d(-0.5, 1.5) + 2 * t * Vector2d(0.7, 0.2)};
    const BeamField a{2 * Vector2d(0.1, 0.4), 2 * Vector2d(0.7, 0.2)};
    for (bool isLinear : {false, true}) {
        const auto displacement = [&](double s) {
            return sectionDisplacement(reference, at(s), 0.4, isLinear);
        };
        const double h = 1e-4; // errors of h^2 and of rounding over h^2 are below 1e-7
        const Vector2d velocity = (displacement(t + h) - displacement(t - h)) / (2 * h);
        const Vector2d acceleration =
            (displacement(t + h) - 2 * displacement(t) + displacement(t - h)) / (h * h);
        EXPECT_LT((sectionVelocity(reference, u, v, 0.4, isLinear) - velocity).norm(), 1e-6);
        EXPECT_LT((sectionAcceleration(reference, u, v, a, 0.4, isLinear) - acceleration).norm(),
                  1e-6);
    }
}
