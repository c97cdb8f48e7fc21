#include "igaStructure/run/CoupledStructure.hpp"

namespace tokay::structure {

CoupledStructure::CoupledStructure(const Case& structureCase, Body& body,
                                   const WetBoundary& boundary, const coupling::Interface& fluid,
                                   PhaseTimer& timer, Report report)
    : boundary_(boundary), timer_(timer),
      integrator_(body.model(), structureCase.timeScheme, structureCase.newton, fluid.startTime),
      driver_(structureCase.coupling->options, fluid.tolerance,
              Eigen::VectorXd::Zero(boundary.nComponents())),
      output_(structureCase, body, integrator_.state(), fluid.endTime, std::move(report)) {}

Eigen::VectorXd CoupledStructure::beginTimeStep(int step, double time, double deltaT) {
    report_ = {};
    report_.step = step;
    integrator_.beginTimeStep(time, deltaT);
    return timer_.time(Phase::acceleration, [&] { return driver_.beginTimeStep(deltaT); });
}

Eigen::VectorXd CoupledStructure::solve(const std::vector<double>& forces) {
    const Eigen::VectorXd force = timer_.time(
        Phase::mapping, [&] { return boundary_.forces(forces, integrator_.displacement()); });
    timer_.time(Phase::solving, [&] { integrator_.solve(force); });
    ++report_.nExchanges;
    report_.nIterations += integrator_.nIterations();
    return timer_.time(Phase::mapping,
                       [&] { return boundary_.displacements(integrator_.displacement()); });
}

Answer CoupledStructure::iterate(const std::vector<double>& forces, double fluidResidual) {
    const Eigen::VectorXd xTilde = solve(forces);
    const coupling::Iteration iteration = timer_.time(Phase::acceleration, [&] {
        const Eigen::Map<const Eigen::VectorXd> faceForces(forces.data(), forces.size());
        return driver_.iterate(xTilde, fluidResidual, faceForces);
    });
    return {iteration.x, iteration.residual, iteration.converged};
}

Answer CoupledStructure::acceptTimeStep(const std::vector<double>& forces, bool writeResults) {
    const Eigen::VectorXd xTilde = solve(forces);
    timer_.time(Phase::solving, [&] { integrator_.acceptTimeStep(); });
    report_.lastResidual =
        timer_.time(Phase::acceleration, [&] { return driver_.acceptTimeStep(xTilde); });
    report_.firstResidual = driver_.statistics().firstResidual;
    report_.nColumns = driver_.statistics().nColumns;
    output_.finishStep(report_, integrator_.state(), integrator_.energies(), timer_, writeResults);
    return {xTilde, report_.lastResidual, true};
}

} // namespace tokay::structure
