// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/NodePattern.hpp"
#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/beam/BeamForce.hpp"
#include "igaStructure/kinematics/beam/EndFrames.hpp"

namespace tokay::structure {

/// State of a point of a beam's or cable's axis.
struct BeamState {
    double normalForce; ///< tension is positive [N]
    /// Positive if it turns the tangent counter-clockwise; in space the moment
    /// vector's length [N m].
    double bendingMoment;
    /// Change of the moment along the axis, negative; in space its length [N].
    double shearForce;
};

/// Isoparametric NURBS curve, in the plane z = 0 or in space, that resists
/// stretching and, if its section does, bending, without rotational unknowns:
/// Euler-Bernoulli beam (Kirchhoff), or cable. A beam in space bends alike in all
/// directions, has no torsional stiffness, and is straight in its reference
/// configuration. Strains as in BeamStrain; degree + 1 Gauss points an element. With linear strains
/// the prestressed reference is taken to be in equilibrium, and the prestress resists turning only.
class Beam : public StructuralModel {
  public:
    /// @param dimension  2: in the plane z = 0; 3: in space, without pressures and moments
    /// @throws InputError if a curve of the plane leaves z = 0, has no tangent somewhere,
    /// or bends but is not smooth enough (degree 2, continuous tangent) or, in space,
    /// not straight
    Beam(geometry::NurbsCurve curve, const BeamSection& section, Strains strains,
         const std::vector<BeamSupport>& supports, BeamLoads loads, int dimension = 2);

    int nUnknowns() const override { return dimension_ * curve_.nControlPoints(); }
    int nComponents() const override { return dimension_; }
    /// Other than the unknowns where a rotation is held.
    Eigen::VectorXd controlDisplacements(const Eigen::VectorXd& unknowns) const override {
        return frames_.displacements(unknowns);
    }
    Eigen::VectorXd onUnknowns(const Eigen::VectorXd& onControlPoints) const override {
        return frames_.forces(onControlPoints);
    }
    bool isLinear() const override { return strains_ == Strains::linear; }

    /// Consistent mass, with the rotary inertia of the reference configuration, if the section has
    /// it.
    SparseMatrix massMatrix() const override;
    /// Lumped mass: row sums of the consistent one without rotary inertia; where a
    /// rotation is constrained, for its unknowns.
    SparseMatrix lumpedMassMatrix() const override;
    double massDamping() const override { return section_.massDamping; }
    double stiffnessDamping() const override { return section_.stiffnessDamping; }
    Internal internalForce(const Eigen::VectorXd& displacement) const override;
    Internal internalForce(const Eigen::VectorXd& displacement,
                           SparseMatrix& tangent) const override;
    Internal mixedInternalForce(const Eigen::VectorXd& displacement,
                                const Eigen::VectorXd& linearisedAt,
                                SparseMatrix& tangent) const override;
    double strainEnergy(const Eigen::VectorXd& displacement) const override;
    const Eigen::VectorXd& externalForce(double time) override;
    void addFollowerForce(const Eigen::VectorXd& displacement, double time,
                          Eigen::VectorXd& force) const override;
    void subtractFollowerDerivative(const Eigen::VectorXd& displacement, double time,
                                    SparseMatrix& tangent) const override;
    /// False with pressures that vary along the beam or end at a free end.
    bool hasSymmetricTangent() const override;
    const std::vector<bool>& fixed() const override { return frames_.fixed(); }
    bool hasPrescribedMotion() const override { return !frames_.trace().isEmpty(); }
    Eigen::VectorXd prescribed(double time) const override { return frames_.trace().at(time); }
    std::vector<std::string> supportNames() const override;
    std::vector<SupportLoad> supportLoads(const Eigen::VectorXd& displacement,
                                          const Eigen::VectorXd& reaction,
                                          double time) const override;
    std::vector<std::string> freeRigidMotions() const override;
    double size() const override;

    /// 2: in the plane z = 0; 3: in space.
    int dimension() const { return dimension_; }
    const geometry::NurbsCurve& curve() const { return curve_; }
    const BeamSection& section() const { return section_; }

    /// Length of the axis [m].
    double length() const;

    BeamState stateAt(double xi, const Eigen::VectorXd& displacement) const;

  private:
    using Vector6d = Eigen::Matrix<double, 6, 1>;

    void requireUsable() const;
    void requireSmooth() const;
    bool hasFollowers() const { return !isLinear() && force_.hasFollowers(); }
    double normalForce(const BeamStrain& strain) const;
    Eigen::Vector3d bendingMoment(const BeamStrain& strain) const;
    Vector6d conjugate(const BeamStrain& strain, const BeamDerivatives& displacement) const;
    BeamStrain::Matrix6d stiffness(const BeamStrain& strain) const;
    BeamStrain::Matrix6d stiffness(const BeamStrain& strain, double axialForce,
                                   const Eigen::Vector3d& moment) const;
    Eigen::MatrixXd onElement(const BeamPoint& point, const BeamStrain::Matrix6d& stiffness) const;
    /// Control points of the functions of an element.
    std::vector<int> nodesOf(int element) const;
    Eigen::MatrixXd elementMass(const BeamPoint& point) const;

    int dimension_;
    geometry::NurbsCurve curve_;
    BeamSection section_;
    Strains strains_;
    std::vector<BeamPoint> points_;
    EndFrames frames_;
    std::vector<std::string> supportNames_;
    NodePattern pattern_;
    BeamForce force_;
    Eigen::VectorXd externalForce_;
};

} // namespace tokay::structure
