// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/edgeCoupling/MovedStructure.hpp"

#include "igaStructure/run/requireSupports.hpp"

#include <array>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

using PointRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

MovedEdgesModel& checked(const Case& structureCase, MovedEdgesModel& model) {
    requireSupports(structureCase, model);
    return model;
}

} // namespace

MovedStructure::MovedStructure(const Case& structureCase, Body& body,
                               const mapper::CurveInterface& edges,
                               const mapper::EdgeQuadrature& edge)
    : dimension_(body.dimension()), model_(body.model(), edge, edges.coordinates()),
      integrator_(checked(structureCase, model_), *structureCase.implicitScheme(),
                  structureCase.newton, 0) {}

void MovedStructure::beginTimeStep(double time, double deltaT) {
    integrator_.beginTimeStep(time, deltaT);
    nIterations_ = 0;
}

VectorXd MovedStructure::forces(const VectorXd& displacements) {
    const Eigen::Map<const PointRows> given(displacements.data(), displacements.size() / dimension_,
                                            dimension_);
    Eigen::MatrixXd ofPoints = Eigen::MatrixXd::Zero(given.rows(), model_.nComponents());
    ofPoints.leftCols(dimension_) = given;
    model_.move(ofPoints);
    integrator_.solve();
    nIterations_ += integrator_.nIterations();
    const PointRows forces = -model_.forcesAtPoints(integrator_.reaction()).leftCols(dimension_);
    return Eigen::Map<const VectorXd>(forces.data(), forces.size());
}

void MovedStructure::acceptTimeStep() {
    integrator_.acceptTimeStep();
}

namespace {

std::array<VectorXd*, 5> vectorsOf(MotionState& state) {
    return {&state.displacement, &state.velocity, &state.acceleration, &state.force,
            &state.reaction};
}

} // namespace

MotionState MovedStructure::state() const {
    MotionState state = integrator_.state();
    for (VectorXd* vector : vectorsOf(state)) {
        *vector = model_.ofStructure(*vector);
    }
    return state;
}

void MovedStructure::restore(const MotionState& own, const Energies& energies) {
    MotionState state = own;
    for (VectorXd* vector : vectorsOf(state)) {
        *vector = model_.fromStructure(*vector);
    }
    integrator_.restore(state, energies);
}

} // namespace tokay::structure
