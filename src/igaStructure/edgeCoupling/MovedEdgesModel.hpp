// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/StructuralModel.hpp"
#include "mapper/mortar/EdgeQuadrature.hpp"
#include "mapper/mortar/EdgeTrace.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// A structure whose edges move as they are told: its equations, in unknowns of which
/// those that the motion of the edges determines are prescribed.
///
/// Where the trace determines all control values of an edge these are the unknowns
/// themselves. On a trimmed edge unknowns are turned, so that some carry the trace and the
/// others, which leave the edge where it is, stay in equilibrium (mapper::EdgeTrace). Control
/// values that a support of the structure holds stay held.
class MovedEdgesModel : public StructuralModel {
  public:
    /// @param model  is kept by reference
    /// @param edge   functions by numbers of control points; is kept by reference
    /// @param controlPoints  in the reference configuration, n x 3 [m]
    /// @throws InputError if supports hold the edges altogether, or unknowns of the structure
    ///         depend on others
    MovedEdgesModel(StructuralModel& model, const mapper::EdgeQuadrature& edge,
                    geometry::Points controlPoints);

    /// Displacements of the edge's points from now on, nPoints x nComponents [m].
    void move(const Eigen::MatrixXd& displacements);

    /// Forces at the edge's points that the reactions of the prescribed unknowns are,
    /// nPoints x nComponents [N].
    Eigen::MatrixXd forcesAtPoints(const Eigen::VectorXd& reaction) const;

    /// The structure's own unknowns (forces on them) by those of this model.
    Eigen::VectorXd ofStructure(const Eigen::VectorXd& unknowns) const {
        return turns_ ? Eigen::VectorXd(basis_ * unknowns) : unknowns;
    }

    /// The reverse of ofStructure().
    Eigen::VectorXd fromStructure(const Eigen::VectorXd& own) const { return turned(own); }

    /// What the trace determines of one component; none if supports hold it.
    const std::optional<mapper::EdgeTrace>& trace(int component) const {
        return parts_[static_cast<std::size_t>(component)].trace;
    }

    int nUnknowns() const override { return model_.nUnknowns(); }
    int nComponents() const override { return model_.nComponents(); }
    Eigen::VectorXd controlDisplacements(const Eigen::VectorXd& unknowns) const override {
        return model_.controlDisplacements(ofStructure(unknowns));
    }
    Eigen::VectorXd onUnknowns(const Eigen::VectorXd& onControlPoints) const override {
        return turned(model_.onUnknowns(onControlPoints));
    }
    bool isLinear() const override { return model_.isLinear(); }
    SparseMatrix massMatrix() const override { return turned(model_.massMatrix()); }
    double massDamping() const override { return model_.massDamping(); }
    double stiffnessDamping() const override { return model_.stiffnessDamping(); }
    Internal internalForce(const Eigen::VectorXd& displacement) const override;
    Internal internalForce(const Eigen::VectorXd& displacement,
                           SparseMatrix& tangent) const override;
    Internal mixedInternalForce(const Eigen::VectorXd& displacement,
                                const Eigen::VectorXd& linearisedAt,
                                SparseMatrix& tangent) const override;
    double strainEnergy(const Eigen::VectorXd& displacement) const override {
        return model_.strainEnergy(ofStructure(displacement));
    }
    const Eigen::VectorXd& externalForce(double time) override;
    void addFollowerForce(const Eigen::VectorXd& displacement, double time,
                          Eigen::VectorXd& force) const override;
    void subtractFollowerDerivative(const Eigen::VectorXd& displacement, double time,
                                    SparseMatrix& tangent) const override;
    bool hasSymmetricTangent() const override { return model_.hasSymmetricTangent(); }
    const std::vector<bool>& fixed() const override { return fixed_; }
    bool hasPrescribedMotion() const override { return true; }
    Eigen::VectorXd prescribed(double time) const override;
    SupportShift supportShift(double time) const override;
    bool resistInertia(double massFactor) override { return model_.resistInertia(massFactor); }
    std::vector<std::string> supportNames() const override { return model_.supportNames(); }
    std::vector<SupportLoad> supportLoads(const Eigen::VectorXd& displacement,
                                          const Eigen::VectorXd& reaction,
                                          double time) const override {
        return model_.supportLoads(ofStructure(displacement), ofStructure(reaction), time);
    }
    std::vector<std::string> freeRigidMotions() const override;
    std::vector<std::string> looseParts() const override { return model_.looseParts(); }
    double size() const override { return model_.size(); }

  private:
    /// One component of the edges: unknowns that no support holds, and their trace.
    struct Part {
        std::vector<int> unknowns;
        std::optional<mapper::EdgeTrace> trace;
        Eigen::VectorXd coefficients; ///< prescribed ones
    };
    Part makePart(int component, const Eigen::VectorXd& unknownOf) const;
    void makeBasis();
    Eigen::VectorXd turned(const Eigen::VectorXd& forces) const;
    SparseMatrix turned(const SparseMatrix& matrix) const;

    StructuralModel& model_;
    const mapper::EdgeQuadrature& edge_;
    geometry::Points controlPoints_;
    std::vector<Part> parts_;
    std::vector<bool> fixed_;
    bool turns_ = false;
    SparseMatrix basis_; ///< B: own unknowns by those of this model
    mutable SparseMatrix ownTangent_;
    Eigen::VectorXd externalForce_;
};

} // namespace tokay::structure
