// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledRun.hpp"

#include "common/errors.hpp"
#include "coupling/BlockQuasiNewton.hpp"
#include "coupling/FixedPointDriver.hpp"

#include <algorithm>

namespace tokay::coupling {
namespace {

using Eigen::VectorXd;

constexpr int nSteps = 120;
constexpr int nStepsLeftOut = 20;
constexpr int largestEvaluations = 50;

class ImperfectFluid {
  public:
    ImperfectFluid(CoupledModel& model, const Imperfection& imperfection)
        : model_(model), imperfection_(imperfection) {}

    VectorXd operator()(const VectorXd& x) {
        VectorXd forces = model_.fluid(x);
        if (imperfection_.noise > 0) {
            const VectorXd direction =
                VectorXd::NullaryExpr(forces.size(), [this] { return normal_(random_); });
            forces += imperfection_.noise * forces.norm() * direction.normalized();
        }
        if (last_.size() != 0) {
            forces += imperfection_.memory * (last_ - forces);
        }
        last_ = forces;
        return forces;
    }

  private:
    CoupledModel& model_;
    Imperfection imperfection_;
    std::mt19937 random_{1};
    std::normal_distribution<double> normal_;
    VectorXd last_;
};

/// Both kinds of driver, as one that is fed by forces.
class AnyDriver {
  public:
    AnyDriver(CoupledModel& model, Method method, const CouplingOptions& options, double tolerance)
        : model_(model) {
        const VectorXd rest = VectorXd::Zero(model.nUnknowns());
        if (method == Method::block) {
            block_ = std::make_unique<BlockQuasiNewton>(options, tolerance, model, rest);
        } else {
            fixedPoint_ = std::make_unique<FixedPointDriver>(options, tolerance, rest);
        }
    }

    VectorXd beginTimeStep(double deltaT) {
        return block_ ? block_->beginTimeStep(deltaT) : fixedPoint_->beginTimeStep(deltaT);
    }
    Iteration iterate(const VectorXd& x, const VectorXd& forces, double fluidResidual) {
        return block_ ? block_->iterate(forces, fluidResidual)
                      : fixedPoint_->iterate(model_.structure(forces, x), fluidResidual);
    }
    void acceptTimeStep(const VectorXd& x) {
        block_ ? block_->acceptTimeStep(x) : fixedPoint_->acceptTimeStep(x);
    }
    void rejectTimeStep() { block_ ? block_->rejectTimeStep() : fixedPoint_->rejectTimeStep(); }

  private:
    CoupledModel& model_;
    std::unique_ptr<BlockQuasiNewton> block_;
    std::unique_ptr<FixedPointDriver> fixedPoint_;
};

struct Step {
    VectorXd x;
    int nEvaluations = 0;
    bool converged = false;
};

Step runStep(ImperfectFluid& fluid, AnyDriver& driver, VectorXd x, double noise) {
    Step step;
    try {
        while (step.nEvaluations < largestEvaluations && !step.converged) {
            const VectorXd forces = fluid(x);
            ++step.nEvaluations;
            const Iteration iteration = driver.iterate(x, forces, noise);
            step.x = x;
            step.converged = iteration.converged;
            x = iteration.x;
        }
    } catch (const SolverError&) {
        step.converged = false;
    }
    if (!step.converged) {
        step.nEvaluations = largestEvaluations;
    }
    return step;
}

} // namespace

RunResult coupledRun(CoupledModel& model, Method method, const CouplingOptions& options,
                     double tolerance, const Imperfection& imperfection) {
    AnyDriver driver(model, method, options, tolerance);
    ImperfectFluid fluid(model, imperfection);
    RunResult result;
    for (int i = 0; i < nSteps; ++i) {
        model.beginTimeStep();
        VectorXd start = driver.beginTimeStep(model.deltaT());
        const VectorXd exact = model.monolithic(start);
        Step step = runStep(fluid, driver, start, imperfection.noise);
        if (i == 0) {
            result.evaluationsOfFirstStep = step.nEvaluations;
        }
        if (!step.converged) {
            driver.rejectTimeStep();
            driver.beginTimeStep(model.deltaT());
            step.x = exact;
            ++(i < nStepsLeftOut ? result.nFailedAtStart : result.nFailed);
        }
        model.fluid(step.x);
        driver.acceptTimeStep(step.x);
        model.acceptTimeStep(step.x);
        if (i >= nStepsLeftOut) {
            result.meanEvaluations += step.nEvaluations / double(nSteps - nStepsLeftOut);
            result.largestEvaluations = std::max(result.largestEvaluations, step.nEvaluations);
            result.largestError =
                std::max(result.largestError, (step.x - exact).norm() / exact.norm());
        }
    }
    return result;
}

} // namespace tokay::coupling
