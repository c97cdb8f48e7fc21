#pragma once

#include <Eigen/Core>

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
class ElasticTube {
  public:
    /// @param nCells
    /// @param stiffness  κ, wave speed over inlet velocity
    /// @param deltaT     τ, time step over transit time
    ElasticTube(int nCells, double stiffness, double deltaT);

    /// Next time step: u at the inlet is 1 + 0.1 sin²(πt).
    void beginTimeStep();

    /// Pressure of the flow through cross-sections 1 + x.
    /// @throws SolverError if Newton's method fails
    Eigen::VectorXd fluid(const Eigen::VectorXd& x);

    /// x of the tube under this pressure.
    Eigen::VectorXd structure(const Eigen::VectorXd& pressure) const;

    /// Both at once, by Newton's method on the joint equations.
    Eigen::VectorXd monolithic();

    /// Ends the step with the flow of the last call of fluid or monolithic.
    void acceptTimeStep(const Eigen::VectorXd& x);

    double deltaT() const { return deltaT_; }

  private:
    template <class Scalar>
    using Vector = Eigen::Array<Scalar, Eigen::Dynamic, 1>;
    /// Flow of all cells: velocities, then pressures.
    template <class Scalar>
    Vector<Scalar> residual(const Vector<Scalar>& flow, const Vector<Scalar>& area) const;
    template <class Scalar>
    Vector<Scalar> areaOf(const Vector<Scalar>& pressure) const;
    template <class AreaOfFlow>
    void solve(const AreaOfFlow& areaOfFlow);

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
};

} // namespace tokay::coupling
