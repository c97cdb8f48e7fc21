// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of convergence on a manufactured trimmed problem: the clamped disc that is cut
// out of a square patch, or of two that do not match, by method and degree.
// Usage: shellOrders FILE METHOD|all ELEMENTS..., elements a side of the square
#include "Table.hpp"
#include "exampleShell.hpp"
#include "trimmedDisc.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <utility>
#include <vector>

namespace {

using namespace tokay;
using namespace tokay::structure;

struct Solution {
    DiscError error{};
    Eigen::Index nUnknowns = 0;
    double seconds = 0;
};

Solution solve(EdgeMethod method, int degree, int nParts, int nElements) {
    const std::clock_t start = std::clock();
    ShellDescription disc = discShell({}, degree, nElements, nParts);
    disc.edgeMethod = method;
    Shell shell(std::move(disc));
    const Eigen::VectorXd d = solveStatic(shell);
    Solution solution;
    solution.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    solution.nUnknowns = std::count(shell.fixed().begin(), shell.fixed().end(), false);
    solution.error = discError(shell, d);
    return solution;
}

/// An error, and the order since the coarser mesh; 0 for the first.
std::string withOrder(double now, double before, double refinement) {
    const double order = before == 0 ? 0 : std::log(before / now) / std::log(refinement);
    return fmt::format("{:.3e},{:.3f}", now, order);
}

} // namespace

int main(int argc, char** argv) {
    try {
        const std::string chosen = argv[2];
        std::vector<int> meshes;
        std::transform(argv + 3, argv + argc, std::back_inserter(meshes),
                       [](const char* text) { return std::stoi(text); });
        Table table(argv[1], "method,degree,parts,elements,unknowns,processor_seconds,"
                             "w,order,bending,order,u,order,strain,order");
        const std::pair<const char*, EdgeMethod> methods[] = {{"penalty", EdgeMethod::penalty},
                                                              {"nitsche", EdgeMethod::nitsche},
                                                              {"lagrange", EdgeMethod::lagrange}};
        for (const auto& [name, method] : methods) {
            if (chosen != "all" && chosen != name) {
                continue;
            }
            for (const int degree : {2, 3, 4}) {
                for (const int nParts : {1, 2}) {
                    DiscError last{};
                    double lastElements = 1;
                    for (const int n : meshes) {
                        table.addRow(fmt::format("{},{},{},{},", name, degree, nParts, n), [&] {
                            const Solution s = solve(method, degree, nParts, n);
                            const double finer = n / lastElements;
                            const std::string row = fmt::format(
                                "{},{:.2f},{},{},{},{}", s.nUnknowns, s.seconds,
                                withOrder(s.error.deflection, last.deflection, finer),
                                withOrder(s.error.bending, last.bending, finer),
                                withOrder(s.error.displacement, last.displacement, finer),
                                withOrder(s.error.strain, last.strain, finer));
                            last = s.error;
                            lastElements = n;
                            return row;
                        });
                    }
                }
            }
        }
        return 0;
    } catch (const tokay::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 1;
}
