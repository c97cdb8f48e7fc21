// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ColouredAssembly.hpp"
#include "igaStructure/assembly/NodePattern.hpp"
#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/solid/ElasticLaw.hpp"
#include "igaStructure/kinematics/solid/SolidDescription.hpp"
#include "igaStructure/kinematics/solid/SolidElement.hpp"
#include "igaStructure/kinematics/solid/SolidLoading.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tokay::structure {

/// State of a point of a solid.
struct SolidState {
    Eigen::Vector3d displacement; ///< [m]
    Eigen::Matrix3d cauchyStress; ///< [Pa]
};

/// Isoparametric trivariate NURBS volume (total Lagrangian), degree + 1 Gauss points
/// a direction and element. Unknown 3 k + c is component c of node k.
class Solid : public StructuralModel {
  public:
    /// @throws InputError if the volume is turned inside out somewhere, or for an
    ///         incompressible material
    explicit Solid(SolidDescription description);

    int nUnknowns() const override { return 3 * nodes_->count(); }
    int nComponents() const override { return 3; }
    Eigen::VectorXd controlDisplacements(const Eigen::VectorXd& unknowns) const override {
        return nodes_->toControlPoints(unknowns);
    }
    Eigen::VectorXd onUnknowns(const Eigen::VectorXd& onControlPoints) const override {
        return nodes_->toNodes(onControlPoints);
    }
    bool isLinear() const override { return description_->strains == Strains::linear; }
    SparseMatrix massMatrix() const override;
    /// Row sums of the consistent one.
    SparseMatrix lumpedMassMatrix() const override;
    double massDamping() const override { return material().massDamping; }
    double stiffnessDamping() const override { return material().stiffnessDamping; }
    Internal internalForce(const Eigen::VectorXd& displacement) const override;
    Internal internalForce(const Eigen::VectorXd& displacement,
                           SparseMatrix& tangent) const override;
    double strainEnergy(const Eigen::VectorXd& displacement) const override;
    /// Pressures act on a linear solid at rest.
    const Eigen::VectorXd& externalForce(double time) override;
    void addFollowerForce(const Eigen::VectorXd& displacement, double time,
                          Eigen::VectorXd& force) const override;
    void subtractFollowerDerivative(const Eigen::VectorXd& displacement, double time,
                                    SparseMatrix& tangent) const override;
    bool hasSymmetricTangent() const override { return hasSymmetricTangent_; }
    const std::vector<bool>& fixed() const override { return fixed_; }
    bool hasPrescribedMotion() const override { return !trace_.isEmpty(); }
    Eigen::VectorXd prescribed(double time) const override { return trace_.at(time); }
    std::vector<std::string> supportNames() const override;
    std::vector<SupportLoad> supportLoads(const Eigen::VectorXd& displacement,
                                          const Eigen::VectorXd& reaction,
                                          double time) const override;
    std::vector<std::string> freeRigidMotions() const override;
    double size() const override;

    const geometry::NurbsVolume& volume() const { return description_->volume; }
    const PatchNodes& nodes() const { return *nodes_; }
    const ElasticMaterial& material() const { return description_->material; }
    int nElements() const { return grid_.nElements(); }
    /// [kg]
    double mass() const;

    /// Threads of assembly; if never said, as many as there are and work pays for. The
    /// result is the same for any number.
    void setThreads(int nThreads) { nThreads_ = nThreads; }

    SolidState stateAt(const Eigen::Vector3d& parameters,
                       const Eigen::VectorXd& displacement) const;

  private:
    // Strain, stress and their derivatives at a point.
    struct PointAnswer {
        Eigen::Matrix3d firstPiola;
        ElasticResponse response;
        Eigen::Matrix3d gradient; ///< deformation gradient; linear: the identity
        double volumeRatio;
    };
    PointAnswer answer(const Eigen::Matrix3d& displacementGradient) const;

    struct Workspace;
    struct Totals;
    void visitElement(SolidElement& element, int row, const Eigen::VectorXd& displacement,
                      SparseMatrix* tangent, Workspace& workspace, Totals& totals) const;
    void addPoint(const SolidElement& element, int row, bool withTangent, Workspace& workspace,
                  Totals& totals) const;
    void evaluate(const Eigen::VectorXd& displacement, SparseMatrix* tangent, Totals& totals) const;
    // Calls visit(element, row, thread) for all elements; rows run along xi.
    template <class Visit>
    void forEachElement(Visit visit) const;
    void addPressure(const Eigen::VectorXd& displacement, double time,
                     Eigen::VectorXd& force) const;
    int nThreads() const;
    Eigen::Vector3i elementOfRow(int row, int element) const;
    std::vector<std::vector<int>> nodesOfRows() const;

    std::unique_ptr<const SolidDescription> description_; ///< keeps its place when moved
    std::unique_ptr<const PatchNodes> nodes_;
    ElasticLaw law_;
    std::vector<bool> fixed_;
    SupportTrace trace_;
    SupportOwners owners_;
    bool hasSymmetricTangent_;
    SolidGrid grid_;
    ColouredAssembly rows_;
    NodePattern pattern_;
    std::unique_ptr<SolidLoading> loading_;
    Eigen::VectorXd externalForce_;
    int nThreads_ = 0;
};

} // namespace tokay::structure
