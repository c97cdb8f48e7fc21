// SPDX-License-Identifier: GPL-3.0-or-later
// Supports on a trimming curve: the extended gradient method and its rivals on Poisson's
// problem, by element size and by the position of the cut, and on a clamped disc.
#include "Table.hpp"
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "poissonSquare.hpp"
#include "trimmedDisc.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Method {
    std::string name;
    EdgeMethod method;
    EgmForm form = EgmForm::closed;
    EgmContinuation continuation = EgmContinuation::jumps;
    EgmResidual residual = EgmResidual::none;

    void set(ShellDescription& shell) const {
        shell.edgeMethod = method;
        shell.egm.form = form;
        shell.egm.continuation = continuation;
        shell.egm.residual = residual;
        shell.egm.maxIterations = 1000;
    }
};

const std::vector<Method> all = {
    {"egm whole", EdgeMethod::egm, EgmForm::closed, EgmContinuation::jumps, EgmResidual::whole},
    {"egm physical", EdgeMethod::egm, EgmForm::closed, EgmContinuation::jumps,
     EgmResidual::physical},
    {"egm none", EdgeMethod::egm},
    {"egm iterated", EdgeMethod::egm, EgmForm::iterated, EgmContinuation::gradient},
    {"nitsche", EdgeMethod::nitsche},
    {"lagrange", EdgeMethod::lagrange},
    {"penalty", EdgeMethod::penalty}};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Condition number of the matrix that is solved, of deflections only.
double condition(const Shell& shell) {
    std::vector<int> free;
    for (int k = 2; k < shell.nUnknowns(); k += 3) {
        if (!shell.fixed()[k]) {
            free.push_back(k);
        }
    }
    SparseMatrix matrix = stiffnessAtRest(shell);
    if (shell.extension()) {
        matrix = SparseMatrix(matrix * *shell.extension());
    }
    const MatrixXd own = MatrixXd(matrix)(free, free);
    const VectorXd squares =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(own.transpose() * own, Eigen::EigenvaluesOnly)
            .eigenvalues();
    return std::sqrt(squares[squares.size() - 1] / squares[0]);
}

struct Result {
    PoissonError error;
    int nSolutions;
    double seconds;
};

// Weak methods know only edges at rest here: they solve the problem that is zero there.
Result solved(const PoissonSquare& square, const Method& method, int degree, int n) {
    const auto start = std::chrono::steady_clock::now();
    ShellDescription membrane = square.membrane(degree, n);
    method.set(membrane);
    Shell shell(std::move(membrane));
    PoissonSolution solution;
    if (method.method == EdgeMethod::egm) {
        solution = solvePoisson(square, shell);
    } else {
        TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), {}, 0);
        integrator.beginTimeStep(1, 1);
        solution = {integrator.solve(), 1};
    }
    const double seconds = secondsSince(start);
    return {poissonError(square, shell, solution.values), solution.nSolutions, seconds};
}

void writeOrders(const std::string& file, const std::vector<int>& meshes) {
    Table table(file, "problem,method,degree,elements,L2Error,H1Error,solutions,seconds");
    for (const bool isZeroOnBoundary : {false, true}) {
        PoissonSquare square;
        square.isZeroOnBoundary = isZeroOnBoundary;
        for (const Method& method : all) {
            if (!isZeroOnBoundary && method.method != EdgeMethod::egm) {
                continue;
            }
            for (int degree = 1; degree <= 4; ++degree) {
                if (method.form == EgmForm::iterated && degree > 2) {
                    continue; // published for degrees 1 and 2
                }
                for (const int n : meshes) {
                    table.addRow(fmt::format("{},{},{},{},", isZeroOnBoundary ? "zero" : "wave",
                                             method.name, degree, n),
                                 [&] {
                                     const Result result = solved(square, method, degree, n);
                                     return fmt::format("{:.3e},{:.3e},{},{:.2f}",
                                                        result.error.value, result.error.gradient,
                                                        result.nSolutions, result.seconds);
                                 });
                }
            }
        }
    }
}

// The disc's left end lies a part of an element beyond a knot line.
void writeCuts(const std::string& file) {
    constexpr int n = 16;
    Table table(file, "method,degree,cut,L2Error,condition,explicitStepOverFull");
    std::vector<Method> methods = all;
    for (const Method& method : methods) {
        for (const int degree : {1, 2, 3}) {
            if (method.form == EgmForm::iterated && degree > 2) {
                continue;
            }
            std::optional<double> whole; // step with the cut at a knot line
            for (const double cut : {1.0, 0.5, 0.1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
                PoissonSquare square;
                square.isZeroOnBoundary = true;
                square.centre[0] = square.radius + (4 + cut) / n;
                table.addRow(fmt::format("{},{},{:g},", method.name, degree, cut), [&] {
                    const Result result = solved(square, method, degree, n);
                    ShellDescription membrane = square.membrane(degree, n);
                    method.set(membrane);
                    const double number = condition(Shell(membrane));
                    membrane.egm.residual = EgmResidual::none; // it has no inertia
                    membrane.egm.form = EgmForm::closed;
                    membrane.sliverTreatment = SliverTreatment::scaling;
                    Shell shell(membrane);
                    const double step =
                        ExplicitIntegrator(shell, 0).stableStep(VectorXd::Zero(shell.nUnknowns()));
                    whole = whole.value_or(step);
                    return fmt::format("{:.3e},{:.3e},{:.3e}", result.error.value, number,
                                       step / *whole);
                });
            }
        }
    }
}

void writeDisc(const std::string& file, const std::vector<int>& meshes) {
    Table table(file, "method,degree,elements,deflectionError,displacementError,seconds");
    for (const Method& method : {all[0], all[2], all[4], all[5]}) {
        for (const int degree : {3, 4}) {
            for (const int n : meshes) {
                table.addRow(fmt::format("{},{},{},", method.name, degree, n), [&] {
                    const auto start = std::chrono::steady_clock::now();
                    ShellDescription disc = discShell({}, degree, n, 1);
                    method.set(disc);
                    Shell shell(std::move(disc));
                    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), {}, 0);
                    integrator.beginTimeStep(1, 1);
                    const DiscError error = discError(shell, integrator.solve());
                    return fmt::format("{:.3e},{:.3e},{:.2f}", error.deflection, error.displacement,
                                       secondsSince(start));
                });
            }
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print("usage: dirichlet FOLDER [quick]\n");
        return 2;
    }
    const std::string folder = argv[1];
    const bool isQuick = argc > 2;
    writeOrders(folder + "/orders.csv",
                isQuick ? std::vector<int>{15, 30} : std::vector<int>{15, 30, 60});
    writeCuts(folder + "/cuts.csv");
    writeDisc(folder + "/disc.csv", isQuick ? std::vector<int>{16} : std::vector<int>{16, 24, 36});
    return 0;
}
