// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/NodePattern.hpp"
#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/shell/ShellSupports.hpp"
#include "igaStructure/kinematics/shell/element/ElementRows.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"
#include "igaStructure/kinematics/shell/element/ShellNodes.hpp"
#include "igaStructure/kinematics/shell/loads/DeadLoads.hpp"
#include "igaStructure/kinematics/shell/loads/FollowerLoads.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// State of a point of a shell. Vectors (11, 22, 12) are Cartesian components in the
/// tangent plane, axis 1 along the first parameter line.
struct ShellState {
    Eigen::Vector3d displacement; ///< [m]
    Eigen::Vector3d force;        ///< n, per current length [N/m]
    Eigen::Vector3d moment;       ///< m, per current length [N]
};

/// Rotation-free Kirchhoff-Love shell, or a membrane, on trimmed NURBS patches that
/// are joined along their edges (total Lagrangian, isoparametric). Rotational
/// inertia of the thickness is left out.
/// Source: Kiendl, Bletzinger, Linhard & Wuechner 2009
class Shell : public StructuralModel {
  public:
    /// @throws InputError if a patch is degenerate, patches that shall be joined are
    ///         apart, or a membrane has a load that needs bending
    explicit Shell(ShellDescription description);

    int nUnknowns() const override { return 3 * nodes_.count(); }
    int nComponents() const override { return 3; }
    bool isLinear() const override { return description_.strains == Strains::linear; }
    SparseMatrix massMatrix() const override;
    SparseMatrix lumpedMassMatrix() const override;
    double massDamping() const override { return description_.material.massDamping; }
    double stiffnessDamping() const override { return description_.material.stiffnessDamping; }
    Internal internalForce(const Eigen::VectorXd& displacement) const override;
    Internal internalForce(const Eigen::VectorXd& displacement,
                           SparseMatrix& tangent) const override;
    Internal mixedInternalForce(const Eigen::VectorXd& displacement,
                                const Eigen::VectorXd& linearisedAt,
                                SparseMatrix& tangent) const override;
    double strainEnergy(const Eigen::VectorXd& displacement) const override;
    /// Dead loads; a linear shell takes follower loads at rest.
    const Eigen::VectorXd& externalForce(double time) override;
    void addFollowerForce(const Eigen::VectorXd& displacement, double time,
                          Eigen::VectorXd& force) const override;
    void subtractFollowerDerivative(const Eigen::VectorXd& displacement, double time,
                                    SparseMatrix& tangent) const override;
    bool hasSymmetricTangent() const override { return hasSymmetricTangent_; }
    const std::vector<bool>& fixed() const override { return constraints().fixed; }
    bool hasPrescribedMotion() const override { return supports_->hasPrescribedMotion(); }
    Eigen::VectorXd prescribed(double time) const override { return supports_->prescribed(time); }
    const SparseMatrix* extension() const override {
        const DirichletExtension* own = dirichletExtension();
        return own && own->isClosed() ? &own->matrix() : nullptr;
    }
    bool hasDependents() const override { return dirichletExtension() != nullptr; }
    bool settlePrescribed(const Eigen::VectorXd& displacement) override {
        return supports_->settle(displacement);
    }
    SupportShift supportShift(double time) const override { return supports_->shift(time); }
    bool resistInertia(double massFactor) override { return supports_->resistInertia(massFactor); }
    std::vector<std::string> supportNames() const override { return supports_->names(); }
    std::vector<SupportLoad> supportLoads(const Eigen::VectorXd& displacement,
                                          const Eigen::VectorXd& reaction,
                                          double time) const override {
        return supports_->loads(displacement, reaction, time);
    }
    std::vector<std::string> freeRigidMotions() const override;
    std::vector<std::string> looseParts() const override;
    double size() const override { return description_.model.size(); }

    const ShellDescription& description() const { return description_; }
    const geometry::BrepModel& model() const { return description_.model; }
    const ShellNodes& nodes() const { return nodes_; }
    const ShellPatches& patches() const { return patches_; }
    const ShellConstraints& constraints() const { return supports_->constraints(); }
    /// Of supports on trimming curves by EdgeMethod::egm; none: there are none.
    const DirichletExtension* dirichletExtension() const { return supports_->extension(); }

    /// Sets the number of threads of assembly; by default as many as are available and pay. The
    /// result is the same for any number.
    void setThreads(int nThreads) { nThreads_ = nThreads; }

    /// Displacement of a point at a distance zeta from the middle surface, along its normal [m].
    Eigen::Vector3d displacementAt(int face, const geometry::Parameters& at, double zeta,
                                   const Eigen::VectorXd& displacement) const;

    /// Derivatives of the displacement by x and y, of a patch in the plane z = 0.
    Eigen::Matrix2d planeGradientAt(int face, const geometry::Parameters& at,
                                    const Eigen::VectorXd& displacement) const;

    ShellState stateAt(int face, double xi, double eta, const Eigen::VectorXd& displacement) const;

  private:
    struct Workspace;
    struct Totals;
    struct Evaluation;
    struct PointAnswer;
    void buildPatches();
    void buildPattern();
    PointAnswer linearAnswer(const ShellElement& element,
                             const SurfaceDerivatives& displacement) const;
    PointAnswer nonlinearAnswer(const ShellElement& element, const SurfaceDerivatives& displacement,
                                const SurfaceDerivatives* linearisedAt, bool withStiffness) const;
    void visitElement(ShellElement& element, int row, const Evaluation& evaluation,
                      Workspace& workspace, Totals& totals) const;
    void addCouplings(const Eigen::VectorXd& displacement, SparseMatrix* tangent,
                      Eigen::VectorXd& force, double& energy) const;
    Internal evaluate(const Evaluation& evaluation, double& energy) const;
    int nThreads() const;
    ShellElement elementAt(int face, const geometry::Parameters& at) const;

    ShellDescription description_;
    ShellNodes nodes_;
    ShellPatches patches_;
    std::unique_ptr<ElementRows> sweep_;
    std::unique_ptr<ShellSupports> supports_;
    std::unique_ptr<NodePattern> pattern_;
    std::unique_ptr<DeadLoads> deadLoads_;
    std::unique_ptr<FollowerLoads> followerLoads_;
    Eigen::VectorXd externalForce_;
    bool hasSymmetricTangent_;
    int nThreads_ = 0;
};

} // namespace tokay::structure
