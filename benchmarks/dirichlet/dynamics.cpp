// SPDX-License-Identifier: GPL-3.0-or-later
#include "dynamics.hpp"

#include "ShellMethod.hpp"
#include "Table.hpp"
#include "igaStructure/timeIntegration/ExplicitIntegrator.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <chrono>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

constexpr int degree = 2, nElements = 16;
constexpr double steepness = 1e4, jumpTime = 0.01, quietUntil = 0.009, endTime = 0.011;
constexpr int nSteps = 2000; // 1e-6 s each, a hundredth of the jump

double factor(double time) {
    return 1 + std::tanh(steepness * (time - jumpTime));
}

// Second derivative of factor().
double factorRate2(double time) {
    const double tanh = std::tanh(steepness * (time - jumpTime));
    return -2 * steepness * steepness * tanh * (1 - tanh * tanh);
}

std::shared_ptr<const VectorField> field(double (*ofTime)(double)) {
    return std::make_shared<VectorField>(VectorField{
        [ofTime](const geometry::Point& x, double time) {
            return Eigen::Vector3d(0, 0, PoissonSquare::solution(x[0], x[1]) * ofTime(time));
        },
        true, true});
}

Shell jumpingMembrane(const ShellMethod& method) {
    ShellDescription membrane = PoissonSquare().membrane(degree, nElements);
    method.choose(membrane);
    membrane.egm.residual = EgmResidual::none; // it has no inertia
    membrane.sliverTreatment = SliverTreatment::scaling;
    for (EdgeSupport& support : membrane.edgeSupports) {
        support.motion = field(factor);
    }
    membrane.loads.tractions[0].traction =
        *field([](double time) { return factorRate2(time) + 2 * M_PI * M_PI * factor(time); });
    return Shell(std::move(membrane));
}

/// What an integration gave.
struct Jump {
    double within, behind; ///< relative errors in L2, half way and at the end
    double nSolutions;     ///< per time step
    double seconds;
};

// Calls advance(time, deltaT), which gives displacement and number of solutions.
template <class Advance>
Jump integrated(const Shell& shell, Advance advance) {
    const auto start = std::chrono::steady_clock::now();
    const double size = poissonError(shell, VectorXd::Zero(shell.nUnknowns())).value;
    const auto error = [&](const VectorXd& displacement, double time) {
        return poissonError(shell, displacement / factor(time)).value / size;
    };
    const double deltaT = (endTime - quietUntil) / nSteps;
    Jump jump{0, 0, 0, 0};
    advance(quietUntil, quietUntil);
    for (int step = 1; step <= nSteps; ++step) {
        const double time = quietUntil + step * deltaT;
        const auto [displacement, nSolutions] = advance(time, deltaT);
        jump.nSolutions += static_cast<double>(nSolutions) / nSteps;
        if (2 * step == nSteps) {
            jump.within = error(displacement, time);
        } else if (step == nSteps) {
            jump.behind = error(displacement, time);
        }
    }
    jump.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return jump;
}

Jump implicit(Shell& shell) {
    TimeIntegrator integrator(shell, TimeScheme::newmark(0.25, 0.5), {}, 0);
    return integrated(shell, [&](double time, double deltaT) {
        integrator.beginTimeStep(time, deltaT);
        integrator.solve();
        const std::size_t nSolutions = integrator.residuals().size();
        integrator.acceptTimeStep();
        return std::pair<VectorXd, std::size_t>(integrator.state().displacement, nSolutions);
    });
}

Jump explicitly(Shell& shell) {
    ExplicitIntegrator integrator(shell, 0);
    return integrated(shell, [&](double time, double deltaT) {
        const auto nParts = static_cast<std::size_t>(integrator.advance(time, deltaT).nIterations);
        return std::pair<VectorXd, std::size_t>(integrator.state().displacement, nParts);
    });
}

} // namespace

void writeDynamics(const std::string& file) {
    Table table(file, "scheme,method,errorWithin,errorBehind,solutionsPerStep,seconds");
    for (const bool isExplicit : {false, true}) {
        for (const ShellMethod& method : shellMethods()) {
            const bool isTwin = method.name() == "egm whole" || method.name() == "egm physical";
            if (isTwin || (isExplicit && method.name() == "egm iterated")) {
                continue;
            }
            const std::string start =
                fmt::format("{},{},", isExplicit ? "explicit" : "newmark", method.name());
            table.addRow(start, [&] {
                Shell shell = jumpingMembrane(method);
                const Jump jump = isExplicit ? explicitly(shell) : implicit(shell);
                return fmt::format("{:.3e},{:.3e},{:.2f},{:.1f}", jump.within, jump.behind,
                                   jump.nSolutions, jump.seconds);
            });
        }
    }
}

} // namespace tokay::structure
