// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds of one Newton iteration of a nonlinear shell against its unknowns: assembly
// of the tangent, factorisation (symbolic once, numeric each iteration) and solution,
// on one core and on all, with the exponents of their growth.
#include "common/errors.hpp"
#include "geometry/primitives/primitives.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"
#include "igaStructure/linearAlgebra/LinearSolver.hpp"
#include "timing.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>

namespace {

using namespace tokay;
using namespace tokay::structure;
using benchmarks::bestSeconds;
using benchmarks::Seconds;
using Eigen::VectorXd;

enum Rim { bottom = 0 };

/// Part of a cylinder, clamped at its bottom, in square elements.
Shell cylinder(int degree, int nElements) {
    const geometry::TrimmedPatch patch(geometry::cylinderPatch({0, 0, 0}, 25, 35, 0.8, 2.2));
    ShellDescription description{
        geometry::BrepModel({{patch.refined(degree, degree, nElements, nElements)}}),
        {0.25},
        {4e8, 0.3, 1}};
    description.edgeSupports = {{{{0, bottom}}, {true, true, true}, true}};
    return Shell(std::move(description));
}

constexpr std::array<const char*, 4> phases = {"assembly", "symbolic", "numeric", "solution"};

struct Measured {
    int nFree;
    double factorEntries;
    std::array<Seconds, 4> seconds; ///< of the phases
};

Measured measure(Shell& shell, const VectorXd& displacement, int nThreads) {
    shell.setThreads(nThreads);
    benchmarks::setBlasThreads(nThreads);
    const int nTimes = shell.nUnknowns() < 100000 ? 3 : 1;
    Measured measured{};
    SparseMatrix tangent;
    VectorXd force = shell.internalForce(displacement, tangent).force;
    measured.seconds[0] =
        bestSeconds(nTimes, [&] { force = shell.internalForce(displacement, tangent).force; });
    std::unique_ptr<LinearSolver> solver;
    measured.seconds[1] = bestSeconds(nTimes, [&] {
        solver = makeLinearSolver(tangent, shell.fixed(), MatrixKind::positiveDefinite);
    });
    measured.seconds[2] = bestSeconds(nTimes, [&] { solver->factorise(tangent); });
    measured.seconds[3] = bestSeconds(nTimes, [&] { force = solver->solve(force); });
    measured.nFree = solver->nFree();
    measured.factorEntries = solver->nFactorEntries();
    return measured;
}

/// Slope of the line through (log x, log y) by least squares.
class Exponent {
  public:
    void add(double x, double y) { rows_.emplace_back(std::log(x), std::log(y)); }
    double value() const {
        Eigen::MatrixX2d A(rows_.size(), 2);
        VectorXd b(rows_.size());
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            A.row(static_cast<Eigen::Index>(k)) << 1, rows_[k][0];
            b[static_cast<Eigen::Index>(k)] = rows_[k][1];
        }
        return Eigen::Vector2d(A.colPivHouseholderQr().solve(b))[1];
    }

  private:
    std::vector<Eigen::Vector2d> rows_;
};

class Table {
  public:
    explicit Table(const char* file) : file_(file) {
        write("degree,threads,dof,factor_entries,assembly_s,symbolic_s,numeric_s,solution_s,"
              "iteration_s,assembly_processor_s,symbolic_processor_s,numeric_processor_s,"
              "solution_processor_s,product_GFlops\n");
    }
    void add(int degree, int nThreads, const Measured& measured) {
        std::string line = fmt::format("{},{},{},{:.0f}", degree, nThreads, measured.nFree,
                                       measured.factorEntries);
        for (const Seconds& seconds : measured.seconds) {
            line += fmt::format(",{:.5f}", seconds.wall);
        }
        const auto& s = measured.seconds;
        line += fmt::format(",{:.5f}", s[0].wall + s[2].wall + s[3].wall);
        for (const Seconds& seconds : s) {
            line += fmt::format(",{:.5f}", seconds.processor);
        }
        write(line + fmt::format(",{:.1f}\n", rate_));
    }

  private:
    void write(const std::string& line) {
        fmt::print("{}", line);
        std::fflush(stdout);
        file_ << line;
        file_.flush();
    }
    std::ofstream file_;
    double rate_ = benchmarks::productRate();
};

/// Of one degree: sizes, exponents of processor time on one core, gain by the others.
void run(int degree, const std::vector<int>& sizes, Table& table) {
    std::map<std::string, Exponent> exponents;
    std::string gains;
    for (const int nUnknowns : sizes) {
        const int nElements = static_cast<int>(std::lround(std::sqrt(nUnknowns / 3.0))) - degree;
        Shell shell = cylinder(degree, nElements);
        const VectorXd displacement = VectorXd::Zero(shell.nUnknowns()); // costs what any does
        const Measured one = measure(shell, displacement, 1);
        table.add(degree, 1, one);
        for (std::size_t k = 0; k < phases.size(); ++k) {
            exponents[phases[k]].add(one.nFree, one.seconds[k].processor);
        }
        for (int nThreads = 2; nThreads <= availableThreads(); ++nThreads) {
            const Measured more = measure(shell, displacement, nThreads);
            table.add(degree, nThreads, more);
            gains += fmt::format("degree {}, {} unknowns, {} threads: assembly {:.2f}, numeric "
                                 "factorisation {:.2f}, solution {:.2f} times as fast\n",
                                 degree, more.nFree, nThreads,
                                 one.seconds[0].wall / more.seconds[0].wall,
                                 one.seconds[2].wall / more.seconds[2].wall,
                                 one.seconds[3].wall / more.seconds[3].wall);
        }
    }
    for (const char* phase : phases) {
        fmt::print("degree {}, {}: seconds grow with unknowns to the power {:.2f}\n", degree, phase,
                   exponents[phase].value());
    }
    fmt::print("{}", gains);
}

} // namespace

int main(int argc, char** argv) {
    const int largest = argc > 2 ? std::stoi(argv[2]) : 1000000;
    try {
        benchmarks::setBlasThreads(1);
        Table table(argv[1]);
        for (const int degree : {2, 3}) {
            std::vector<int> sizes;
            for (const int size : {1000, 3000, 10000, 30000, 100000, 300000, 1000000}) {
                // Degree 3 has twice the entries a row: the largest is degree 2's alone.
                if (size <= largest && (degree == 2 || size < 1000000)) {
                    sizes.push_back(size);
                }
            }
            run(degree, sizes, table);
        }
        return 0;
    } catch (const SolverError& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 1;
}
