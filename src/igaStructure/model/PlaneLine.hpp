#pragma once

#include "igaStructure/model/EndFrames.hpp"
#include "igaStructure/model/LineForce.hpp"
#include "igaStructure/model/LinePattern.hpp"
#include "igaStructure/model/StructuralModel.hpp"

namespace tokay::structure {

/// State of a point of a beam's or cable's axis.
struct LineState {
    double normalForce;   ///< tension is positive [N]
    double bendingMoment; ///< positive if it turns the tangent counter-clockwise [N m]
    double shearForce;    ///< change of the moment along the axis, negative [N]
};

/// Isoparametric NURBS curve in the plane z = 0 that resists stretching and, if
/// its section does, bending, without rotational unknowns: Euler-Bernoulli beam
/// (Kirchhoff), or cable. Strains as in LineStrain; degree + 1 Gauss points an
/// element. With linear strains the prestressed reference is taken to be in
/// equilibrium, and the prestress resists turning only.
class PlaneLine : public StructuralModel {
  public:
    /// @throws InputError if the curve leaves z = 0, has no tangent somewhere, or
    /// bends but is not smooth enough (degree 2, continuous tangent)
    PlaneLine(geometry::NurbsCurve curve, const LineSection& section, Strains strains,
              const std::vector<LineSupport>& supports, LineLoads loads);

    int nUnknowns() const override { return 2 * curve_.nControlPoints(); }
    int nComponents() const override { return 2; }
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

    const geometry::NurbsCurve& curve() const { return curve_; }
    const LineSection& section() const { return section_; }

    /// Displacements of control points along x and y: the unknowns, but where a
    /// rotation is held.
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
    void requireUsable() const;
    bool hasFollowers() const { return !isLinear() && force_.hasFollowers(); }
    double normalForce(const LineStrain& strain) const;
    double bendingMoment(const LineStrain& strain) const;
    Eigen::Vector4d conjugate(const LineStrain& strain, const LineDerivatives& displacement) const;
    Eigen::Matrix4d stiffness(const LineStrain& strain) const;

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
