// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to join patches and to hold trimmed edges: the roof in parts against the whole
// one, ratios of stiffness and density of two patches over 12 decades, thin plates, a
// balloon of two membranes, and what each costs. Their orders of convergence: orders.cpp.
#include "Table.hpp"
#include "exampleShell.hpp"
#include "igaStructure/timeIntegration/naturalModes.hpp"
#include "scenes.hpp"
#include "trimmedDisc.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <ctime>

namespace {

using namespace tokay;
using namespace tokay::structure;

struct Method {
    const char* name;
    EdgeMethod method;
    std::vector<double> factors; ///< the usual one first
};
const std::array<Method, 3> methods = {{{"penalty", EdgeMethod::penalty, {1e3, 1e1, 1e5, 1e7}},
                                        {"nitsche", EdgeMethod::nitsche, {1, 0.5, 10, 1e3}},
                                        {"lagrange", EdgeMethod::lagrange, {1e6, 1e2, 1e4, 1e8}}}};

// Differences in percent from the whole roof on a fine mesh.
void addRoofs(const std::string& directory, bool isQuick) {
    Table table(directory + "/edgeRoof.csv",
                "method,factor,n,cut_out_percent,three_patches_percent");
    const auto value = [](const Scene& scene) {
        Shell shell(scene.description);
        return scene.quantity(shell, solveStatic(shell));
    };
    const double whole = value(roofScenes(isQuick ? 2 : 4)[0]);
    for (const Method& method : methods) {
        for (const double factor : method.factors) {
            for (const int n : isQuick ? std::vector<int>{1} : std::vector<int>{1, 2, 4}) {
                table.addRow(fmt::format("{},{:g},{},", method.name, factor, n), [&] {
                    std::vector<Scene> scenes = roofScenes(n);
                    double differences[2];
                    for (const int k : {1, 2}) {
                        scenes[k].description.edgeMethod = method.method;
                        scenes[k].description.penalty = factor;
                        differences[k - 1] = 100 * (value(scenes[k]) / whole - 1);
                    }
                    return fmt::format("{:.5f},{:.5f}", differences[0], differences[1]);
                });
            }
        }
    }
}

// Cantilever of length 2 and width 1 without lateral contraction, its halves joined.
ShellDescription twoPlates(double stiffness, double density, double thickness) {
    const geometry::TrimmedPatch first(geometry::rectangle({0, 0, 0}, 1, 1), "first");
    const geometry::TrimmedPatch second(geometry::rectangle({1, 0, 0}, 1, 1), "second");
    ShellDescription plates{
        geometry::BrepModel({{first.refined(3, 3, 6, 2)}, {second.refined(4, 4, 4, 3)}},
                            {{"joint", {{0, right}, {1, left}}}}),
        {thickness, thickness},
        {1e6, 0, 1}};
    plates.faceMaterial = {{1e6, 0, 1}, {1e6 * stiffness, 0, density}};
    plates.strains = Strains::linear;
    plates.edgeSupports = {support(left, {true, true, true}, true)};
    return plates;
}

double halfBending(double thickness) {
    return 1e6 * std::pow(thickness, 3) / 12;
}

double tipUnderMoment(Shell& shell) {
    return shell.stateAt(1, 1, 0.5, solveStatic(shell)).displacement[2];
}

// Lowest frequency of the two halves as beams: clamped-free with a jump of EI and of
// mass, by the zero of the determinant of the eight conditions.
double steppedBeamFrequency(double stiffness, double density, double thickness) {
    using Matrix8d = Eigen::Matrix<double, 8, 8>;
    const double EI = halfBending(thickness);
    const auto determinant = [&](double omega) {
        const double k1 = std::pow(omega * omega * thickness / EI, 0.25);
        const double k2 = std::pow(omega * omega * thickness * density / (EI * stiffness), 0.25);
        // Krylov's functions of k x and their derivatives, over k^n.
        const auto krylov = [](double x, int function, int derivative) {
            const auto even = [&](int sign) { return 0.5 * (std::cosh(x) + sign * std::cos(x)); };
            const auto odd = [&](int sign) { return 0.5 * (std::sinh(x) + sign * std::sin(x)); };
            switch ((function - derivative + 8) % 4) {
            case 0:
                return even(1);
            case 1:
                return odd(1);
            case 2:
                return even(-1);
            default:
                return odd(-1);
            }
        };
        Matrix8d m = Matrix8d::Zero();
        const double scale[4] = {1, k2 / k1, stiffness * std::pow(k2 / k1, 2),
                                 stiffness * std::pow(k2 / k1, 3)};
        for (int f = 0; f < 4; ++f) {
            m(0, f) = f == 0;
            m(1, f) = f == 1;
            for (int n = 0; n < 4; ++n) {
                m(2 + n, f) = krylov(k1, f, n);
                m(2 + n, 4 + f) = -scale[n] * krylov(0, f, n);
            }
            m(6, 4 + f) = krylov(k2, f, 2);
            m(7, 4 + f) = krylov(k2, f, 3);
        }
        for (int row = 0; row < 8; ++row) {
            m.row(row) /= m.row(row).lpNorm<Eigen::Infinity>();
        }
        return m.determinant();
    };
    // All scales of both halves lie above this one.
    double low =
        1e-2 * std::sqrt(EI * std::min(1.0, stiffness) / (thickness * std::max(1.0, density)));
    const double sign = determinant(low);
    constexpr double step = 1.02;
    while (determinant(step * low) * sign > 0) {
        low *= step;
    }
    double high = step * low;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (determinant(middle) * sign > 0 ? low : high) = middle;
    }
    return low;
}

void addRatios(const std::string& directory) {
    Table table(directory + "/edgeRatios.csv",
                "method,stiffness_ratio,density_ratio,tip_error,frequency_error");
    constexpr double thickness = 0.02;
    const std::array<std::array<double, 2>, 13> exponents = {{{-6, 0},
                                                              {-4, 0},
                                                              {-2, 0},
                                                              {0, 0},
                                                              {2, 0},
                                                              {4, 0},
                                                              {6, 0},
                                                              {0, -6},
                                                              {0, -3},
                                                              {0, 3},
                                                              {0, 6},
                                                              {-6, 6},
                                                              {6, -6}}};
    for (const Method& method : methods) {
        for (const auto& [stiffnessExponent, densityExponent] : exponents) {
            const double stiffness = std::pow(10, stiffnessExponent);
            const double density = std::pow(10, densityExponent);
            table.addRow(fmt::format("{},{:g},{:g},", method.name, stiffness, density), [&] {
                ShellDescription plates = twoPlates(stiffness, density, thickness);
                plates.edgeMethod = method.method;
                plates.loads.edgeMoments = {{{1, right}, ScalarField::constant(-1e-6)}};
                Shell shell(std::move(plates));
                const double tip = 1e-6 / halfBending(thickness) * (1.5 + 0.5 / stiffness);
                const double frequency = naturalModes(shell, 1).angularFrequencies[0];
                return fmt::format("{:.2e},{:.2e}", tipUnderMoment(shell) / tip - 1,
                                   frequency / steppedBeamFrequency(stiffness, density, thickness) -
                                       1);
            });
        }
    }
}

// A balloon of two membranes at stretch 1.2: what the joint's radius and the widening of
// the whole are off by, over the widening.
void addMembrane(const std::string& directory, bool isQuick) {
    Table table(directory + "/edgeMembrane.csv", "method,factor,elements,joint_error,far_error");
    constexpr double stretch = 1.2;
    constexpr int nLoadSteps = 5;
    for (const Method& method : methods) {
        if (method.method == EdgeMethod::nitsche) {
            continue; // of linear strains only
        }
        for (const double factor : method.factors) {
            for (const int n : isQuick ? std::vector<int>{4, 8} : std::vector<int>{4, 8, 16}) {
                table.addRow(fmt::format("{},{:g},{},", method.name, factor, n), [&] {
                    ShellDescription balloon =
                        balloonHalves({[](const geometry::Point&, double t) {
                                           return t * balloonPressure(stretch);
                                       },
                                       true},
                                      n);
                    balloon.edgeMethod = method.method;
                    balloon.penalty = factor;
                    Shell shell(std::move(balloon));
                    const Eigen::VectorXd d = solveStatic(shell, nLoadSteps, false);
                    const geometry::NurbsSurface& first = shell.patches()[0]->surface();
                    const double far =
                        1 + displacementAt(shell, first.u().first(), first.v().first(), d)[0] / 10;
                    const auto error = [](double reached) {
                        return (reached - stretch) / (stretch - 1);
                    };
                    return fmt::format("{:.2e},{:.2e}",
                                       error(worstStretchOfJoint(shell, d, stretch)), error(far));
                });
            }
        }
    }
}

void addThickness(const std::string& directory) {
    Table table(directory + "/edgeThickness.csv",
                "method,thickness,joined_tip_error,disc_w,disc_bending");
    for (const Method& method : methods) {
        for (const double thickness : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
            table.addRow(fmt::format("{},{:g},", method.name, thickness), [&] {
                ShellDescription plates = twoPlates(1, 1, thickness);
                plates.edgeMethod = method.method;
                const double moment = 0.1 * halfBending(thickness);
                plates.loads.edgeMoments = {{{1, right}, ScalarField::constant(-moment)}};
                Shell joined(std::move(plates));
                TrimmedDisc disc;
                disc.thickness = thickness;
                ShellDescription description = discShell(disc, 3, 16, 2);
                description.edgeMethod = method.method;
                Shell shell(std::move(description));
                const DiscError error = discError(shell, solveStatic(shell));
                return fmt::format("{:.2e},{:.2e},{:.2e}", tipUnderMoment(joined) / 0.2 - 1,
                                   error.deflection, error.bending);
            });
        }
    }
}

// Numbers in the triangle of the stiffness and of its factor, ordered by minimum degree.
std::pair<Eigen::Index, Eigen::Index> fill(const Shell& shell) {
    SparseMatrix tangent;
    shell.internalForce(Eigen::VectorXd::Zero(shell.nUnknowns()), tangent);
    Eigen::SparseMatrix<double> K = tangent;
    K.prune([&](Eigen::Index row, Eigen::Index column, double value) {
        const bool isFree = !shell.fixed()[row] && !shell.fixed()[column];
        return row == column || (isFree && value != 0);
    });
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
    return {(K.nonZeros() + K.rows()) / 2,
            factor.matrixL().nestedExpression().nonZeros() + K.rows()};
}

void addCost(const std::string& directory) {
    Table table(directory + "/edgeCost.csv",
                "method,slivers,processor_seconds,stiffness_numbers,factor_numbers,disc_w");
    for (const Method& method : methods) {
        for (const bool extended : {false, true}) {
            const char* slivers = extended ? "extension" : "scaling";
            table.addRow(fmt::format("{},{},", method.name, slivers), [&] {
                ShellDescription disc = discShell({}, 3, 24, 2);
                disc.edgeMethod = method.method;
                disc.sliverTreatment =
                    extended ? SliverTreatment::extension : SliverTreatment::scaling;
                const std::clock_t start = std::clock();
                Shell shell(std::move(disc));
                const Eigen::VectorXd d = solveStatic(shell);
                const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
                const auto [stiffness, factor] = fill(shell);
                return fmt::format("{:.2f},{},{},{:.2e}", seconds, stiffness, factor,
                                   discError(shell, d).deflection);
            });
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        const bool isQuick = argc > 2;
        addRoofs(argv[1], isQuick);
        addRatios(argv[1]);
        addThickness(argv[1]);
        addMembrane(argv[1], isQuick);
        addCost(argv[1]);
        return 0;
    } catch (const tokay::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
    }
    return 1;
}
