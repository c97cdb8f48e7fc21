// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShellMethod.hpp"

#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <Eigen/Eigenvalues>

#include <chrono>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

EgmOptions egmOptions(EgmResidual residual) {
    EgmOptions options;
    options.residual = residual;
    return options;
}

double stableStepOf(ShellDescription membrane) {
    membrane.sliverTreatment = SliverTreatment::scaling;
    Shell shell(std::move(membrane));
    return ExplicitIntegrator(shell, 0).stableStep(VectorXd::Zero(shell.nUnknowns()));
}

} // namespace

ShellMethod publishedMethod(double tolerance) {
    EgmOptions options;
    options.form = EgmForm::iterated;
    options.continuation = EgmContinuation::gradient;
    options.tolerance = tolerance;
    options.maxIterations = 1000;
    return {"egm iterated", EdgeMethod::egm, options};
}

const std::vector<ShellMethod>& shellMethods() {
    static const std::vector<ShellMethod> methods = {
        {"egm whole", EdgeMethod::egm, egmOptions(EgmResidual::whole)},
        {"egm physical", EdgeMethod::egm, egmOptions(EgmResidual::physical)},
        {"egm none", EdgeMethod::egm, egmOptions(EgmResidual::none)},
        publishedMethod(1e-6),
        {"nitsche", EdgeMethod::nitsche},
        {"lagrange", EdgeMethod::lagrange},
        {"penalty", EdgeMethod::penalty}};
    return methods;
}

void ShellMethod::choose(ShellDescription& shell) const {
    shell.edgeMethod = method_;
    shell.egm = egm_;
}

PoissonResult ShellMethod::solve(const PoissonSquare& square, int degree, int n) const {
    const auto start = std::chrono::steady_clock::now();
    ShellDescription membrane = square.membrane(degree, n);
    choose(membrane);
    const auto motion = std::make_shared<VectorField>(
        VectorField{[](const geometry::Point& x, double) {
                        return Eigen::Vector3d(0, 0, PoissonSquare::solution(x[0], x[1]));
                    },
                    false, true});
    for (EdgeSupport& support : membrane.edgeSupports) {
        support.motion = motion;
    }
    Shell shell(std::move(membrane));
    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), {}, 0);
    integrator.beginTimeStep(1, 1);
    const VectorXd solution = integrator.solve();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return {poissonError(shell, solution), static_cast<int>(integrator.residuals().size()),
            seconds.count()};
}

MatrixXd ShellMethod::matrix(const PoissonSquare& square, int degree, int n) const {
    ShellDescription membrane = square.membrane(degree, n);
    choose(membrane);
    const Shell shell(std::move(membrane));
    std::vector<int> free;
    for (int k = 2; k < shell.nUnknowns(); k += 3) {
        if (!shell.fixed()[k]) {
            free.push_back(k);
        }
    }
    SparseMatrix all = stiffnessAtRest(shell);
    if (shell.extension()) {
        all = SparseMatrix(all * *shell.extension());
    }
    return MatrixXd(all)(free, free);
}

double ShellMethod::stableStep(const PoissonSquare& square, int degree, int n) const {
    ShellDescription membrane = square.membrane(degree, n);
    choose(membrane);
    membrane.egm.residual = EgmResidual::none; // it has no inertia
    membrane.egm.form = EgmForm::closed;
    return stableStepOf(std::move(membrane));
}

double stableStepOfWhole(int degree, int n) {
    ShellDescription membrane = PoissonSquare().membrane(degree, n);
    membrane.model =
        geometry::BrepModel({{geometry::TrimmedPatch(geometry::rectangle({0, 0, 0}, 1, 1))
                                  .refined(degree, degree, n, n)}});
    membrane.edgeSupports.resize(4);
    return stableStepOf(std::move(membrane));
}

double conditionOf(const MatrixXd& matrix) {
    constexpr double rounding = 1e-12;
    const auto valuesOf = [](const MatrixXd& symmetric) -> VectorXd {
        return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .cwiseAbs();
    };
    if ((matrix - matrix.transpose()).norm() < rounding * matrix.norm()) {
        const VectorXd values = valuesOf(matrix);
        return values.maxCoeff() / values.minCoeff();
    }
    const VectorXd squares = valuesOf(matrix.transpose() * matrix);
    return std::sqrt(squares.maxCoeff() / squares.minCoeff());
}

} // namespace tokay::structure
