// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/LinePattern.hpp"
#include "igaStructure/assembly/StructuralModel.hpp"
#include "igaStructure/kinematics/beam/EndFrames.hpp"
#include "igaStructure/kinematics/beam/LineForce.hpp"

namespace tokay::structure {

/// State of a point of a beam's or cable's axis.
struct LineState {
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
/// configuration. Strains as in LineStrain; degree + 1 Gauss points an element. With linear strains
/// the prestressed reference is taken to be in equilibrium, and the prestress resists turning only.
class Line : public StructuralModel {
  public:
    /// @param dimension  2: in the plane z = 0; 3: in space, without pressures and moments
    /// @throws InputError if a curve of the plane leaves z = 0, has no tangent somewhere,
    /// or bends but is not smooth enough (degree 2, continuous tangent) or, in space,
    /// not straight
    Line(geometry::NurbsCurve curve, const LineSection& section, Strains strains,
         const std::vector<LineSupport>& supports, LineLoads loads, int dimension = 2);

    int nUnknowns() const override { return dimension_ * curve_.nControlPoints(); }
    int nComponents() const override { return dimension_; }
    bool isLinear() const override { return strains_ == Strains::linear; }

    /// With the rotary inertia of the reference configuration, if the section has it.
    SparseMatrix massMatrix() const override;
    /// Of control points, as row sums of the consistent one without rotary
    /// inertia; where a rotation is held, as its unknowns have it.
    SparseMatrix lumpedMassMatrix() const override;
    double massDamping() const override { return section_.massDamping; }
    double stiffnessDamping() const override { return section_.stiffnessDamping; }
    Internal internalForce(const Eigen::VectorXd& displacement) const override;
    Internal internalForce(const Eigen::VectorXd& displacement,
                           SparseMatrix& tangent) const override;
    double strainEnergy(const Eigen::VectorXd& displacement) const override;
    const Eigen::VectorXd& externalForce(double time) override;
    void addFollowerForce(const Eigen::VectorXd& displacement, double time,
                          Eigen::VectorXd& force) const override;
    void subtractFollowerDerivative(const Eigen::VectorXd& displacement, double time,
                                    SparseMatrix& tangent) const override;
    /// Not so with pressures that vary along the line or end at a free end.
    bool hasSymmetricTangent() const override;
    const std::vector<bool>& fixed() const override { return frames_.fixed(); }
    std::vector<std::string> freeRigidMotions() const override;
    double size() const override;

    /// 2: in the plane z = 0; 3: in space.
    int dimension() const { return dimension_; }
    const geometry::NurbsCurve& curve() const { return curve_; }
    const LineSection& section() const { return section_; }

    /// Displacements of control points along x, y and in space z: the unknowns,
    /// but where a rotation is held.
    Eigen::VectorXd controlDisplacements(const Eigen::VectorXd& unknowns) const {
        return frames_.displacements(unknowns);
    }
    /// The transpose.
    Eigen::VectorXd onUnknowns(const Eigen::VectorXd& onControlPoints) const {
        return frames_.forces(onControlPoints);
    }

    /// Of the axis [m].
    double length() const;

    LineState stateAt(double xi, const Eigen::VectorXd& displacement) const;

  private:
    using Vector6d = Eigen::Matrix<double, 6, 1>;

    void requireUsable() const;
    void requireSmooth() const;
    bool hasFollowers() const { return !isLinear() && force_.hasFollowers(); }
    double normalForce(const LineStrain& strain) const;
    Eigen::Vector3d bendingMoment(const LineStrain& strain) const;
    Vector6d conjugate(const LineStrain& strain, const LineDerivatives& displacement) const;
    LineStrain::Matrix6d stiffness(const LineStrain& strain) const;
    Eigen::MatrixXd onElement(const LinePoint& point, const LineStrain::Matrix6d& stiffness) const;
    Eigen::MatrixXd elementMass(const LinePoint& point) const;

    int dimension_;
    geometry::NurbsCurve curve_;
    LineSection section_;
    Strains strains_;
    std::vector<LinePoint> points_;
    EndFrames frames_;
    LinePattern pattern_;
    LineForce force_;
    Eigen::VectorXd externalForce_;
};

} // namespace tokay::structure
