// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/block/FluidLag.hpp"
#include "coupling/block/ResponseModel.hpp"
#include "coupling/block/WoodburySolver.hpp"
#include "coupling/step/CoupledStructure.hpp"
#include "coupling/step/CouplingMethod.hpp"
#include "coupling/step/CouplingOptions.hpp"
#include "coupling/step/InitialRelaxation.hpp"

namespace tokay::coupling {

/// Block multi-vector quasi-Newton: the structure's tangent is known and
/// factored, so only the fluid's response J ≈ dL/dx is learned, L being what its
/// forces do to the structure. Each coupling iteration solves the structure in a
/// fluid that responds by J (@see BlockSystem). If there is no solution with J, J is
/// reset and the structural solution relaxed, as before anything is learned.
class BlockQuasiNewton : public CouplingMethod {
  public:
    struct Options : InitialRelaxation, ResponseOptions, FluidLag::Options {
        double signalToNoise = 3;

        static const SchemaOf<Options>& schema();
    };

    /// @param tolerance  of the fluid, relative; @see ConvergenceCriteria
    /// @param structure  is kept by reference
    /// @throws InputError if the tolerance is out of its range
    BlockQuasiNewton(const CouplingOptions& options, double tolerance,
                     LinearisedStructure& structure);

    const Eigen::VectorXd& predict(double deltaT) override;
    /// @throws SolverError if Newton's method fails
    CouplingIteration iterate(const Eigen::VectorXd& faceForces,
                              std::optional<double> fluidResidual) override;
    /// Accepts the structural solution for what the final forces would do once the
    /// fluid had followed the structure to it, by what is known of its response.
    CouplingIteration accept(const Eigen::VectorXd& finalForces,
                             double limit = std::numeric_limits<double>::infinity()) override;
    void reject() override;

    void dropTangent() override { steps_.forget(); }
    std::string name() const override { return "block"; }
    void save(StateWriter& state) const override;
    void restore(StateReader& state) override;
    const Eigen::VectorXd& x() const override { return now_.x; }

  private:
    /// Unknowns of the structure and the interface's displacement with them.
    struct InterfaceState {
        Eigen::VectorXd d;
        Eigen::VectorXd x;
    };

    InterfaceState at(const Eigen::VectorXd& d) const;
    void learn(const Eigen::VectorXd& loads, double fluidResidual);
    Eigen::VectorXd newtonPrediction(const Eigen::VectorXd& loads) const;
    InterfaceState nextState(const Eigen::VectorXd& loads, double tolerance);

    const Options options_;
    ConvergenceCriteria criteria_;
    LinearisedStructure& structure_;
    WoodburySolver steps_;
    Predictor predictor_; ///< of d
    ResponseModel model_;
    FluidLag lag_;
    InterfaceState now_;            ///< that the last forces belong to
    InterfaceState next_;           ///< that the next forces will belong to
    Eigen::VectorXd previousX_;     ///< of the iteration before; empty in the first
    Eigen::VectorXd previousLoads_; ///< likewise
    double deltaT_ = 0;             ///< 0: no step is under way
    double deltaTOfModel_ = 0;
};

} // namespace tokay::coupling
