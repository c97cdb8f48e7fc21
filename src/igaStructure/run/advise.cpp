// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/advise.hpp"

#include "common/errors.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::VectorXd;

namespace {

// Below this many steps a period the trapezoidal rule's period is wrong by
// more than 1 %: (2 pi / n)^2 / 12.
constexpr double fewSteps = 18;
// Linear kinematics stretch a turning body by half the square of the angle.
constexpr double largeDisplacement = 0.05;
// In thicknesses. A plate whose edges cannot move in its plane is stiffer than
// linear strains say by the order of the square.
constexpr double largeDeflection = 0.5;

// The lowest modes: three of them, fewer if the structure has fewer.
NaturalModes lowestModes(const StructuralModel& model) {
    const std::vector<bool>& fixed = model.fixed();
    const auto nFree = std::count(fixed.begin(), fixed.end(), false);
    if (nFree == 0) {
        return {};
    }
    if (nFree > 1) { // an iteration finds fewer modes than unknowns
        const auto count = static_cast<int>(std::min<std::ptrdiff_t>(3, nFree - 1));
        return naturalModes(model, count);
    }
    const auto k = std::find(fixed.begin(), fixed.end(), false) - fixed.begin();
    const double square = stiffnessAtRest(model).coeff(k, k) / model.massMatrix().coeff(k, k);
    return {VectorXd::Constant(1, std::sqrt(std::max(0.0, square))),
            VectorXd::Unit(model.nUnknowns(), k)};
}

// The model's own loads on the body as it is at rest.
VectorXd loadsAtRest(StructuralModel& model, double time) {
    VectorXd force = model.externalForce(time);
    model.addFollowerForce(VectorXd::Zero(model.nUnknowns()), time, force);
    return force;
}

// How many times stiffer than at rest the structure is against its slowest motion when
// this has moved it by a distance, without its own loads.
double stiffening(StructuralModel& model, const VectorXd& shape, double distance) {
    const VectorXd linear = distance / shape.lpNorm<Eigen::Infinity>() * shape;
    constexpr double time = 1;
    TimeIntegrator integrator(model, TimeScheme::quasiStatic(), NewtonOptions(), time);
    const VectorXd force = stiffnessAtRest(model) * linear - loadsAtRest(model, time);
    integrator.beginTimeStep(time, time);
    return linear.norm() / integrator.solve(force).norm();
}

// Stiffness and natural periods are those of small motions about the unloaded state. A thin
// body whose edges cannot approach each other is stretched as it bends, and soon has others.
struct Stiffening {
    double factor = 1; ///< at a distance of the thickness
    bool isMuch() const { return factor > 1.2; }
};

Stiffening findStiffening(Body& body, const NaturalModes& modes) {
    if (body.model().isLinear() || modes.shapes.cols() == 0) {
        return {};
    }
    try {
        return {stiffening(body.model(), modes.shapes.col(0), body.thickness())};
    } catch (const SolverError&) {
        return {}; // so soft that it goes far beyond its thickness
    }
}

std::string describe(const Stiffening& stiffening, const Body& body) {
    return fmt::format("; that is the unloaded structure, which is stretched as it bends: moved by "
                       "its thickness of {:g} m it is {:.2g} times as stiff against its slowest "
                       "motion, farther out by the square of the distance: its periods there are "
                       "shorter, and steps must be chosen by them\n",
                       body.thickness(), stiffening.factor);
}

template <class Function>
std::string listOf(const VectorXd& values, Function number) {
    std::vector<std::string> words;
    for (const double value : values) {
        words.push_back(number(value));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string adviseStep(const Case& structureCase, const Body& body, const VectorXd& frequencies,
                       const Stiffening& stiffening) {
    if (frequencies.size() == 0 || !(frequencies[0] > 0)) {
        return "";
    }
    const VectorXd periods = 2 * M_PI * frequencies.cwiseInverse();
    std::string text =
        fmt::format("advice: the lowest natural periods are {}",
                    listOf(periods, [](double T) { return fmt::format("{:.4g} s", T); }));
    if (stiffening.isMuch()) {
        return text + describe(stiffening, body);
    }
    const TimeScheme* scheme = structureCase.implicitScheme();
    if (!structureCase.timeSteps || !scheme || !scheme->dynamic) {
        return text + fmt::format("; a dynamic run resolves them with steps below {}\n",
                                  listOf(periods / fewSteps,
                                         [](double dt) { return fmt::format("{:.2g} s", dt); }));
    }
    const VectorXd steps = periods / structureCase.timeSteps->step;
    const auto longer = [](double n) {
        const double percent = 100 * std::pow(2 * M_PI / n, 2) / 12;
        return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
    };
    text += fmt::format(": {} time steps; the trapezoidal rule makes them longer by {}",
                        listOf(steps, [](double n) { return fmt::format("{:.3g}", n); }),
                        listOf(steps, longer));
    if (steps[0] < fewSteps) {
        text += "; the step is too large even for the first";
    } else if (const double last = periods[periods.size() - 1] / fewSteps;
               last < structureCase.timeSteps->step) {
        text += fmt::format("; steps below {:.2g} s resolve all of them", last);
    }
    return text + "\n";
}

// Displacement under the loads at the end of the run, by one linear solution.
double staticEstimate(const Case& structureCase, StructuralModel& model) {
    const double time = structureCase.timeSteps ? structureCase.timeSteps->end : 1;
    const SparseMatrix stiffness = stiffnessAtRest(model);
    const auto solver =
        makeLinearSolver(stiffness, model.fixed(), MatrixKind::general, model.extension());
    solver->factorise(stiffness);
    const VectorXd start = asSupported(model, VectorXd::Zero(model.nUnknowns()), time);
    VectorXd internal = stiffness * start;
    model.supportShift(time).addTo(internal);
    const VectorXd rest = solver->solve(loadsAtRest(model, time) - internal);
    return (start + rest).lpNorm<Eigen::Infinity>();
}

std::string adviseStrains(const Case& structureCase, Body& body, const Stiffening& stiffening) {
    const StructuralModel& model = body.model();
    const double displacement = staticEstimate(structureCase, body.model());
    if (displacement == 0) {
        return "";
    }
    const double share = displacement / model.size();
    const double deflection = displacement / body.thickness();
    std::string text = fmt::format("advice: a first static estimate (linear, loads at the end) "
                                   "moves the structure by {:.3g} m, {:.2g} % of its size and "
                                   "{:.2g} times its thickness",
                                   displacement, 100 * share, deflection);
    if (model.isLinear() && share > largeDisplacement) {
        text += "; strains should be nonlinear";
    } else if (model.isLinear() && deflection > largeDeflection) {
        text += "; strains should be nonlinear if ends or edges are held along the body, which "
                "then stretches as it bends";
    }
    if (stiffening.isMuch() && deflection > largeDeflection) {
        text += "; it moves less than that, for it is stretched as it bends";
    }
    if (!model.isLinear() && share < 0.01 * largeDisplacement &&
        deflection < 0.1 * largeDeflection) {
        text += "; linear strains would do";
    }
    return text + "\n";
}

// What a structure's mass and stiffness make of a fluid's added mass.
std::string adviseCoupling(const Case& structureCase, const Body& body, const VectorXd& frequencies,
                           const Stiffening& stiffening) {
    if (!structureCase.coupling) {
        return "";
    }
    const double mass = body.massPerWetArea();
    const bool isStiff = frequencies.size() > 0 && frequencies[0] > 0;
    const double stiffness = isStiff ? mass * frequencies[0] * frequencies[0] : 0;
    // A half wave of the structure's size moves, on each side, the fluid in a layer
    // of size / pi.
    const double layers = 2 * body.model().size() / M_PI;
    std::string text = fmt::format("advice: the structure has {:.4g} kg on a square metre of "
                                   "interface",
                                   mass);
    if (isStiff) {
        text += fmt::format(", and {}in its slowest motion a stiffness of {:.4g} Pa/m",
                            stiffening.isMuch() ? "at rest " : "", stiffness);
    }
    if (!structureCase.isDynamic()) {
        // A force proportional to the acceleration, as differences of displacements see it.
        constexpr double water = 1000;
        return !isStiff ? ""
                        : text + fmt::format("; without its mass, water (1000 kg/m^3) on both "
                                             "sides resists as much in time steps of {:.2g} s, on "
                                             "one side of {:.2g} s: explicit coupling needs much "
                                             "larger ones\n",
                                             std::sqrt(layers * water / stiffness),
                                             std::sqrt(0.5 * layers * water / stiffness));
    }
    double resistance = mass;
    const TimeScheme* scheme = structureCase.implicitScheme();
    if (isStiff && structureCase.timeSteps && scheme) {
        const double step = structureCase.timeSteps->step;
        const double ofStiffness = scheme->beta * step * step * stiffness;
        resistance += ofStiffness;
        text += fmt::format(", which in a time step of {:g} s resists as {:.2g} kg/m^2 do", step,
                            ofStiffness);
    }
    return text + fmt::format("; a fluid of {:.3g} kg/m^3 on both sides, or of {:.3g} kg/m^3 on "
                              "one, adds as much to its slowest motion: explicit coupling needs a "
                              "fluid much lighter than that\n",
                              resistance / layers, 2 * resistance / layers);
}

} // namespace

std::string advise(const Case& structureCase, Body& body) {
    std::string text;
    for (const std::string& line : body.advice()) {
        text += "advice: " + line + "\n";
    }
    NaturalModes modes;
    Stiffening stiffening;
    if (body.model().freeRigidMotions().empty()) {
        try {
            modes = lowestModes(body.model());
            stiffening = findStiffening(body, modes);
            text += adviseStrains(structureCase, body, stiffening);
            text += adviseStep(structureCase, body, modes.angularFrequencies, stiffening);
        } catch (const SolverError& error) {
            text += fmt::format("advice: no estimate of stiffness: {}\n", error.what());
        }
    }
    return text + adviseCoupling(structureCase, body, modes.angularFrequencies, stiffening);
}

} // namespace tokay::structure
