// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElasticTube.hpp"
#include "LinearResponse.hpp"
#include "Ring.hpp"
#include "common/errors.hpp"
#include "coupledRun.hpp"
#include "coupling/block/BlockQuasiNewton.hpp"
#include "coupling/block/BlockSystem.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

namespace tokay::coupling {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// N unknowns of which an interface of fewer points sees combinations:
/// R(d) = K d + cubic d³ - load.
class Springs : public LinearisedStructure {
  public:
    Springs(int nUnknowns, int nPoints, double cubic) : cubic_(cubic) {
        std::srand(21);
        const MatrixXd root = MatrixXd::Random(nUnknowns, nUnknowns);
        K_ = root * root.transpose() + MatrixXd::Identity(nUnknowns, nUnknowns);
        P_ = MatrixXd::Random(nPoints, nUnknowns);
        load_ = VectorXd::Random(nUnknowns);
    }

    VectorXd residual(const VectorXd& d) override {
        return K_ * d + cubic_ * d.array().cube().matrix() - load_;
    }
    void linearise(const VectorXd& d) override {
        MatrixXd tangent = K_;
        tangent.diagonal() += 3 * cubic_ * d.cwiseAbs2();
        factors_.compute(tangent);
        ++nFactorisations;
    }
    double reuseContraction() const override { return nFactorisations > 0 ? contraction : 0; }
    MatrixXd responses(const MatrixXd& b) override { return factors_.solve(b); }
    VectorXd displacements(const VectorXd& d) override { return P_ * d; }
    MatrixXd variations(const MatrixXd& D) override { return P_ * D; }
    VectorXd loads(const VectorXd& forces, const VectorXd&) override {
        return P_.transpose() * forces;
    }

    VectorXd acceptedUnknowns() const override { return VectorXd::Zero(load_.size()); }
    VectorXd solveFor(const VectorXd& loads, const VectorXd&) override {
        const VectorXd x = VectorXd::Zero(P_.rows());
        WoodburySolver steps(*this);
        return BlockSystem(*this, steps, loads, x, {}).solve(acceptedUnknowns(), 1e-12);
    }

    const MatrixXd& P() const { return P_; }

    int nFactorisations = 0;
    double contraction = 0; ///< at which a tangent serves

  private:
    double cubic_;
    MatrixXd K_;
    MatrixXd P_;
    VectorXd load_;
    Eigen::PartialPivLU<MatrixXd> factors_;
};

/// Forces F + J (x(d) - x), J of rank 3, on five points of twelve springs.
struct SpringsInFluid {
    explicit SpringsInFluid(double cubic) : springs(12, 5, cubic) {
        J.append(springs.P().transpose() * -MatrixXd::Random(5, 3), MatrixXd::Random(5, 3));
        loads = springs.P().transpose() * VectorXd::Random(5);
        x = VectorXd::Random(5);
    }

    VectorXd solve() {
        WoodburySolver steps(springs);
        return BlockSystem(springs, steps, loads, x, J).solve(VectorXd::Zero(12), 1e-9);
    }
    double imbalance(const VectorXd& d) {
        return (springs.residual(d) - loads - J.apply(springs.displacements(d) - x, 12)).norm();
    }

    Springs springs;
    LowRankMatrix J;
    VectorXd loads;
    VectorXd x;
};

TEST(BlockSystem, balances_a_linear_structure_in_a_fluid_that_responds_with_one_factorisation) {
    SpringsInFluid model(0);
    EXPECT_LT(model.imbalance(model.solve()), 1e-9); // conditions of K and of the block: some 1e3
    EXPECT_EQ(model.springs.nFactorisations, 1);
}

TEST(BlockSystem, converges_quadratically_for_a_nonlinear_structure) {
    SpringsInFluid model(5);
    EXPECT_LT(model.imbalance(model.solve()), 1e-9);
    // Five or so to get near, three to double the digits.
    EXPECT_LT(model.springs.nFactorisations, 10);
}

TEST(BlockSystem, keeps_a_tangent_while_it_serves) {
    SpringsInFluid model(5);
    model.springs.contraction = 0.1;
    EXPECT_LT(model.imbalance(model.solve()), 1e-7); // a tenth of 1e-9 of d, times K of some 1e2
    const VectorXd d = model.solve();
    const int nBefore = model.springs.nFactorisations;
    model.loads *= 1.001;
    WoodburySolver steps(model.springs);
    const BlockSystem near(model.springs, steps, model.loads, model.x, model.J);
    EXPECT_LT(model.imbalance(near.solve(d, 1e-9)), 1e-7);
    EXPECT_EQ(model.springs.nFactorisations, nBefore);
}

TEST(BlockSystem, without_a_response_is_the_structure_alone) {
    SpringsInFluid model(5);
    model.J = {};
    EXPECT_LT((model.springs.residual(model.solve()) - model.loads).norm(), 1e-9);
}

TEST(BlockSystem, forces_that_are_not_finite_end_in_an_error) {
    SpringsInFluid model(1);
    model.loads[3] = std::nan("");
    EXPECT_THROW(model.solve(), SolverError);
}

/// One unknown of a given law, whose tangent may be that of another place.
class Law : public LinearisedStructure {
  public:
    using Function = std::function<double(double)>;
    Law(Function force, Function stiffness)
        : force_(std::move(force)), stiffness_(std::move(stiffness)) {}

    VectorXd residual(const VectorXd& d) override { return d.unaryExpr(force_); }
    void linearise(const VectorXd& d) override {
        tangent = stiffness_(d[0]);
        ++nFactorisations;
    }
    double reuseContraction() const override { return contraction; }
    MatrixXd responses(const MatrixXd& b) override { return b / tangent; }
    VectorXd displacements(const VectorXd& d) override { return d; }
    MatrixXd variations(const MatrixXd& D) override { return D; }
    VectorXd loads(const VectorXd& forces, const VectorXd&) override { return forces; }
    VectorXd acceptedUnknowns() const override { return VectorXd::Zero(1); }
    VectorXd solveFor(const VectorXd& loads, const VectorXd&) override { return loads; }

    /// Solution under a load, without a fluid.
    double solve(double load, double start, double tolerance) {
        WoodburySolver steps(*this);
        const VectorXd loads = VectorXd::Constant(1, load);
        const VectorXd x = VectorXd::Zero(1);
        const LowRankMatrix noFluid;
        const BlockSystem system(*this, steps, loads, x, noFluid);
        return system.solve(VectorXd::Constant(1, start), tolerance)[0];
    }

    double tangent = 1;
    double contraction = 0;
    int nFactorisations = 0;

  private:
    Function force_, stiffness_;
};

TEST(BlockSystem, replaces_a_tangent_that_contracts_less_than_asked_for) {
    for (const double contraction : {0.4, 0.6}) {
        Law law([](double d) { return d; }, [](double) { return 1; });
        law.tangent = 2; // halves the imbalance in each step
        law.contraction = contraction;
        EXPECT_NEAR(law.solve(1, 0, 1e-10), 1, 1e-9);
        EXPECT_EQ(law.nFactorisations, contraction < 0.5 ? 1 : 0);
    }
}

TEST(BlockSystem, shortens_newtons_step_as_far_as_needed) {
    // A spring that softens: from 1 a whole step ends at -77, a 64th at -0.2.
    Law law([](double d) { return std::atan(50 * d); },
            [](double d) { return 50 / (1 + 2500 * d * d); });
    EXPECT_NEAR(law.solve(0, 1, 1e-10), 0, 1e-9);
}

TEST(BlockSystem, place_where_forces_are_not_finite_is_no_solution_however_near) {
    Law law([](double d) { return d == 1e6 ? 0 : NAN; }, [](double) { return 1; });
    EXPECT_THROW(law.solve(1, 1e6, 1e-3), SolverError);
}

TEST(FluidLag, corrects_for_seven_tenths_of_what_the_fluid_kept) {
    const VectorXd answer1 = VectorXd::Constant(2, 1);
    const VectorXd answer2 = VectorXd::Constant(2, 3);
    const double q = 0.3;
    FluidLag lag({q, 3});
    lag.beginTimeStep();
    EXPECT_EQ(lag.corrected(answer1), answer1);
    const VectorXd came = answer2 + q * (answer1 - answer2);
    const double left = (q - 0.7 * q) / (1 - 0.7 * q); // of the difference
    EXPECT_NEAR((lag.corrected(came) - answer2)[0], left * (1 - 3), 1e-14);
}

TEST(FluidLag, a_converged_fluid_is_taken_as_it_comes_and_is_always_informative) {
    FluidLag lag({0, 3});
    lag.beginTimeStep();
    for (const double force : {1.0, 5.0, 5.1, 5.1}) {
        EXPECT_EQ(lag.corrected(VectorXd::Constant(1, force))[0], force);
        EXPECT_TRUE(lag.isInformative());
    }
}

TEST(FluidLag, a_difference_that_the_lag_explains_is_not_informative) {
    const auto isInformativeAfter = [](double change) {
        FluidLag lag({0.1, 5});
        lag.beginTimeStep();
        lag.corrected(VectorXd::Constant(1, 0));
        lag.corrected(VectorXd::Constant(1, 1));
        lag.corrected(VectorXd::Constant(1, 1 + change));
        return lag.isInformative();
    };
    // 5 q / (1 - q), with q = (0.1 - 0.07) / (1 - 0.07) left by the correction
    EXPECT_FALSE(isInformativeAfter(0.99 / 6));
    EXPECT_TRUE(isInformativeAfter(1.01 / 6));
}

TEST(FluidLag, first_difference_of_a_run_is_informative_however_small) {
    FluidLag lag({0.1, 5});
    lag.beginTimeStep();
    lag.corrected(VectorXd::Constant(1, 1));
    lag.corrected(VectorXd::Constant(1, 1 + 1e-6));
    EXPECT_TRUE(lag.isInformative());
}

TEST(FluidLag, rejected_and_saved_states_know_the_last_difference) {
    FluidLag lag({0.1, 5});
    lag.beginTimeStep();
    lag.corrected(VectorXd::Constant(1, 0));
    lag.corrected(VectorXd::Constant(1, 1));
    std::vector<std::uint8_t> bytes;
    StateWriter written(bytes);
    lag.save(written);
    FluidLag restored({0.1, 5});
    StateReader state(bytes);
    restored.restore(state);
    lag.beginTimeStep();
    lag.corrected(VectorXd::Constant(1, 1e6));
    lag.rejectTimeStep();
    for (FluidLag* each : {&lag, &restored}) {
        each->beginTimeStep();
        each->corrected(VectorXd::Constant(1, 1.1)); // a tenth of the difference before
        EXPECT_FALSE(each->isInformative());
    }
}

struct NewtonSolution {
    VectorXd d;
    int nFactorisations;
};

/// Newton's method for the springs alone until a step is below the tolerance.
NewtonSolution newtonSolution(Springs& springs, const VectorXd& loads, double tolerance) {
    VectorXd d = springs.acceptedUnknowns();
    for (int n = 1;; ++n) {
        springs.linearise(d);
        const VectorXd step = springs.responses(loads - springs.residual(d));
        d += step;
        if (step.norm() <= tolerance * d.norm()) {
            return {d, n};
        }
    }
}

TEST(BlockQuasiNewton, leaves_a_tenth_of_the_tolerance_to_newtons_method) {
    // One factorisation belongs to the residual; those of the line search's shorter steps
    // do not occur, as the springs are nearly linear here.
    const VectorXd force = VectorXd::Constant(5, 0.1);
    const double relaxation = BlockQuasiNewton::Options().initialRelaxation;
    int nSpared = 0;
    for (int k = 2; k <= 16; ++k) {
        const double tolerance = std::pow(10, -0.5 * k);
        Springs springs(12, 5, 2);
        const VectorXd loads = springs.P().transpose() * force;
        const VectorXd exact = newtonSolution(springs, loads, 1e-14).d;
        const int most = newtonSolution(springs, loads, 0.1 * tolerance).nFactorisations;
        BlockQuasiNewton method(CouplingOptions(), tolerance, springs);
        method.predict(0.1);
        springs.nFactorisations = 0;
        const VectorXd x = method.iterate(force, 0).x / relaxation;
        EXPECT_LE(springs.nFactorisations, 1 + most) << tolerance;
        nSpared += 1 + most - springs.nFactorisations;
        EXPECT_LE((x - springs.displacements(exact)).norm(),
                  0.1 * tolerance * springs.P().norm() * exact.norm());
    }
    EXPECT_GT(nSpared, 0) << "the last iteration often only shows that none was needed";
}

TEST(BlockQuasiNewton, keeps_the_structures_tangent_while_it_serves) {
    Springs springs(12, 5, 2);
    springs.contraction = 0.1;
    BlockQuasiNewton method(CouplingOptions(), 1e-6, springs);
    method.predict(0.1);
    method.iterate(VectorXd::Constant(5, 1e-3), 0); // so small that all is nearly linear
    const int nFactorisations = springs.nFactorisations;
    EXPECT_GE(nFactorisations, 1);
    method.iterate(VectorXd::Constant(5, 1.1e-3), 0);
    EXPECT_EQ(springs.nFactorisations, nFactorisations);
}

/// Mean evaluations a step at the tolerance 1e-8; every step is checked
/// against the monolithic solution.
double meanEvaluations(CoupledModel& model, const char* name) {
    const double tolerance = 1e-8;
    const RunResult result = coupledRun(model, CouplingOptions(), tolerance);
    std::printf("%s: %.2f evaluations a step, error %.1e\n", name, result.meanEvaluations,
                result.largestError);
    EXPECT_EQ(result.nFailed + result.nFailedAtStart, 0) << name;
    // The fluid opposes the motion, so the error is smaller than the residual.
    EXPECT_LT(result.largestError, 1.5 * tolerance) << name;
    return result.meanEvaluations;
}

/// Limits: those of the design, measured with a prototype, and a fifth more.
TEST(BlockQuasiNewton, needs_few_evaluations_at_any_added_mass_and_finds_the_monolithic_solution) {
    ElasticTube tube(40, 10, 0.01);
    EXPECT_LT(meanEvaluations(tube, "tube"), 1.2 * 3.3);
    const struct {
        RingWall wall;
        double massRatio;
        double limit;
        const char* name;
    } rings[] = {{RingWall::linear, 1000, 3.3, "linear ring, 1000"},
                 {RingWall::cubic, 1000, 4.1, "cubic ring, 1000"},
                 {RingWall::geometric, 1000, 5.0, "geometrically nonlinear ring, 1000"}};
    for (const auto& [wall, massRatio, limit, name] : rings) {
        Ring ring(wall, massRatio);
        EXPECT_LT(meanEvaluations(ring, name), 1.2 * limit);
    }
}

/// From rest, before the fluid's response is known, noise can keep a step from
/// converging; once it is known, it cannot.
TEST(BlockQuasiNewton, stands_white_noise) {
    for (const double noise : {1e-5, 1e-3}) {
        Ring ring(RingWall::cubic, 100);
        const RunResult result = coupledRun(ring, CouplingOptions(), 10 * noise, {noise, 0});
        EXPECT_EQ(result.nFailed, 0) << noise;
        EXPECT_LT(result.meanEvaluations, 5) << noise;
    }
}

TEST(BlockQuasiNewton, stands_a_fluid_with_memory_by_its_guard) {
    for (const double q : {0.1, 0.3}) {
        const auto run = [q](double fluidMemory) {
            CouplingOptions options;
            options.acceleration.of<BlockQuasiNewton::Options>().fluidMemory = fluidMemory;
            Ring ring(RingWall::cubic, 100);
            return coupledRun(ring, options, 1e-4, {0, q});
        };
        const RunResult guarded = run(q);
        EXPECT_EQ(guarded.nFailed, 0) << q;
        EXPECT_GT(run(0).meanEvaluations, 1.3 * guarded.meanEvaluations)
            << "the guard would be needless";
    }
}

TEST(BlockQuasiNewton, jacobian_follows_the_time_step) {
    // Forces of an added mass go as 1/Δt². One unknown is known after one
    // difference: with the Jacobian scaled, the first answer in a step of
    // another length is right.
    const auto fluid = [](const VectorXd& x, double deltaT) -> VectorXd {
        return VectorXd::Ones(1) - 10 * x / (deltaT * deltaT);
    };
    Springs springs(1, 1, 0);
    BlockQuasiNewton driver(CouplingOptions(), 1e-6, springs);
    const auto nIterations = [&](double deltaT) {
        VectorXd x = driver.predict(deltaT);
        while (!driver.statistics().converged) {
            x = driver.iterate(fluid(x, deltaT), 0).x;
        }
        driver.accept(fluid(driver.x(), deltaT));
        return driver.statistics().nIterations;
    };
    EXPECT_EQ(nIterations(0.1), 3);
    EXPECT_EQ(nIterations(0.2), 2);
    EXPECT_EQ(nIterations(0.05), 2);
}

/// The memory's guard looks at what the last step has left behind.
CouplingOptions withMemory() {
    CouplingOptions options;
    options.acceleration.of<BlockQuasiNewton::Options>().fluidMemory = 0.1;
    return options;
}

TEST(BlockQuasiNewton, a_rejected_step_leaves_no_trace) {
    Springs springs(6, 3, 0);
    const LinearResponse fluid{-5 * MatrixXd::Identity(3, 3), VectorXd::Ones(3)};
    const auto run = [&](bool withRejection) {
        BlockQuasiNewton driver(withMemory(), 1e-8, springs);
        const auto exchanges = [&](double deltaT, int n) {
            VectorXd x = driver.predict(deltaT);
            for (int i = 0; i < n; ++i) {
                x = driver.iterate(fluid(x), 0).x;
            }
            return x;
        };
        exchanges(0.1, 6);
        driver.accept(fluid(driver.x()));
        if (withRejection) {
            exchanges(0.4, 3);
            driver.reject();
        }
        return exchanges(0.1, 3);
    };
    EXPECT_LT((run(true) - run(false)).norm(), 1e-12 * run(false).norm()); // scaled to and fro
}

TEST(BlockQuasiNewton, continues_bit_by_bit_from_a_saved_state) {
    Springs springs(6, 3, 0);
    const auto advance = [&](BlockQuasiNewton& driver, int step) {
        const LinearResponse fluid{-5 * MatrixXd::Identity(3, 3), VectorXd::Constant(3, step)};
        VectorXd x = driver.predict(step == 4 ? 0.2 : 0.1);
        while (!driver.statistics().converged) {
            x = driver.iterate(fluid(x), 0).x;
        }
        driver.accept(fluid(driver.x()));
        return x;
    };
    BlockQuasiNewton whole(withMemory(), 1e-8, springs);
    for (int step = 1; step <= 3; ++step) {
        advance(whole, step);
    }
    std::vector<std::uint8_t> bytes;
    StateWriter written(bytes);
    whole.save(written);
    BlockQuasiNewton continued(withMemory(), 1e-8, springs);
    StateReader state(bytes);
    continued.restore(state);
    EXPECT_EQ(state.remaining(), 0u);
    for (int step = 4; step <= 6; ++step) {
        EXPECT_EQ(advance(continued, step), advance(whole, step)) << step;
    }
    bytes.pop_back();
    StateReader cut(bytes);
    EXPECT_THROW(continued.restore(cut), channel::PeerError);
}

/// A shallow arch of one unknown, R(d) = d + d², which carries no more than -1/4.
class Arch : public LinearisedStructure {
  public:
    VectorXd residual(const VectorXd& d) override { return d + d.cwiseAbs2(); }
    void linearise(const VectorXd& d) override { tangent_ = 1 + 2 * d[0]; }
    MatrixXd responses(const MatrixXd& b) override { return b / tangent_; }
    VectorXd displacements(const VectorXd& d) override { return d; }
    MatrixXd variations(const MatrixXd& D) override { return D; }
    VectorXd loads(const VectorXd& forces, const VectorXd&) override { return forces; }
    VectorXd acceptedUnknowns() const override { return VectorXd::Zero(1); }
    VectorXd solveFor(const VectorXd& loads, const VectorXd&) override {
        return VectorXd::Constant(1, -0.5 + std::sqrt(0.25 + loads[0]));
    }

  private:
    double tangent_ = 1;
};

TEST(BlockQuasiNewton, resets_a_response_in_which_the_structure_has_no_solution) {
    // From -0.2 at rest the force seems to grow like the displacement: d + d² =
    // -0.2 + d has no solution. It has done so by itself, and stays: d + d² = F.
    CouplingOptions options;
    options.predictor = Extrapolation::constant;
    Arch arch;
    BlockQuasiNewton method(options, 1e-6, arch);
    method.predict(1);
    const double x1 = method.iterate(VectorXd::Constant(1, -0.2), 0).x[0];
    const VectorXd force = VectorXd::Constant(1, -0.2 + x1);
    const double exact = -0.5 + std::sqrt(0.25 + force[0]);
    EXPECT_NEAR(method.iterate(force, 0).x[0], x1 + 0.1 * (exact - x1),
                1e-7); // relaxed by 0.1; a tenth of the tolerance
    EXPECT_NEAR(method.iterate(force, 0).x[0], exact, 1e-7);
}

} // namespace
} // namespace tokay::coupling
