// SPDX-License-Identifier: GPL-3.0-or-later
// What a factored tangent that is kept (newton.reuseContraction) saves, and what it
// changes: factorisations, iterations, seconds of the processor and the difference of
// the last displacement, for static and dynamic scenes, and for steps that are solved
// several times as in a coupled run.
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/kinematics/beam/Beam.hpp"
#include "igaStructure/kinematics/plane/PlaneSolid.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "timing.hpp"

#include <fmt/format.h>

#include <fstream>
#include <functional>

namespace {

using namespace tokay;
using namespace tokay::structure;
using Eigen::VectorXd;

/// A body and its time steps.
struct Scene {
    std::string name;
    std::function<std::unique_ptr<StructuralModel>()> make;
    TimeScheme scheme;
    double step;
    int nSteps;
    bool lineSearch;
    int nExchanges; ///< solutions a step, by interface forces that come close to 0
};

std::unique_ptr<StructuralModel> flag(const char* gravity) {
    PlaneMaterial material;
    material.kinematics = Kinematics::planeStrain;
    material.youngsModulus = 1.4e6;
    material.poissonsRatio = 0.4;
    material.density = 1000;
    Loads loads;
    loads.gravities.push_back({{Formula("0", ""), Formula(gravity, "")}});
    return std::make_unique<PlaneSolid>(
        geometry::refine(geometry::rectangle({0.25, 0.19, 0}, 0.35, 0.02), 3, 3, 60, 6), material,
        Strains::nonlinear, std::vector<Support>{{geometry::Edge::left, {true, true}}}, loads);
}

std::unique_ptr<StructuralModel> beam(const char* force) {
    BeamSection section;
    section.thickness = 0.1;
    section.axialStiffness = 1.2e6 * 0.1;
    section.bendingStiffness = 1.2e6 * 1e-3 / 12;
    section.mass = 10;
    BeamLoads loads;
    loads.ends.push_back(
        {BeamEnd::end, std::vector<Formula>{Formula("0", ""), Formula(force, "")}, std::nullopt});
    return std::make_unique<Beam>(
        geometry::refine(geometry::line({0, 0, 0}, {10, 0, 0}), 4, 32), section, Strains::nonlinear,
        std::vector<BeamSupport>{{BeamEnd::start, true, true, true}}, loads);
}

enum Rim { right = 1, left = 3 };

std::unique_ptr<StructuralModel> shell(const std::function<double(double)>& force) {
    const geometry::TrimmedPatch patch(geometry::rectangle({0, 0, 0}, 10, 4), "plate");
    ShellDescription plate{
        geometry::BrepModel({{patch.refined(3, 3, 40, 16)}}), {0.1}, {1.2e6, 0.3, 100}};
    plate.edgeSupports = {{{{0, left}}, {true, true, true}, true}};
    plate.loads.edgeForces = {
        {{0, right},
         {[force](const geometry::Point&, double t) { return Eigen::Vector3d(0, 0, force(t)); },
          true}}};
    return std::make_unique<Shell>(std::move(plate));
}

std::vector<Scene> scenes(bool isQuick) {
    const int n = isQuick ? 1 : 4;
    const TimeScheme dynamic = TimeScheme::generalisedAlpha(0.8);
    const TimeScheme load = TimeScheme::quasiStatic();
    const auto swinging = [] { return flag("-2"); };
    const auto pushed = [] { return shell([](double) { return 0.5; }); };
    return {
        {"solid, dynamic", swinging, dynamic, 0.005, 25 * n, true, 1},
        {"solid, dynamic, 5 exchanges a step", swinging, dynamic, 0.005, 10 * n, true, 5},
        {"solid, 10 load steps", [] { return flag("-2*t"); }, load, 0.1, 10, true, 1},
        {"beam, dynamic", [] { return beam("1"); }, dynamic, 0.1, 50 * n, false, 1},
        {"beam, 20 load steps", [] { return beam("4*t"); }, load, 0.05, 20, false, 1},
        {"shell, dynamic", pushed, dynamic, 0.1, 10 * n, false, 1},
        {"shell, dynamic, 5 exchanges a step", pushed, dynamic, 0.1, 5 * n, false, 5},
        {"shell, 20 load steps", [] { return shell([](double t) { return 4 * t; }); }, load, 0.05,
         20, false, 1},
    };
}

struct Outcome {
    VectorXd displacement;
    int nFactorisations = 0;
    int nIterations = 0;
    double seconds = 0;
};

Outcome run(const Scene& scene, double contraction) {
    const std::unique_ptr<StructuralModel> model = scene.make();
    NewtonOptions newton;
    newton.maxIterations = 100;
    newton.lineSearch = scene.lineSearch;
    newton.reuseContraction = contraction;
    TimeIntegrator integrator(*model, scene.scheme, newton, 0);
    Outcome outcome;
    const VectorXd interfaceForce = VectorXd::Constant(
        model->nUnknowns(), 0.05 * model->externalForce(scene.step).cwiseAbs().maxCoeff());
    outcome.seconds = benchmarks::secondsOf([&] {
                          for (int step = 1; step <= scene.nSteps; ++step) {
                              integrator.beginTimeStep(step * scene.step, scene.step);
                              for (int k = 1; k <= scene.nExchanges; ++k) {
                                  const double share =
                                      k == scene.nExchanges ? 0 : std::pow(-0.2, k - 1);
                                  integrator.solve(share * interfaceForce);
                                  outcome.nIterations += integrator.nIterations();
                              }
                              integrator.acceptTimeStep();
                          }
                      }).processor;
    outcome.displacement = integrator.state().displacement;
    outcome.nFactorisations = integrator.nFactorisations();
    return outcome;
}

} // namespace

int main(int argc, char** argv) {
    std::ofstream file(argv[1]);
    const auto write = [&](const std::string& line) {
        fmt::print("{}", line);
        std::fflush(stdout);
        file << line;
    };
    write("scene,reuse_contraction,factorisations,iterations,processor_s,of_none,difference\n");
    for (const Scene& scene : scenes(argc > 2)) {
        Outcome none;
        for (const double contraction : {0.0, 0.02, 0.05, 0.1, 0.2, 0.5}) {
            const std::string begin = fmt::format("\"{}\",{:g}", scene.name, contraction);
            try {
                const Outcome outcome = run(scene, contraction);
                none = contraction == 0 ? outcome : none;
                write(fmt::format(
                    "{},{},{},{:.3f},{:.2f},{:.1e}\n", begin, outcome.nFactorisations,
                    outcome.nIterations, outcome.seconds, outcome.seconds / none.seconds,
                    (outcome.displacement - none.displacement).norm() / none.displacement.norm()));
            } catch (const SolverError&) {
                write(begin + ",,,,,fails\n");
            }
        }
    }
}
