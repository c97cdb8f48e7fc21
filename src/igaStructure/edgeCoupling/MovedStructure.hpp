// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/Case.hpp"
#include "igaStructure/edgeCoupling/MovedEdgesModel.hpp"
#include "igaStructure/kinematics/Body.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

namespace tokay::structure {

/// The Dirichlet side of two coupled structures: takes displacements of its edges, and
/// gives the forces with which it resists. It plays the part of the fluid.
class MovedStructure {
  public:
    /// Borrows the body and the edge.
    /// @throws InputError as MovedEdgesModel, and for supports that leave rigid motions free
    MovedStructure(const Case& structureCase, Body& body, const mapper::CurveInterface& edges,
                   const mapper::EdgeQuadrature& edge);

    const MovedEdgesModel& model() const { return model_; }
    int dimension() const { return dimension_; }

    void beginTimeStep(double time, double deltaT);

    /// Forces on the other structure at the edge's points, point after point [N].
    /// @param displacements  of these points [m]
    /// @throws SolverError if the structure has no solution
    Eigen::VectorXd forces(const Eigen::VectorXd& displacements);

    /// The last solution becomes the state.
    void acceptTimeStep();

    /// Accepted state, in the body's own unknowns.
    MotionState state() const;
    /// Goes on from such a state, between time steps.
    void restore(const MotionState& own, const Energies& energies);
    const Energies& energies() const { return integrator_.energies(); }

    /// Newton iterations in this time step.
    int nIterations() const { return nIterations_; }

  private:
    int dimension_; ///< of the scene
    MovedEdgesModel model_;
    TimeIntegrator integrator_;
    int nIterations_ = 0;
};

} // namespace tokay::structure
