// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/LatestValue.hpp"
#include "igaStructure/assembly/SparseMatrix.hpp"
#include "igaStructure/kinematics/shell/edges/ShellConstraints.hpp"
#include "igaStructure/kinematics/shell/egm/ExtendedElements.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"

#include <memory>
#include <vector>

namespace tokay::structure {

class ExtensionFunctional;

/// Strong supports on trimming curves by the extended gradient method, in closed form.
///
/// A basis that a curve cuts anywhere interpolates nothing there, so a support cannot fix
/// control values; springs and multipliers hold it weakly, with parameters, and functions
/// of which the curve leaves next to nothing spoil the matrix. Here the control values of
/// all functions near the curve (D) are combinations of the others (I) and of the data,
///   u_D = T u_I + d(t),
/// which minimise the functional of EgmOptions. Equilibrium is asked for at I only, where
/// no function is cut: the weak form has no term at the edge, and its matrix does not know
/// where the curve runs.
///
/// A shell that bends takes two conditions at an edge: beside the displacement a support
/// that clamps adds h^2 int_Gamma (slope across it)^2, one that does not h^4 int_Gamma
/// (moment about it / D)^2.
/// Source: the gradient instead of the residual: the extended gradient method, J. Camarotti
class DirichletExtension {
  public:
    /// @param fixed  unknowns that other supports hold, and those without body
    /// @throws InputError as ExtendedElements, or if the functional does not decide u_D
    DirichletExtension(const ShellDescription& description, const ShellPatches& patches,
                       const std::vector<TrimmedSupport>& supports, const std::vector<bool>& fixed);
    ~DirichletExtension();

    /// Unknowns of D, ascending.
    const std::vector<int>& dependents() const { return elements_.dependents(); }
    /// T, with the identity for free unknowns: E of StructuralModel::extension().
    const SparseMatrix& matrix() const { return matrix_; }

    bool isClosed() const { return description_.egm.form == EgmForm::closed; }

    /// True if u_D may differ from T u_I where the curve is at rest.
    bool hasData() const { return hasMotion_ || !loads_.empty() || !isClosed(); }

    /// d(t), 0 for all other unknowns.
    /// @param known  closed form: values of the unknowns that other supports hold, 0 for all
    ///               others; iterated: the last iterate
    Eigen::VectorXd values(double time, const Eigen::VectorXd& known) const;

    /// Points of the supported curves at which their displacement is data.
    const std::vector<TracePoint>& trace() const { return elements_.trace(); }
    /// The part of d that the displacements of these points make: linear in them, as when
    /// they are another structure's.
    /// @param displacements  a column a point [m]
    Eigen::VectorXd ofTrace(const Eigen::Matrix3Xd& displacements) const;

    /// Lets the point's support own the unknowns of D around it that have no owner.
    void own(const TracePoint& point, SupportOwners& owners) const;

  private:
    struct Load {
        int face;
        double massPerArea;
        Eigen::Vector3d position, normal;
    };
    void addTrace(ExtensionFunctional& functional) const;
    void addEdgeCondition(const TracePoint& point, ExtensionFunctional& functional) const;
    void addJumps(ExtensionFunctional& functional) const;
    void addJumpsAlong(int face, int axis, ExtensionFunctional& functional) const;
    void addJump(int face, int axis, const std::array<int, 2>& pair,
                 ExtensionFunctional& functional) const;
    void addResiduals(ExtensionFunctional& functional);
    void addResidual(int face, int element, ExtensionFunctional& functional);
    void factorise(const ExtensionFunctional& functional);
    void findMatrix(const std::vector<bool>& fixed);
    void addCombinations(const std::vector<int>& columns,
                         std::vector<Eigen::Triplet<double>>& entries) const;
    Eigen::VectorXd spread(const Eigen::VectorXd& dependents) const;
    Eigen::VectorXd dataAt(double time) const;
    Eigen::VectorXd loadData(double time) const;
    Eigen::VectorXd motionData(double time) const;
    double gamma(int face) const;
    EgmResidual residual() const;

    const ShellDescription& description_;
    const ShellPatches& patches_;
    ExtendedElements elements_;
    bool hasMotion_;
    std::vector<Load> loads_;                         ///< where the strong form is asked for
    SparseMatrix coupling_, traceData_, loadData_;    ///< rows of dependents
    mutable LatestValue<Eigen::VectorXd> latestData_; ///< the same rows
    std::unique_ptr<LinearSolver> solver_;
    SparseMatrix matrix_;
};

} // namespace tokay::structure
