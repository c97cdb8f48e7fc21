// SPDX-License-Identifier: GPL-3.0-or-later
// A cantilevered plate whose free edge leaves but a fraction of the last elements, with
// slivers left alone or tied to whole elements: condition of its stiffness, as it is and
// scaled by the diagonal, and the deflection of the edge against that of whole elements.
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <functional>

namespace {

using namespace tokay;
using namespace tokay::structure;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum Rim { bottom = 0, right = 1, top = 2, left = 3 };

/// Unit square; eight whole elements along it and the fraction of a ninth.
struct Plate {
    ShellDescription description;
    double end; ///< parameter of the free edge
};

Plate plate(int degree, double fraction, SliverTreatment treatment) {
    const double end = (8 + fraction) / 10;
    const geometry::TrimmedPatch patch(geometry::rectangle({0, 0, 0}, 1 / end, 1),
                                       {geometry::TrimmingLoop::around({{0, 0}, {end, 1}})},
                                       "plate");
    ShellDescription description{
        geometry::BrepModel({{patch.refined(degree, degree, 10, 2)}}), {0.01}, {1e6, 0.3, 1}};
    description.strains = Strains::linear;
    description.sliverTreatment = treatment;
    description.edgeSupports = {{{{0, left}}, {true, true, true}, true}};
    description.loads.edgeForces = {{{0, right}, VectorField::constant({0, 0, -1e-6})}};
    return {std::move(description), end};
}

MatrixXd freeStiffness(const Shell& shell) {
    SparseMatrix tangent;
    shell.internalForce(VectorXd::Zero(shell.nUnknowns()), tangent);
    std::vector<int> unknowns;
    for (int k = 0; k < shell.nUnknowns(); ++k) {
        if (!shell.fixed()[k]) {
            unknowns.push_back(k);
        }
    }
    return MatrixXd(tangent)(unknowns, unknowns);
}

double condition(const MatrixXd& matrix) {
    const VectorXd values =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
    return values.maxCoeff() / std::abs(values.minCoeff());
}

double deflection(Shell& shell, double end) {
    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), NewtonOptions{}, 0);
    integrator.beginTimeStep(1, 1);
    return shell.stateAt(0, end, 0.5, integrator.solve()).displacement[2];
}

using Write = std::function<void(const std::string&)>;

void addRows(int degree, SliverTreatment treatment, const Write& write) {
    const char* name = treatment == SliverTreatment::extension ? "extension" : "scaling";
    double whole = 0;
    for (int exponent = 0; exponent <= 12; exponent += 2) {
        Plate at = plate(degree, std::pow(10.0, -exponent), treatment);
        Shell shell(std::move(at.description));
        const MatrixXd K = freeStiffness(shell);
        const VectorXd scale = K.diagonal().cwiseSqrt().cwiseInverse();
        const double end = deflection(shell, at.end);
        whole = exponent == 0 ? end : whole;
        write(fmt::format("{},{},1e-{},{:.2e},{:.2e},{:.8f}\n", name, degree, exponent,
                          condition(K), condition(scale.asDiagonal() * K * scale.asDiagonal()),
                          end / whole));
    }
}

} // namespace

int main(int, char** argv) {
    std::ofstream file(argv[1]);
    const Write write = [&](const std::string& line) {
        fmt::print("{}", line);
        file << line;
    };
    write("treatment,degree,fraction,condition,condition_scaled,deflection_over_whole\n");
    for (const SliverTreatment treatment : {SliverTreatment::scaling, SliverTreatment::extension}) {
        for (const int degree : {2, 3, 4}) {
            addRows(degree, treatment, write);
        }
    }
}
