// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/couplingMethods.hpp"
#include "igaStructure/ScriptedFluid.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/coupledRun/FsiStructure.hpp"
#include "igaStructure/exampleCase.hpp"
#include "igaStructure/kinematics/beam/exampleBeamCase.hpp"
#include "temporaryDirectory.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

const std::string linearFlap = exampleText() + "coupling: {interface: [left, top, right]}\n";
const std::string nonlinearBeam = exampleBeamText() + "coupling: {}\n";
constexpr double deltaT = 0.01;

/// A flap in its first time step, between two rows of fluid points.
struct Flap {
    explicit Flap(const std::string& text)
        : structureCase(readCase(directory.write("case.yaml", text))),
          body(makeBody(structureCase)), boundary(*body, *structureCase.coupling, interface),
          integrator(body->model(), *structureCase.implicitScheme(), structureCase.newton, 0),
          structure(body->model(), integrator, boundary, timer) {
        structure.beginTimeStep(deltaT, deltaT);
    }

    int nUnknowns() const { return body->model().nUnknowns(); }
    int nForces() const { return 2 * boundary.nFaces(); }
    /// Of the size of a bent flap, zero where it is fixed.
    VectorXd someUnknowns(double size) {
        VectorXd values = size * VectorXd::Random(nUnknowns());
        for (int k = 0; k < nUnknowns(); ++k) {
            if (body->model().fixed()[k]) {
                values[k] = 0;
            }
        }
        return values;
    }

    TemporaryDirectory directory;
    channel::Interface interface = flapInterface(20);
    Case structureCase;
    std::unique_ptr<Body> body;
    PhaseTimer timer;
    WetBoundary boundary;
    SubsteppedIntegrator integrator;
    FsiStructure structure;
};

/// A fluid that pushes from the left and opposes the motion of each face:
/// F = F0 + J x.
struct OpposingFluid {
    OpposingFluid(const Flap& flap, double strength)
        : J(MatrixXd::Zero(flap.nForces(), flap.boundary.nComponents())) {
        const std::vector<double> push = forceOnLeft(flap.interface, 500);
        F0 = Eigen::Map<const VectorXd>(push.data(), push.size());
        for (int face = 0; face < flap.boundary.nFaces(); ++face) {
            for (int c = 0; c < 2; ++c) {
                J(2 * face + c, 2 * face + c) = J(2 * face + c, 2 * face + 2 + c) = -strength / 2;
            }
        }
    }
    VectorXd forces(const VectorXd& x) const { return F0 + J * x; }
    VectorXd F0;
    MatrixXd J;
};

/// Motion of the interface by a unit force on each face, about no forces.
MatrixXd flexibility(Flap& flap) {
    const VectorXd x0 = flap.structure.solve(VectorXd::Zero(flap.nForces()));
    MatrixXd C(x0.size(), flap.nForces());
    for (int k = 0; k < flap.nForces(); ++k) {
        C.col(k) = flap.structure.solve(VectorXd::Unit(flap.nForces(), k)) - x0;
    }
    return C;
}

std::unique_ptr<coupling::CouplingMethod> blockMethod(Flap& flap, double tolerance) {
    coupling::CouplingOptions options;
    options.acceleration.type = "block";
    return makeCouplingMethod(options, tolerance, flap.structure);
}

/// A time step until it converges.
/// @return  displacement that the fluid has at its end
VectorXd iterate(const OpposingFluid& fluid, coupling::CouplingMethod& method) {
    VectorXd x = method.predict(deltaT);
    while (true) {
        const coupling::CouplingIteration iteration = method.iterate(fluid.forces(x), 0);
        if (iteration.converged || method.statistics().nIterations == 50) {
            break;
        }
        x = iteration.x;
    }
    return x;
}

/// The same, accepted.
VectorXd advance(Flap& flap, const OpposingFluid& fluid, coupling::CouplingMethod& method) {
    const VectorXd x = iterate(fluid, method);
    method.accept(fluid.forces(x));
    flap.integrator.acceptTimeStep();
    return x;
}

} // namespace

TEST(FsiStructure, tangent_inverts_the_derivative_of_the_required_force) {
    for (const std::string& text : {linearFlap, nonlinearBeam}) {
        Flap flap(text);
        const VectorXd d = flap.someUnknowns(1e-3);
        flap.structure.linearise(d);
        const VectorXd forces = flap.someUnknowns(1e3);
        const VectorXd D = flap.structure.responses(forces);
        // Central differences err by the square of the step and by rounding over it.
        const double step = 1e-6 / D.norm();
        const VectorXd difference =
            (flap.structure.residual(d + step * D) - flap.structure.residual(d - step * D)) /
            (2 * step);
        EXPECT_LT((difference - forces).norm(), 1e-5 * forces.norm());
    }
}

TEST(FsiStructure, solution_is_where_the_required_force_is_that_of_the_fluid) {
    Flap flap(linearFlap);
    const VectorXd forces = 100 * VectorXd::Random(flap.nForces());
    const VectorXd x = flap.structure.solve(forces);
    const VectorXd d = flap.integrator.displacement();
    const VectorXd loads = flap.structure.loads(forces, d);
    // Rounding of internal forces that cancel each other.
    EXPECT_LT((flap.structure.residual(d) - loads).norm(), 1e-8 * loads.norm());
    EXPECT_EQ(flap.structure.displacements(d), x);
}

TEST(FsiStructure, variations_are_the_derivative_of_displacements) {
    for (const std::string& text : {linearFlap, nonlinearBeam}) {
        Flap flap(text);
        const VectorXd d = flap.someUnknowns(1e-3); // random bending by more buckles the beam
        const VectorXd D = flap.someUnknowns(1);
        flap.structure.linearise(d);
        const double step = 1e-6;
        const VectorXd difference = (flap.structure.displacements(d + step * D) -
                                     flap.structure.displacements(d - step * D)) /
                                    (2 * step);
        const VectorXd variation = flap.structure.variations(D);
        EXPECT_LT((difference - variation).norm(), 1e-7 * variation.norm());
    }
}

/// A fluid that makes the structure alone explode, and where they are in balance.
struct StrongAddedMass {
    explicit StrongAddedMass(Flap& flap)
        : C(flexibility(flap)), fluid(flap, 100 / (C * OpposingFluid(flap, 1).J).operatorNorm()) {
        const VectorXd x0 = flap.structure.solve(VectorXd::Zero(flap.nForces()));
        exact = (MatrixXd::Identity(x0.size(), x0.size()) - C * fluid.J)
                    .partialPivLu()
                    .solve(x0 + C * fluid.F0);
    }
    MatrixXd C;
    OpposingFluid fluid;
    VectorXd exact;
};

TEST(FsiStructure, block_method_finds_the_monolithic_solution_in_a_strong_added_mass) {
    Flap flap(linearFlap);
    const StrongAddedMass together(flap);
    const OpposingFluid& fluid = together.fluid;
    const VectorXd& exact = together.exact;
    const auto method = blockMethod(flap, 1e-8);
    const VectorXd x = advance(flap, fluid, *method);
    EXPECT_TRUE(method->statistics().converged);
    // The fluid opposes the motion, so the error is smaller than the residual.
    EXPECT_LT((x - exact).norm(), 1e-8 * exact.norm());
    const int nFirst = method->statistics().nIterations;
    for (int step = 2; step < 12; ++step) {
        flap.structure.beginTimeStep(step * deltaT, deltaT);
        advance(flap, fluid, *method);
    }
    EXPECT_LE(method->statistics().nIterations, 4) << "of " << nFirst << " before J is known";
}

TEST(FsiStructure, block_method_accepts_the_solution_in_the_fluid_that_follows_it) {
    Flap flap(linearFlap);
    const StrongAddedMass together(flap);
    const auto method = blockMethod(flap, 1e-2);
    const VectorXd x = iterate(together.fluid, *method);
    const auto error = [&](const VectorXd& y) {
        return (y - together.exact).norm() / together.exact.norm();
    };
    const VectorXd forces = together.fluid.forces(x);
    const double ofForces = error(flap.structure.solve(forces));
    // The forces alone leave the residual, what is known of the fluid a part of it.
    EXPECT_GT(ofForces, 1e-4) << "nothing to improve";
    EXPECT_LT(error(method->accept(forces).x), 0.2 * ofForces);
    flap.integrator.acceptTimeStep();
    EXPECT_LT(error(flap.structure.acceptedDisplacements()), 0.2 * ofForces);
}

TEST(FsiStructure, block_method_converges_for_a_beam_that_turns) {
    Flap flap(nonlinearBeam);
    const OpposingFluid unit(flap, 1);
    const OpposingFluid fluid(flap, 20 / (flexibility(flap) * unit.J).operatorNorm());
    flap.structure.beginTimeStep(deltaT, deltaT);
    const auto method = blockMethod(flap, 1e-8);
    VectorXd x;
    for (int step = 1; step <= 20; ++step) {
        flap.structure.beginTimeStep(step * deltaT, deltaT);
        x = advance(flap, fluid, *method);
        ASSERT_TRUE(method->statistics().converged) << step;
        const VectorXd xTilde = flap.boundary.displacements(flap.integrator.state().displacement);
        // Newton's method leaves the structure a tenth of the tolerance.
        EXPECT_LT((xTilde - x).norm(), 2e-8 * x.norm()) << step;
    }
    EXPECT_LE(method->statistics().nIterations, 6);
}
