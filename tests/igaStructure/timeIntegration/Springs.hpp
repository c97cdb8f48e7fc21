// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"

#include <functional>

namespace tokay::structure {

/// Springs that do not know of each other, one an unknown, of any law: a structure whose
/// solution, tangent and volume ratio a test knows in closed form.
class Springs : public StructuralModel {
  public:
    using Law = std::function<double(double)>;

    /// @param force, stiffness  of a spring by its displacement [N, N/m]
    Springs(int nSprings, Law force, Law stiffness)
        : force_(std::move(force)), stiffness_(std::move(stiffness)),
          fixed_(static_cast<std::size_t>(nSprings), false) {}

    bool linear = false;
    double mass = 1;                                             ///< of each [kg]
    Law load = [](double) { return 0.0; };                       ///< on each, by time [N]
    Law ratio = [](double) { return 1.0; };                      ///< of volumes, by displacement
    std::function<double(int)> factor = [](int) { return 1.0; }; ///< on the stiffness of each

    int nUnknowns() const override { return static_cast<int>(fixed_.size()); }
    int nComponents() const override { return 2; }
    bool isLinear() const override { return linear; }
    SparseMatrix massMatrix() const override {
        return SparseMatrix(Eigen::VectorXd::Constant(nUnknowns(), mass).asDiagonal());
    }
    double massDamping() const override { return 0; }
    double stiffnessDamping() const override { return 0; }
    Internal internalForce(const Eigen::VectorXd& displacement) const override {
        Internal internal{displacement.unaryExpr(force_), 1};
        for (const double u : displacement) {
            internal.smallestVolumeRatio = std::min(internal.smallestVolumeRatio, ratio(u));
        }
        return internal;
    }
    Internal internalForce(const Eigen::VectorXd& displacement,
                           SparseMatrix& tangent) const override {
        Eigen::VectorXd diagonal = displacement.unaryExpr(stiffness_);
        for (int k = 0; k < nUnknowns(); ++k) {
            diagonal[k] *= factor(k);
        }
        tangent = SparseMatrix(diagonal.asDiagonal());
        return internalForce(displacement);
    }
    double strainEnergy(const Eigen::VectorXd& /*displacement*/) const override { return 0; }
    const Eigen::VectorXd& externalForce(double time) override {
        external_ = Eigen::VectorXd::Constant(nUnknowns(), load(time));
        return external_;
    }
    const std::vector<bool>& fixed() const override { return fixed_; }
    std::vector<std::string> freeRigidMotions() const override { return {}; }
    double size() const override { return 1; }

  private:
    Law force_, stiffness_;
    std::vector<bool> fixed_;
    Eigen::VectorXd external_;
};

} // namespace tokay::structure
