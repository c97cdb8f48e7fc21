// SPDX-License-Identifier: GPL-3.0-or-later
// Supports on a trimming curve: the extended gradient method and its rivals on Poisson's
// problem, by element size, by the position of the cut and in time, and on a clamped disc.
#include "ShellMethod.hpp"
#include "ShiftedBoundary.hpp"
#include "Table.hpp"
#include "dynamics.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"
#include "trimmedDisc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

using namespace tokay::structure;

namespace {

const ShiftedBoundary shifted2("shifted 2", 2);
const ShiftedBoundary shifted("shifted", 0);

std::vector<const Method*> allMethods() {
    std::vector<const Method*> methods;
    for (const ShellMethod& method : shellMethods()) {
        methods.push_back(&method);
    }
    methods.push_back(&shifted2);
    methods.push_back(&shifted);
    return methods;
}

void writeOrders(const std::string& file, const std::vector<int>& meshes) {
    Table table(file, "method,degree,elements,L2Error,H1Error,solutions,seconds");
    for (const Method* method : allMethods()) {
        for (int degree = 1; degree <= method->maxDegree(); ++degree) {
            for (const int n : meshes) {
                table.addRow(fmt::format("{},{},{},", method->name(), degree, n), [&] {
                    const PoissonResult result = method->solve({}, degree, n);
                    return fmt::format("{:.3e},{:.3e},{},{:.2f}", result.error.value,
                                       result.error.gradient, result.nSolutions, result.seconds);
                });
            }
        }
    }
}

// Beside what is published for the same problem, elements and degrees: of all continuations of
// the gradient the one with the smallest error.
void writeIterated(const std::string& file, const std::string& published, int maxElements) {
    Table table(file, "degree,elements,tolerance,L2Error,published,solutions,seconds");
    std::ifstream rows(published);
    std::string row;
    for (std::getline(rows, row); std::getline(rows, row);) {
        int degree = 0, n = 0;
        double error = 0;
        std::sscanf(row.c_str(), "%d,%d,%lf", &degree, &n, &error);
        if (n > maxElements) {
            continue;
        }
        for (const double tolerance : {1e-6, 1e-9}) {
            table.addRow(fmt::format("{},{},{:g},", degree, n, tolerance), [&] {
                const PoissonResult result = publishedMethod(tolerance).solve({}, degree, n);
                return fmt::format("{:.3e},{:.3e},{},{:.2f}", result.error.value, error,
                                   result.nSolutions, result.seconds);
            });
        }
    }
}

void writeConditions(const std::string& file, const std::vector<int>& meshes) {
    Table table(file, "method,degree,elements,condition");
    for (const Method* method : allMethods()) {
        for (int degree = 1; degree <= method->maxDegree(); ++degree) {
            for (const int n : meshes) {
                table.addRow(fmt::format("{},{},{},", method->name(), degree, n), [&] {
                    return fmt::format("{:.3e}", conditionOf(method->matrix({}, degree, n)));
                });
            }
        }
    }
}

// The disc's left end lies a part of an element beyond a knot line.
void writeCuts(const std::string& file) {
    constexpr int n = 16, maxDegree = 3;
    Table table(file, "method,degree,cut,L2Error,condition,stableStepOverWhole");
    for (const Method* method : allMethods()) {
        for (int degree = 1; degree <= std::min(maxDegree, method->maxDegree()); ++degree) {
            const double whole = stableStepOfWhole(degree, n);
            for (const double cut : {1.0, 0.5, 0.1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
                PoissonSquare square;
                square.centre[0] = square.radius + (4 + cut) / n;
                table.addRow(fmt::format("{},{},{:g},", method->name(), degree, cut), [&] {
                    return fmt::format("{:.3e},{:.3e},{:.3f}",
                                       method->solve(square, degree, n).error.value,
                                       conditionOf(method->matrix(square, degree, n)),
                                       method->stableStep(square, degree, n) / whole);
                });
            }
        }
    }
}

void writeDisc(const std::string& file, const std::vector<int>& meshes) {
    Table table(file, "method,degree,elements,deflectionError,displacementError,seconds");
    for (const ShellMethod& method : shellMethods()) {
        if (method.name() == "egm physical" || method.name() == "egm iterated" ||
            method.name() == "penalty") {
            continue;
        }
        for (const int degree : {2, 3, 4, 5}) {
            for (const int n : meshes) {
                table.addRow(fmt::format("{},{},{},", method.name(), degree, n), [&] {
                    const auto start = std::chrono::steady_clock::now();
                    ShellDescription disc = discShell({}, degree, n, 1);
                    method.choose(disc);
                    Shell shell(std::move(disc));
                    TimeIntegrator integrator(shell, TimeScheme::quasiStatic(), {}, 0);
                    integrator.beginTimeStep(1, 1);
                    const DiscError error = discError(shell, integrator.solve());
                    const std::chrono::duration<double> seconds =
                        std::chrono::steady_clock::now() - start;
                    return fmt::format("{:.3e},{:.3e},{:.2f}", error.deflection, error.displacement,
                                       seconds.count());
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
    using Meshes = std::vector<int>;
    writeOrders(folder + "/orders.csv", isQuick ? Meshes{15, 30} : Meshes{15, 30, 60});
    writeIterated(folder + "/iterated.csv", folder + "/published.csv", isQuick ? 40 : 110);
    writeConditions(folder + "/conditions.csv", isQuick ? Meshes{8, 16} : Meshes{8, 16, 32});
    writeCuts(folder + "/cuts.csv");
    writeDynamics(folder + "/dynamics.csv");
    writeDisc(folder + "/disc.csv", isQuick ? Meshes{16} : Meshes{16, 24, 36, 54});
    return 0;
}
