// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CoupledModel.hpp"

#include <Eigen/LU>

namespace tokay::coupling {

/// What the wall of the ring is made of.
enum class RingWall { linear, cubic, geometric };

/// What the ring's fluid does besides opposing accelerations by its added mass.
struct RingFluid {
    double damping = 0;   ///< force by velocity, over that of the wall's own damping
    double stiffness = 0; ///< force by displacement, over the wall's own stiffness
    bool isEuler = false; ///< backward differences of first order in time, not of second
};

/// A ring (radial displacement at 61 points of the circle) around an annulus
/// of inviscid fluid that ends at three times its radius. The ring has mass
/// one, bending and hoop stiffness, damping and a driving load; the fluid
/// answers accelerations by its added mass, exactly known for each wave
/// number n: massRatio (1 - 3⁻²ⁿ)/(1 + 3⁻²ⁿ)/n. Newmark's method for the wall,
/// backward differences for the fluid, any step by its own length.
///
/// Walls: linear; cubic, with springs that stiffen with the cube of the
/// displacement; geometric, whose hoop strain w + w'²/2 is not linear.
class Ring : public CoupledModel {
  public:
    /// @param massRatio  added mass of the fluid over mass of the wall, μ
    Ring(RingWall wall, double massRatio, RingFluid fluid = {});

    int nUnknowns() const override { return static_cast<int>(angle_.size()); }
    double deltaT() const override { return deltaT_; }
    /// Length of the steps to come.
    void setDeltaT(double deltaT) { deltaT_ = deltaT; }
    /// As a restart from one time: the next step is Euler's.
    void forgetOlderTimes() { olderDeltaT_ = 0; }
    void beginTimeStep() override;
    Eigen::VectorXd fluid(const Eigen::VectorXd& x) override;
    Eigen::VectorXd monolithic(const Eigen::VectorXd& start) override;
    void acceptTimeStep(const Eigen::VectorXd& x) override;

    Eigen::VectorXd residual(const Eigen::VectorXd& d) override;
    void linearise(const Eigen::VectorXd& d) override;
    Eigen::MatrixXd responses(const Eigen::MatrixXd& b) override { return factors_.solve(b); }

  private:
    Eigen::VectorXd drivingLoad() const;
    Eigen::Vector3d differences() const;
    Eigen::VectorXd fluidVelocity(const Eigen::VectorXd& x) const;
    Eigen::VectorXd momentum(const Eigen::VectorXd& x) const;
    Eigen::VectorXd acceleration(const Eigen::VectorXd& x) const;
    Eigen::VectorXd velocity(const Eigen::VectorXd& x) const;

    RingWall wall_;
    RingFluid fluid_;
    Eigen::VectorXd angle_;
    Eigen::MatrixXd addedMass_;
    Eigen::MatrixXd stiffness_;
    Eigen::MatrixXd derivative_; ///< along the circle
    double frequency_;           ///< of the second mode, in the fluid
    double deltaT_;
    double olderDeltaT_; ///< of the last step; 0: what was before it is not known
    double rampTime_;    ///< in which the load rises
    double damping_;
    double time_ = 0;
    Eigen::VectorXd load_;
    Eigen::VectorXd x_, velocity_, acceleration_; ///< at the end of the last step
    Eigen::VectorXd olderX_;
    Eigen::VectorXd momentum_, olderMomentum_; ///< of the fluid, likewise
    Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

} // namespace tokay::coupling
