// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/ConvergenceCriteria.hpp"
#include "coupling/CouplingOptions.hpp"
#include "coupling/FixedPointDriver.hpp"
#include "coupling/FluidMemory.hpp"
#include "coupling/Predictor.hpp"
#include "coupling/ResponseModel.hpp"
#include "coupling/TangentStructure.hpp"

namespace tokay::coupling {

/// Block multi-vector quasi-Newton: the structure's tangent is known and
/// factored, so only the fluid's response J ≈ dL/dx is learned, L being what its
/// forces do to the structure. Each exchange solves the structure in a fluid
/// that responds by J (@see BlockSystem). Takes the place of FixedPointDriver,
/// with the same life cycle. If there is no solution by J, J is forgotten and the
/// structure's own answer relaxed, as before anything is learned.
///
/// Uses initialRelaxation, filterLimit, largestRank, rankLimit, signalToNoise
/// (weighs differences, @see ResponseModel), fluidMemory, memoryContrast.
class BlockQuasiNewton {
  public:
    /// Borrows the structure.
    /// @param initial  state d of the structure at the start
    /// @throws InputError if an option or the tolerance is out of its range
    BlockQuasiNewton(const CouplingOptions& options, double tolerance, TangentStructure& structure,
                     const Eigen::VectorXd& initial);

    /// The structure has begun its step already.
    /// @return  predicted displacement x of the interface
    const Eigen::VectorXd& beginTimeStep(double deltaT);

    /// @param forces         on the fluid's faces, at the last x returned
    /// @param fluidResidual  relative error that they may have
    /// @throws SolverError if a value is not finite or Newton's method fails
    Iteration iterate(const Eigen::VectorXd& forces, double fluidResidual);

    /// What the final forces would do to the structure once the fluid had followed
    /// it for the rest of the way, by what is known of its response.
    /// @param forces  on the fluid's faces, at the displacement of the last exchange
    Eigen::VectorXd finalLoads(const Eigen::VectorXd& forces);

    /// @param d  state that the structure has accepted under the final loads
    /// @return   what the interface has moved on since the last exchange, relative
    double acceptTimeStep(const Eigen::VectorXd& d);

    /// Forgets the step, which will be tried again.
    void rejectTimeStep();

    /// What earlier steps have left behind, between two time steps.
    void save(StateWriter& state) const;
    /// Goes on from what save() wrote.
    /// @throws channel::PeerError if the state is damaged
    void restore(StateReader& state);

    /// Structure's state at the last x returned: where to start its solution.
    const Eigen::VectorXd& state() const { return next_.d; }

    /// Displacement of the interface that the last forces belong to.
    const Eigen::VectorXd& x() const { return now_.x; }

    const StepStatistics& statistics() const { return statistics_; }

  private:
    /// A state of the structure and the interface's displacement in it.
    struct Position {
        Eigen::VectorXd d;
        Eigen::VectorXd x;
    };

    Position at(const Eigen::VectorXd& d) const;
    void learn(const Eigen::VectorXd& loads, double fluidResidual);
    Eigen::VectorXd structuresAnswer(const Eigen::VectorXd& loads) const;
    Position nextPosition(const Eigen::VectorXd& loads);

    CouplingOptions options_;
    ConvergenceCriteria criteria_;
    TangentStructure& structure_;
    Predictor predictor_; ///< of d
    ResponseModel model_;
    FluidMemory memory_;
    Position now_;                  ///< that the last forces belong to
    Position next_;                 ///< that the next forces will belong to
    Eigen::VectorXd previousX_;     ///< of the exchange before, empty in the first
    Eigen::VectorXd previousLoads_; ///< likewise
    double deltaT_ = 0;
    double deltaTOfModel_ = 0;
    StepStatistics statistics_;
};

} // namespace tokay::coupling
