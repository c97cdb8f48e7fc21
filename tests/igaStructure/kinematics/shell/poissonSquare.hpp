// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"

#include <Eigen/LU>

#include <cmath>

namespace tokay::structure {

/// Poisson's problem with a known solution on the unit square without a disc:
/// -(w,xx + w,yy) = f, w given on all of the boundary. It is the deflection of a membrane with
/// linear strains whose prestress times thickness is 1.
struct PoissonSquare {
    double radius = 0.25;
    Eigen::Vector2d centre = {0.5, 0.5};

    /// w = sin(pi x) cos(pi y)
    static double solution(double x, double y) { return std::sin(M_PI * x) * std::cos(M_PI * y); }
    static Eigen::Vector2d gradient(double x, double y) {
        return M_PI * Eigen::Vector2d(std::cos(M_PI * x) * std::cos(M_PI * y),
                                      -std::sin(M_PI * x) * std::sin(M_PI * y));
    }
    static double load(double x, double y) { return 2 * M_PI * M_PI * solution(x, y); }

    geometry::TrimmedPatch patch(int degree, int n) const {
        const geometry::NurbsCurve circle =
            geometry::reversed(geometry::arc({centre[0], centre[1], 0}, radius, 0, 2 * M_PI));
        return geometry::TrimmedPatch(
                   geometry::rectangle({0, 0, 0}, 1, 1),
                   {geometry::TrimmingLoop(
                        geometry::LoopKind::outer,
                        geometry::TrimmedPatch(geometry::rectangle({0, 0, 0}, 1, 1))
                            .loops()[0]
                            .curves()),
                    geometry::TrimmingLoop(geometry::LoopKind::inner, {circle})},
                   "square")
            .refined(degree, degree, n, n);
    }

    /// Held on all edges; curves 0 to 3 are the square's, 4 the disc's.
    ShellDescription membrane(int degree, int n) const {
        ShellDescription membrane{geometry::BrepModel({{patch(degree, n)}}), {1}, {1, 0, 1}};
        membrane.bending = false;
        membrane.strains = Strains::linear;
        membrane.prestress = {1, 1, 0};
        membrane.edgeMethod = EdgeMethod::egm;
        for (int curve = 0; curve < 5; ++curve) {
            membrane.edgeSupports.push_back({{{0, curve}}, {true, true, true}});
        }
        membrane.loads.tractions = {{0,
                                     {[](const geometry::Point& x, double) -> Eigen::Vector3d {
                                          return {0, 0, load(x[0], x[1])};
                                      },
                                      false}}};
        return membrane;
    }
};

/// Control values of the functions that are not zero on the square's edges, which interpolate
/// the solution at Greville points.
/// @param knots  along both edges
/// @return       a row a function along x, a column a function along y
inline Eigen::MatrixXd rimValues(const geometry::KnotVector& knots) {
    const std::vector<double> at = knots.grevilleAbscissae();
    const auto n = static_cast<Eigen::Index>(at.size());
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd values(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const int span = knots.findSpan(at[k]);
        basis.row(k).segment(span - knots.degree(), knots.degree() + 1) =
            knots.basisDerivatives(span, at[k], 0);
        for (Eigen::Index l = 0; l < n; ++l) {
            values(k, l) = PoissonSquare::solution(at[k], at[l]);
        }
    }
    const Eigen::MatrixXd inverse = basis.inverse();
    Eigen::MatrixXd control = inverse * values * inverse.transpose();
    control.block(1, 1, n - 2, n - 2).setZero();
    return control;
}

/// Control values of the discrete solution, and what they took.
struct PoissonSolution {
    Eigen::VectorXd values;
    int nSolutions;
};

/// @param shell  PoissonSquare::membrane(), its supports by EdgeMethod::egm
inline PoissonSolution solvePoisson(Shell& shell) {
    const DirichletExtension& extension = *shell.dirichletExtension();
    Eigen::VectorXd rim = Eigen::VectorXd::Zero(shell.nUnknowns());
    rim(Eigen::seqN(2, shell.nodes().count(), 3)) =
        rimValues(shell.patches()[0]->surface().u()).reshaped();
    Eigen::Matrix3Xd onCurve =
        Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(extension.trace().size()));
    for (std::size_t k = 0; k < extension.trace().size(); ++k) {
        const Eigen::Vector3d& x = extension.trace()[k].on.side.position;
        onCurve(2, static_cast<Eigen::Index>(k)) = PoissonSquare::solution(x[0], x[1]);
    }
    const SparseMatrix stiffness = stiffnessAtRest(shell);
    const auto solver =
        makeLinearSolver(stiffness, shell.fixed(), MatrixKind::positiveDefinite, shell.extension());
    solver->factorise(stiffness);
    const Eigen::VectorXd load = shell.externalForce(0);
    const EgmOptions& options = shell.description().egm;
    PoissonSolution solution{rim, 0};
    double change = 1;
    while (change > options.tolerance && solution.nSolutions < options.maxIterations) {
        const Eigen::VectorXd known =
            rim + extension.values(0, solution.values) + extension.ofTrace(onCurve);
        const Eigen::VectorXd next = known + solver->solve(load - stiffness * known);
        change =
            extension.isClosed() ? 0 : (next - solution.values).norm() / solution.values.norm();
        solution = {next, solution.nSolutions + 1};
    }
    return solution;
}

/// Errors of the deflection in L2 and of its gradient.
struct PoissonError {
    double value, gradient;
};

inline PoissonError poissonError(const Shell& shell, const Eigen::VectorXd& d) {
    Eigen::Array2d squares = Eigen::Array2d::Zero();
    ShellElement element;
    ShellElement::Coefficients local;
    const ShellPatch& patch = *shell.patches()[0];
    for (int number = 0; number < patch.patch().nElements(); ++number) {
        element.moveTo(patch, number % patch.u().nSpans(), number / patch.u().nSpans());
        element.gather(d, local);
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            const Eigen::Vector3d x = element.position();
            const Eigen::Vector2d slope =
                element.functions().derivatives(local).topLeftCorner<3, 2>().row(2).transpose();
            const double w = element.functions().value(local)[2];
            squares += element.area() *
                       Eigen::Array2d(std::pow(w - PoissonSquare::solution(x[0], x[1]), 2),
                                      (slope - PoissonSquare::gradient(x[0], x[1])).squaredNorm());
        }
    }
    return {std::sqrt(squares[0]), std::sqrt(squares[1])};
}

} // namespace tokay::structure
