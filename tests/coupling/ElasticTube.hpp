// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CoupledModel.hpp"

namespace tokay::coupling {

/// One-dimensional flow through an elastic tube: the model problem of
/// partitioned coupling with a strong added mass. Dimensionless with density,
/// inlet velocity, length and cross-section of the tube at rest equal to one.
///
/// Unknown of the coupling: x, the change of the cross-sections, one a cell.
/// Fluid: velocity u and pressure p of an incompressible flow in given
/// cross-sections (finite volumes, backward Euler, non-reflecting outlet).
/// Structure: a(p) = (2 c² / (2 c² - p))², without inertia.
/// Source: Degroote, Bruggeman, Haelterman & Vierendeels 2008, Stability of a
/// coupling technique for partitioned solvers in FSI applications.
class ElasticTube : public CoupledModel {
  public:
    /// @param nCells
    /// @param stiffness  κ, wave speed over inlet velocity
    /// @param deltaT     τ, time step over transit time
    ElasticTube(int nCells, double stiffness, double deltaT);

    int nUnknowns() const override { return nCells_; }
    double deltaT() const override { return deltaT_; }

    /// u at the inlet is 1 + 0.1 sin²(πt).
    void beginTimeStep() override;

    /// Pressure of the flow through cross-sections 1 + x.
    Eigen::VectorXd fluid(const Eigen::VectorXd& x) override;
    Eigen::VectorXd structure(const Eigen::VectorXd& pressure,
                              const Eigen::VectorXd& start) override;

    /// By Newton's method on the joint equations, from the last step's flow.
    Eigen::VectorXd monolithic(const Eigen::VectorXd& start) override;
    void acceptTimeStep(const Eigen::VectorXd& x) override;

    /// The pressure that belongs to these cross-sections.
    Eigen::VectorXd residual(const Eigen::VectorXd& x) override;
    void linearise(const Eigen::VectorXd& x) override;
    Eigen::MatrixXd responses(const Eigen::MatrixXd& b) override;

  private:
    template <class Scalar>
    using Vector = Eigen::Array<Scalar, Eigen::Dynamic, 1>;
    /// Flow of all cells: velocities, then pressures.
    template <class Scalar>
    Vector<Scalar> imbalance(const Vector<Scalar>& flow, const Vector<Scalar>& area) const;
    template <class Scalar>
    Vector<Scalar> areaOf(const Vector<Scalar>& pressure) const;
    template <class AreaOfFlow>
    void solveFlow(const AreaOfFlow& areaOfFlow);

    int nCells_;
    double squaredWaveSpeed_;
    double deltaT_;
    double cellLength_;
    double stabilisation_; ///< of the pressure, against checkerboards
    double inletVelocity_ = 1;
    double outletVelocity_ = 1; ///< at the end of the last step, as below
    double outletPressure_ = 0;
    Vector<double> oldFlow_;
    Vector<double> oldArea_;
    Vector<double> flow_;
    int step_ = 0;
    Vector<double> tangent_;
};

} // namespace tokay::coupling
