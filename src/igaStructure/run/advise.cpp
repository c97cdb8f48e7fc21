#include "igaStructure/run/advise.hpp"

#include "common/errors.hpp"
#include "igaStructure/analysis/naturalModes.hpp"
#include "igaStructure/linearAlgebra/SparseLu.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

// Below this many steps a period the trapezoidal rule's period is wrong by
// more than 1 %: (2 pi / n)^2 / 12.
constexpr double fewSteps = 18;
// Linear kinematics stretch a turning body by half the square of the angle.
constexpr double largeDisplacement = 0.05;

std::string adviseStep(const Case& structureCase, const NaturalModes& modes) {
    const double omega = modes.angularFrequencies[0];
    if (!(omega > 0)) {
        return "";
    }
    const double period = 2 * M_PI / omega;
    std::string text = fmt::format("advice: the first natural period is {:.4g} s", period);
    if (!structureCase.timeSteps || !structureCase.timeScheme.dynamic) {
        return text + fmt::format("; a dynamic run resolves it with steps below {:.2g} s\n",
                                  period / fewSteps);
    }
    const double n = period / structureCase.timeSteps->step;
    text += fmt::format(", {:.3g} time steps; the trapezoidal rule makes it longer by {:.2g} %", n,
                        100 * std::pow(2 * M_PI / n, 2) / 12);
    return text + (n < fewSteps ? "; the step is too large for it\n" : "\n");
}

// Displacement under the loads at the end of the run, by one linear solution.
double staticEstimate(const Case& structureCase, StructuralModel& model) {
    const double time = structureCase.timeSteps ? structureCase.timeSteps->end : 1;
    VectorXd force = model.externalForce(time);
    model.addFollowerForce(VectorXd::Zero(model.nUnknowns()), time, force);
    SparseMatrix stiffness;
    model.internalForce(VectorXd::Zero(model.nUnknowns()), stiffness);
    SparseLu solver(stiffness, model.fixed());
    solver.factorise(stiffness);
    return solver.solve(force).lpNorm<Eigen::Infinity>();
}

std::string adviseStrains(const Case& structureCase, StructuralModel& model) {
    const double displacement = staticEstimate(structureCase, model);
    if (displacement == 0) {
        return "";
    }
    const double share = displacement / model.size();
    std::string text = fmt::format("advice: a first static estimate (linear, loads at the end) "
                                   "moves the structure by {:.3g} m, {:.2g} % of its size",
                                   displacement, 100 * share);
    if (model.isLinear() && share > largeDisplacement) {
        text += "; strains should be nonlinear";
    }
    if (!model.isLinear() && share < 0.01 * largeDisplacement) {
        text += "; linear strains would do";
    }
    return text + "\n";
}

// A half wave of the structure's size moves, on each side, the fluid in a layer
// of size / pi.
std::string adviseCoupling(const Case& structureCase, const Body& body) {
    const double mass = body.massPerWetArea();
    if (!structureCase.coupling || mass == 0) {
        return "";
    }
    const double density = mass * M_PI / (2 * body.model().size());
    return fmt::format("advice: the structure has {:.4g} kg on a square metre of interface; a "
                       "fluid of {:.3g} kg/m^3 on both sides adds as much to its slowest motion: "
                       "explicit coupling needs a fluid much lighter than that\n",
                       mass, density);
}

} // namespace

std::string advise(const Case& structureCase, Body& body) {
    std::string text;
    for (const std::string& line : body.advice()) {
        text += "advice: " + line + "\n";
    }
    text += adviseCoupling(structureCase, body);
    if (!body.model().freeRigidMotions().empty()) {
        return text;
    }
    try {
        text += adviseStrains(structureCase, body.model());
        text += adviseStep(structureCase, naturalModes(body.model(), 1));
    } catch (const SolverError& error) {
        text += fmt::format("advice: no estimate of stiffness: {}\n", error.what());
    }
    return text;
}

} // namespace tokay::structure
