// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledRun.hpp"

#include "common/errors.hpp"
#include "coupling/couplingMethods.hpp"

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

struct Step {
    VectorXd x;
    int nEvaluations = 0;
    bool converged = false;
};

Step runStep(ImperfectFluid& fluid, CoupledModel& model, CouplingMethod& method, VectorXd x,
             double noise) {
    Step step;
    try {
        while (step.nEvaluations < largestEvaluations && !step.converged) {
            const VectorXd forces = fluid(x);
            ++step.nEvaluations;
            model.startFrom(x);
            const CouplingIteration iteration = method.iterate(forces, noise);
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

RunResult coupledRun(CoupledModel& model, const CouplingOptions& options, double tolerance,
                     const Imperfection& imperfection) {
    const auto method = makeCouplingMethod(options, tolerance, model);
    ImperfectFluid fluid(model, imperfection);
    RunResult result;
    for (int i = 0; i < nSteps; ++i) {
        model.beginTimeStep();
        const VectorXd start = method->predict(model.deltaT());
        const VectorXd exact = model.monolithic(start);
        Step step = runStep(fluid, model, *method, start, imperfection.noise);
        if (i == 0) {
            result.evaluationsOfFirstStep = step.nEvaluations;
        }
        if (!step.converged) {
            method->reject();
            method->predict(model.deltaT());
            step.x = exact;
            ++(i < nStepsLeftOut ? result.nFailedAtStart : result.nFailed);
        }
        model.startFrom(step.x);
        method->accept(model.fluid(step.x));
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
