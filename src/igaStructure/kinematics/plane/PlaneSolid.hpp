// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/NodePattern.hpp"
#include "igaStructure/assembly/PatchNodes.hpp"
#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/assembly/TabulatedBasis.hpp"
#include "igaStructure/kinematics/plane/ExternalForce.hpp"
#include "igaStructure/kinematics/plane/PlaneElement.hpp"
#include "igaStructure/kinematics/plane/PlaneMaterial.hpp"
#include "igaStructure/kinematics/plane/Supports.hpp"

namespace tokay::structure {

/// State of a point of a plane body.
struct PlaneState {
    Eigen::Vector2d displacement;
    Eigen::Matrix3d cauchyStress; ///< [Pa]
};

/// Isoparametric NURBS patch that deforms in its plane (total Lagrangian,
/// St. Venant-Kirchhoff), degree + 1 Gauss points a direction and element.
class PlaneSolid : public StructuralModel {
  public:
    /// @param isSlit  opposite edges that coincide stay apart
    /// @throws InputError if the patch folds over, or does not lie in z = 0
    PlaneSolid(geometry::NurbsSurface surface, const PlaneMaterial& material, Strains strains,
               const std::vector<Support>& supports, Loads loads, bool isSlit = false);

    int nUnknowns() const override { return 2 * nodes_.count(); }
    int nComponents() const override { return 2; }
    Eigen::VectorXd controlDisplacements(const Eigen::VectorXd& unknowns) const override {
        return nodes_.toControlPoints(unknowns);
    }
    Eigen::VectorXd onUnknowns(const Eigen::VectorXd& onControlPoints) const override {
        return nodes_.toNodes(onControlPoints);
    }
    bool isLinear() const override { return strains_ == Strains::linear; }
    SparseMatrix massMatrix() const override;
    /// Row sums of the consistent one.
    SparseMatrix lumpedMassMatrix() const override;
    double massDamping() const override { return material_.massDamping; }
    double stiffnessDamping() const override { return material_.stiffnessDamping; }
    Internal internalForce(const Eigen::VectorXd& displacement) const override;
    Internal internalForce(const Eigen::VectorXd& displacement,
                           SparseMatrix& tangent) const override;
    double strainEnergy(const Eigen::VectorXd& displacement) const override;
    const Eigen::VectorXd& externalForce(double time) override;
    const std::vector<bool>& fixed() const override { return fixed_; }
    bool hasPrescribedMotion() const override { return !trace_.isEmpty(); }
    Eigen::VectorXd prescribed(double time) const override { return trace_.at(time); }
    std::vector<std::string> supportNames() const override;
    std::vector<SupportLoad> supportLoads(const Eigen::VectorXd& displacement,
                                          const Eigen::VectorXd& reaction,
                                          double time) const override;
    std::vector<std::string> freeRigidMotions() const override;
    double size() const override;

    const geometry::NurbsSurface& surface() const { return surface_; }
    const PatchNodes& nodes() const { return nodes_; }
    const PlaneMaterial& material() const { return material_; }
    int nElements() const { return u_.nSpans() * v_.nSpans(); }

    PlaneState stateAt(double xi, double eta, const Eigen::VectorXd& displacement) const;

  private:
    // In-plane strain (11, 22, 2*12), and the matrix that its variation needs:
    // the deformation gradient, or the identity if strains are linear.
    struct Strain {
        Eigen::Vector3d value;
        Eigen::Matrix2d gradient;
        double volumeRatio;
    };
    Strain strain(const Eigen::Matrix2d& displacementGradient) const;

    struct Workspace;
    void addTangent(const PlaneElementTable::Gradients& gradients, double volume,
                    const Strain& strain, int point, Workspace& workspace) const;

    // Calls visit(element) at each Gauss point, and finish(element) after the
    // last one of each element.
    template <class Visit, class Finish>
    void forEachPoint(Visit visit, Finish finish) const;

    // Calls visit(point, gradients, volume, strain) at each Gauss point, and
    // finish(nodes) after the last one of each element.
    template <class Visit, class Finish>
    void forEachStrain(const Eigen::VectorXd& displacement, Visit visit, Finish finish) const;

    geometry::NurbsSurface surface_;
    PatchNodes nodes_;
    PlaneMaterial material_;
    Strains strains_;
    Eigen::Matrix3d stiffness_;
    Eigen::Matrix3d stiffnessRoot_; ///< upper triangular R, C = R^T R
    std::vector<bool> fixed_;
    SupportTrace trace_;
    std::vector<std::string> supportNames_;
    SupportOwners owners_;
    TabulatedBasis u_, v_;
    PlaneElementTable elements_;
    NodePattern pattern_;
    ExternalForce external_;
    Eigen::VectorXd externalForce_;
};

} // namespace tokay::structure
