// SPDX-License-Identifier: GPL-3.0-or-later
// Published shells: value, reference, error, unknowns, seconds of the processor.
#include "common/errors.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <fstream>

namespace {

using namespace tokay;
using namespace tokay::structure;

double secondsSince(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

class Table {
  public:
    explicit Table(const char* file) : file_(file) {
        write("case,value,reference,error_percent,unknowns,processor_seconds,limit_percent,"
              "verdict\n");
    }
    /// @param error  relative to what the limit is relative to
    void add(const std::string& name, double value, double reference, double error, int nUnknowns,
             double seconds, double limit) {
        const bool holds = error <= limit;
        allHold_ = allHold_ && holds;
        write(fmt::format("{},{:.6g},{:.6g},{:.4f},{},{:.2f},{:g},{}\n", name, value, reference,
                          100 * error, nUnknowns, seconds, 100 * limit, holds ? "ok" : "FAILS"));
    }
    bool allHold() const { return allHold_; }

  private:
    void write(const std::string& line) {
        fmt::print("{}", line);
        std::fflush(stdout);
        file_ << line;
    }
    std::ofstream file_;
    bool allHold_ = true;
};

NewtonOptions wholeUpdates() {
    NewtonOptions newton;
    newton.lineSearch = false;
    return newton;
}

/// Load steps to time 1; visit(integrator) after each.
template <class Visit>
void load(Shell& shell, int nSteps, Visit visit) {
    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), wholeUpdates(), 0);
    for (int step = 1; step <= nSteps; ++step) {
        integrator.beginTimeStep(static_cast<double>(step) / nSteps, 1.0 / nSteps);
        integrator.solve();
        integrator.acceptTimeStep();
        visit(integrator.state());
    }
}

void addLinear(const Scene& scene, Table& table) {
    const std::clock_t start = std::clock();
    Shell shell(scene.description);
    double value = 0;
    load(shell, 1,
         [&](const MotionState& state) { value = scene.quantity(shell, state.displacement); });
    table.add(scene.name, value, scene.reference, std::abs(value / scene.reference - 1),
              shell.nUnknowns(), secondsSince(start), scene.limit);
}

// Sze, Liu & Lo 2004, deflection of the tip in steps of 0.05 of the largest load.
void addShear(Table& table) {
    constexpr double deflections[] = {0.663, 1.309, 1.922, 2.493, 3.015, 3.488, 3.912,
                                      4.292, 4.631, 4.933, 5.202, 5.444, 5.660, 5.855,
                                      6.031, 6.190, 6.335, 6.467, 6.588, 6.698};
    const std::clock_t start = std::clock();
    Shell shell(shearedCantilever());
    load(shell, 20, [&](const MotionState& state) {
        const double expected = deflections[std::lround(20 * state.time) - 1];
        const double value = displacementAt(shell, 1, 0.5, state.displacement)[2];
        table.add(fmt::format("cantilever with end shear {:.2f}", state.time), value, expected,
                  std::abs(value / expected - 1), shell.nUnknowns(), secondsSince(start), 5e-3);
    });
}

// Against the exact circle, relative to the length.
void addRollUp(Table& table) {
    const std::clock_t start = std::clock();
    Shell shell(rolledCantilever());
    load(shell, 20, [&](const MotionState& state) {
        const Eigen::Vector3d tip = displacementAt(shell, 1, 0.5, state.displacement);
        const double angle = 2 * M_PI * state.time;
        const double x = 12 * (std::sin(angle) / angle - 1);
        const double z = 12 * (1 - std::cos(angle)) / angle;
        table.add(fmt::format("cantilever rolled up {:.2f}", state.time), tip[0], x,
                  std::hypot(tip[0] - x, tip[2] - z) / 12, shell.nUnknowns(), secondsSince(start),
                  1e-3);
    });
}

// Up to the largest pressure by loading; beyond, the pressure that balances the dilation.
void addBalloon(Table& table) {
    for (const double stretch : {1.01, 1.05, 1.1, 1.2, 1.3}) {
        const std::clock_t start = std::clock();
        Shell shell(
            balloon({[=](const geometry::Point&, double t) { return t * balloonPressure(stretch); },
                     true}));
        double reached = 0;
        load(shell, 5, [&](const MotionState& state) {
            const geometry::KnotVector& u = shell.patches()[0]->surface().u();
            const geometry::KnotVector& v = shell.patches()[0]->surface().v();
            reached = 1 + displacementAt(shell, u.first(), v.first(), state.displacement)[0] / 10;
        });
        table.add(fmt::format("balloon: stretch at the pressure of {:g}", stretch), reached,
                  stretch, std::abs((reached - 1) / (stretch - 1) - 1), shell.nUnknowns(),
                  secondsSince(start), 5e-3);
    }
    const Shell shell(balloon(ScalarField::constant(1)));
    for (const double stretch : {1.4, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0}) {
        const std::clock_t start = std::clock();
        Eigen::VectorXd d(shell.nUnknowns());
        for (int k = 0; k < shell.nodes().count(); ++k) {
            d.segment<3>(3 * k) = (stretch - 1) * shell.nodes().positions.row(k).transpose();
        }
        Eigen::VectorXd unit = Eigen::VectorXd::Zero(d.size());
        shell.addFollowerForce(d, 0, unit);
        const double pressure = shell.internalForce(d).force.dot(d) / unit.dot(d);
        const double expected = balloonPressure(stretch);
        table.add(fmt::format("balloon: pressure at stretch {:g} [Pa]", stretch), pressure,
                  expected, std::abs(pressure / expected - 1), shell.nUnknowns(),
                  secondsSince(start), 5e-3);
    }
}

// Two membranes that do not match, in large strains, by the springs that join them if
// nothing is chosen.
void addBalloonHalves(Table& table) {
    constexpr double stretch = 1.2;
    const std::clock_t start = std::clock();
    Shell shell(balloonHalves(
        {[](const geometry::Point&, double t) { return t * balloonPressure(stretch); }, true}, 6));
    double reached = 0;
    load(shell, 5, [&](const MotionState& state) {
        reached = worstStretchOfJoint(shell, state.displacement, stretch);
    });
    table.add("balloon of two membranes: stretch of the joint", reached, stretch,
              std::abs((reached - 1) / (stretch - 1) - 1), shell.nUnknowns(), secondsSince(start),
              5e-3);
}

} // namespace

int main(int argc, char** argv) {
    try {
        Table table(argv[1]);
        for (const Scene& scene : linearScenes(argc > 2)) {
            addLinear(scene, table);
        }
        addShear(table);
        addRollUp(table);
        addBalloon(table);
        addBalloonHalves(table);
        return table.allHold() ? 0 : 1;
    } catch (const tokay::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
    } catch (const tokay::SolverError& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 1;
}
