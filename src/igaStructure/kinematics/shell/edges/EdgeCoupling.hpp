// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/Field.hpp"
#include "igaStructure/kinematics/shell/edges/EdgePoint.hpp"

#include <array>

namespace tokay::structure {

/// Energy that constrains the motion of a location of a shell, or couples two locations.
class EdgeCoupling {
  public:
    /// Its force, tangent and energy for the nodes.
    struct Answer {
        Eigen::VectorXd force;   ///< component c of node k is number 3 k + c
        Eigen::MatrixXd tangent; ///< symmetric; empty: not asked for
        double energy = 0;
    };

    /// What a motion of the support adds to an answer.
    struct Shift {
        Eigen::VectorXd force; ///< on the nodes; empty: none
        double energy = 0;     ///< beside force times displacement
        double largest = 0;    ///< of the motion [m]
    };

    virtual ~EdgeCoupling() = default;

    /// Nodes of the location, then of the other one.
    const std::vector<int>& nodes() const { return nodes_; }

    /// @param displacement  of all nodes of the shell
    virtual Answer answer(const Eigen::VectorXd& displacement, Strains strains,
                          bool withTangent) const = 0;

    /// Of a coupling that holds components of the displacement.
    virtual Shift shift(const VectorField& /*motion*/, double /*time*/) const { return {}; }

    /// Stiffens the springs by their mass times a factor: what inertia adds to the stiffness
    /// of an element in a time step (StructuralModel::resistInertia).
    /// @param massFactor  0: none, as at first [1/s^2]
    virtual void resistInertia(double /*massFactor*/) {}

    /// Derivative of each constrained quantity by the displacement of the nodes, at
    /// rest: a row each.
    virtual Eigen::MatrixXd restRows() const = 0;

  protected:
    explicit EdgeCoupling(const PatchLocation& side, const PatchLocation* other);
    explicit EdgeCoupling(std::vector<int> nodes) : nodes_(std::move(nodes)) {}

    /// The nodes' own of a vector with three entries a node.
    Eigen::VectorXd gathered(const Eigen::VectorXd& displacement) const;

    std::vector<int> nodes_;
};

/// A place with a factor, of a sum of displacements.
struct WeightedPlace {
    Eigen::Vector3d position;
    double factor;
};

/// Penalty on components of the displacement, or of its jump.
class DisplacementPenalty : public EdgeCoupling {
  public:
    /// @param stiffness  energy is half of displacement . stiffness displacement [N/m];
    ///                   rows and columns of components that are not held are left out
    /// @param mass       [kg]
    DisplacementPenalty(const PatchLocation& side, const PatchLocation* other,
                        const std::array<bool, 3>& components, const Eigen::Matrix3d& stiffness,
                        double mass);

    /// Penalty on a weighted sum of the nodes' displacements.
    /// @param nodes   each once
    /// @param places  of the sum, for the motion of a support
    DisplacementPenalty(std::vector<int> nodes, Eigen::RowVectorXd weights,
                        const std::array<bool, 3>& components, const Eigen::Matrix3d& stiffness,
                        double mass, std::vector<WeightedPlace> places);

    Answer answer(const Eigen::VectorXd& displacement, Strains strains,
                  bool withTangent) const override;
    Shift shift(const VectorField& motion, double time) const override;
    void resistInertia(double massFactor) override;
    Eigen::MatrixXd restRows() const override;

  private:
    std::array<bool, 3> components_;
    std::vector<WeightedPlace> places_;
    Eigen::Matrix3d elastic_, stiffness_; ///< without and with what resists inertia
    double mass_;
    Eigen::RowVectorXd row_; ///< functions, those of the other place negative
};

/// Penalty on the rotation about the edge's tangent, or the angle between two patches.
/// Source: Herrema, Johnson, Proserpio, Wu, Kiendl & Hsu 2019, equation 21
class RotationPenalty : public EdgeCoupling {
  public:
    /// Places are copied.
    /// @param stiffness  energy is stiffness/2 times angle squared, if small [N m]
    RotationPenalty(const PatchLocation& side, const PatchLocation* other, double stiffness);

    Answer answer(const Eigen::VectorXd& displacement, Strains strains,
                  bool withTangent) const override;
    Eigen::MatrixXd restRows() const override;

    /// A constrained quantity as a function of the base vectors of one or both locations.
    struct Measure {
        double value;
        Eigen::VectorXd gradient;
        Eigen::MatrixXd hessian; ///< empty: none, or not asked for
    };
    /// Constrained quantities, one or two; the values are their changes since rest.
    std::vector<Measure> changes(const Eigen::VectorXd& displacement, Strains strains,
                                 bool withHessian) const;
    /// Base vectors' change by the nodes' displacement.
    const Eigen::MatrixXd& baseVectorRows() const { return rows_; }

  private:
    using BaseVectors = std::vector<Eigen::Matrix<double, 3, 2>>;
    std::vector<Measure> measures(const BaseVectors& a, bool withHessian) const;
    BaseVectors current(const Eigen::VectorXd& displacement) const;

    std::vector<PatchLocation> locations_;
    double stiffness_;
    Eigen::MatrixXd rows_; ///< base vectors' change is rows_ times the nodes' displacement
    std::vector<Measure> atRest_;
    Eigen::Vector3d conormal_; ///< at rest
};

} // namespace tokay::structure
