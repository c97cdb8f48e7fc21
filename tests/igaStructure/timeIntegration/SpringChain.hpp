// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"

#include <cmath>
#include <functional>
#include <optional>

namespace tokay::structure {

/// Bodies in a row with a spring between each two, of force k e + c e^3 for an elongation
/// e; some are supports that move, some may depend on others, and a weak support that moves
/// may hold the first one by a spring of its own.
class SpringChain : public StructuralModel {
  public:
    using Motion = std::function<double(double)>;

    /// @param motions  of each body by time [m], none for a free one
    explicit SpringChain(std::vector<std::optional<Motion>> motions)
        : motions_(std::move(motions)) {
        for (const auto& motion : motions_) {
            fixed_.push_back(motion.has_value());
        }
    }

    double stiffness = 40;
    double cubic = 0;
    double mass = 2;                          ///< of each body [kg]
    double sharedMass = 0;                    ///< between neighbours, as consistent ones have
    double damping = 0;                       ///< of the mass [1/s]
    Motion load = [](double) { return 0.0; }; ///< on each body [N]
    std::optional<SparseMatrix> dependence;   ///< the extension
    double anchor = 0;                        ///< stiffness of the weak support [N/m]
    Motion anchorMotion = [](double) { return 0.0; }; ///< of the weak support [m]

    int nUnknowns() const override { return static_cast<int>(motions_.size()); }
    int nComponents() const override { return 1; }
    bool isLinear() const override { return cubic == 0; }
    SparseMatrix massMatrix() const override {
        SparseMatrix matrix = tridiagonal(Eigen::VectorXd::Constant(nUnknowns() - 1, 1.0));
        for (int k = 0; k < matrix.outerSize(); ++k) {
            for (SparseMatrix::InnerIterator entry(matrix, k); entry; ++entry) {
                entry.valueRef() = entry.row() == entry.col() ? mass : sharedMass;
            }
        }
        return matrix;
    }
    SparseMatrix lumpedMassMatrix() const override {
        return SparseMatrix(Eigen::VectorXd::Constant(nUnknowns(), mass).asDiagonal());
    }
    double massDamping() const override { return damping; }
    double stiffnessDamping() const override { return 0; }
    Internal internalForce(const Eigen::VectorXd& u) const override {
        Internal internal{Eigen::VectorXd::Zero(nUnknowns()), 1};
        for (int k = 0; k + 1 < nUnknowns(); ++k) {
            const double e = u[k + 1] - u[k];
            const double force = stiffness * e + cubic * e * e * e;
            internal.force[k + 1] += force;
            internal.force[k] -= force;
        }
        internal.force[0] += anchor * u[0];
        return internal;
    }
    Internal internalForce(const Eigen::VectorXd& u, SparseMatrix& tangent) const override {
        const Eigen::ArrayXd e = u.tail(nUnknowns() - 1) - u.head(nUnknowns() - 1);
        tangent = tridiagonal((stiffness + 3 * cubic * e * e).matrix());
        tangent.coeffRef(0, 0) += anchor;
        return internalForce(u);
    }
    double strainEnergy(const Eigen::VectorXd& u) const override {
        const Eigen::ArrayXd e = u.tail(nUnknowns() - 1) - u.head(nUnknowns() - 1);
        return (0.5 * stiffness * e.square() + 0.25 * cubic * e.square().square()).sum() +
               0.5 * anchor * u[0] * u[0];
    }
    SupportShift supportShift(double time) const override {
        if (anchor == 0) {
            return {};
        }
        const double d = anchorMotion(time);
        return {-anchor * d * Eigen::VectorXd::Unit(nUnknowns(), 0), 0.5 * anchor * d * d,
                std::abs(d)};
    }
    const Eigen::VectorXd& externalForce(double time) override {
        external_ = Eigen::VectorXd::Constant(nUnknowns(), load(time));
        return external_;
    }
    const std::vector<bool>& fixed() const override { return fixed_; }
    bool hasPrescribedMotion() const override { return true; }
    Eigen::VectorXd prescribed(double time) const override {
        Eigen::VectorXd values = Eigen::VectorXd::Zero(nUnknowns());
        for (int k = 0; k < nUnknowns(); ++k) {
            values[k] = motions_[k] ? (*motions_[k])(time) : 0;
        }
        return values;
    }
    const SparseMatrix* extension() const override { return dependence ? &*dependence : nullptr; }
    std::vector<std::string> freeRigidMotions() const override { return {}; }
    double size() const override { return nUnknowns(); }

  private:
    // Of springs of given stiffness; all diagonal entries are present.
    SparseMatrix tridiagonal(const Eigen::VectorXd& springs) const {
        std::vector<Eigen::Triplet<double>> entries;
        for (int k = 0; k + 1 < nUnknowns(); ++k) {
            entries.insert(entries.end(), {{k, k, springs[k]},
                                           {k + 1, k + 1, springs[k]},
                                           {k, k + 1, -springs[k]},
                                           {k + 1, k, -springs[k]}});
        }
        SparseMatrix matrix(nUnknowns(), nUnknowns());
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    std::vector<std::optional<Motion>> motions_;
    std::vector<bool> fixed_;
    Eigen::VectorXd external_;
};

} // namespace tokay::structure
