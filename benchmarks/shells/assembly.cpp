// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds of a shell's tangent per Gauss point, by degree, strains and threads, beside
// the rate of a dense product; on the wall, and of the processors, which others
// that use them disturb less. The limit is for one thread.
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"
#include "timing.hpp"

#include <fmt/format.h>

#include <fstream>

namespace {

using namespace tokay;
using namespace tokay::structure;
using benchmarks::bestSeconds;
using benchmarks::Seconds;

Shell cylinder(int degree, int nElements, Strains strains) {
    const geometry::TrimmedPatch patch(geometry::cylinderPatch({0, 0, 0}, 25, 50, 0.8, 2.2));
    ShellDescription description{
        geometry::BrepModel({{patch.refined(degree, degree, nElements, nElements)}}),
        {0.25},
        {4e8, 0.3, 1}};
    description.strains = strains;
    return Shell(std::move(description));
}

} // namespace

int main(int argc, char** argv) {
    std::ofstream file(argv[1]);
    const auto write = [&](const std::string& line) {
        fmt::print("{}", line);
        file << line;
    };
    write("strains,degree,threads,gauss_points,tangent_us_per_point,tangent_processor_us,"
          "force_processor_us,"
          "product_GFlops,share_of_rate_percent,limit_us,verdict\n");
    const bool isQuick = argc > 2;
    const double rate = benchmarks::productRate();
    bool allHold = true;
    for (const Strains strains : {Strains::linear, Strains::nonlinear}) {
        for (const int degree : {2, 3, 4}) {
            const int n = (isQuick ? 96 : 192) / degree;
            Shell shell = cylinder(degree, n, strains);
            const Eigen::VectorXd d = 1e-3 * Eigen::VectorXd::Random(shell.nUnknowns());
            const double nPoints = static_cast<double>(n) * n * (degree + 1) * (degree + 1);
            for (int threads = 1; threads <= availableThreads(); ++threads) {
                shell.setThreads(threads);
                SparseMatrix tangent;
                const Seconds withTangent =
                    bestSeconds(6, [&] { shell.internalForce(d, tangent); });
                const Seconds alone = bestSeconds(3, [&] { shell.internalForce(d); });
                // Products of 5 rows a point, six of the nine blocks of components.
                const int nFunctions = (degree + 1) * (degree + 1);
                const double operations = 2.0 * 6 * 5 * nFunctions * nFunctions * nPoints;
                const double limit = degree == 2 ? 2.5 : degree == 3 ? 5 : 10;
                const double microseconds = 1e6 * withTangent.processor / nPoints;
                const bool holds = threads > 1 || microseconds <= limit;
                allHold = allHold && holds;
                write(fmt::format("{},{},{},{:.0f},{:.3f},{:.3f},{:.3f},{:.1f},{:.1f},{:g},{}\n",
                                  strains == Strains::linear ? "linear" : "nonlinear", degree,
                                  threads, nPoints, 1e6 * withTangent.wall / nPoints, microseconds,
                                  1e6 * alone.processor / nPoints, rate,
                                  100 * operations / withTangent.processor * 1e-9 / rate, limit,
                                  holds ? "ok" : "FAILS"));
            }
        }
    }
    return allHold ? 0 : 1;
}
