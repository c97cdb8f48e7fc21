// SPDX-License-Identifier: GPL-3.0-or-later
// The same flap (0.1 x 1 m, clamped at its foot, nothing moves across its plane)
// under a uniform dead traction, as beam, shell, planeStrain and solid. Half of the
// traction acts on either side, so that all theories have it on their axis.
// Error of the tip against the finest solution of the same theory (planeStrain is
// that of solid, too), and against plane strain, with unknowns and processor seconds
// of model and solution.
#include "common/errors.hpp"
#include "igaStructure/case/makeBody.hpp"
#include "igaStructure/case/readCase.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace tokay;
using namespace tokay::structure;

constexpr double youngsModulus = 4e6;
constexpr double poissonsRatio = 0.3;
constexpr double thickness = 0.1;

// Linear: the tip moves by 3 % of the length; nonlinear: by half of it.
double tractionOf(const std::string& strains) {
    return strains == "linear" ? 100 : 2000;
}

struct Flap {
    std::string kinematics, strains;
    int degree, nElements; ///< along the height
};

int nAcross(const Flap& flap) {
    return std::max(1, flap.nElements / 8);
}

std::string geometryText(const Flap& flap) {
    const int p = flap.degree;
    const int n = flap.nElements;
    if (flap.kinematics == "beam") {
        return fmt::format("geometry: {{line: {{from: [0, 0], to: [0, 1]}}}}\n"
                           "discretisation: {{degree: [{}], elements: [{}]}}\n",
                           p, n);
    }
    if (flap.kinematics == "shell") {
        return fmt::format("geometry: {{plate: {{origin: [0, 0, 0], edgeXi: [0, 1, 0], "
                           "edgeEta: [0, 0, 1]}}}}\n"
                           "discretisation: {{degree: [{}, 2], elements: [{}, 1]}}\n",
                           p, n);
    }
    if (flap.kinematics == "planeStrain") {
        return fmt::format("geometry: {{rectangle: {{origin: [-0.05, 0], size: [0.1, 1]}}}}\n"
                           "discretisation: {{degree: [{}, {}], elements: [{}, {}]}}\n",
                           p, p, nAcross(flap), n);
    }
    return fmt::format("geometry: {{block: {{origin: [-0.05, 0, 0], size: [0.1, 1, 1]}}}}\n"
                       "discretisation: {{degree: [{}, {}, {}], elements: [{}, {}, 1]}}\n",
                       p, p, p, nAcross(flap), n);
}

// Supports and loads.
std::string actionText(const Flap& flap) {
    const double q = tractionOf(flap.strains);
    if (flap.kinematics == "beam") {
        return fmt::format("supports: [{{end: start, fix: [x, y, rotation]}}]\n"
                           "loads: [{{traction: [\"{:g}*t\", 0]}}]\n",
                           q);
    }
    if (flap.kinematics == "shell") {
        return fmt::format("supports:\n"
                           "  - {{edge: left, fix: [x, y, z, rotation]}}\n"
                           "  - {{edge: bottom, fix: [z, rotation]}}\n"
                           "  - {{edge: top, fix: [z, rotation]}}\n"
                           "loads: [{{traction: [\"{:g}*t\", 0, 0]}}]\n",
                           q);
    }
    if (flap.kinematics == "planeStrain") {
        return fmt::format("supports: [{{edge: bottom, fix: [x, y]}}]\n"
                           "loads:\n"
                           "  - {{edge: left, traction: [\"{0:g}*t\", 0]}}\n"
                           "  - {{edge: right, traction: [\"{0:g}*t\", 0]}}\n",
                           0.5 * q);
    }
    return fmt::format("supports:\n"
                       "  - {{faces: [bottom], fix: [x, y, z]}}\n"
                       "  - {{faces: [back], fix: [z]}}\n"
                       "  - {{faces: [front], fix: [z]}}\n"
                       "loads:\n"
                       "  - {{face: left, traction: [\"{0:g}*t\", 0, 0]}}\n"
                       "  - {{face: right, traction: [\"{0:g}*t\", 0, 0]}}\n",
                       0.5 * q);
}

std::string caseText(const Flap& flap) {
    const bool isThin = flap.kinematics == "beam" || flap.kinematics == "shell";
    const std::string penalty = flap.kinematics == "shell" ? ", penalty: 1e6" : "";
    const int nLoadSteps = flap.strains == "linear" ? 1 : 5;
    return geometryText(flap) +
           fmt::format("model: {{kinematics: {}, strains: {}{}{}}}\n", flap.kinematics,
                       flap.strains, isThin ? fmt::format(", thickness: {}", thickness) : "",
                       penalty) +
           fmt::format("material: {{type: StVenantKirchhoff, youngsModulus: {:g}, poissonsRatio: "
                       "{}, density: 3000}}\n",
                       youngsModulus, poissonsRatio) +
           actionText(flap) +
           fmt::format("time: {{scheme: static, step: {:g}, end: 1}}\n", 1.0 / nLoadSteps);
}

struct Price {
    Flap flap;
    Eigen::Index nUnknowns = 0;
    double seconds = 0;
    double tip = 0;                   ///< along the load [m]
    double error = 0, modelError = 0; ///< percent
};

double tipOf(const Body& body, const Eigen::VectorXd& displacement) {
    const double depth = body.dimension() == 2 ? 0 : 0.5;
    const Body::Closest tip = body.closest({0, 1, depth});
    return body.displacements(displacement, {tip.location})(0, 0);
}

Price solveOnce(const Flap& flap) {
    const Case structureCase = readCaseText(caseText(flap), "flap");
    const std::clock_t start = std::clock();
    const std::unique_ptr<Body> body = makeBody(structureCase);
    StructuralModel& model = body->model();
    TimeIntegrator integrator(model, *structureCase.implicitScheme(), structureCase.newton, 0);
    const double step = structureCase.timeSteps->step;
    for (int k = 1; k * step < 1 + 0.5 * step; ++k) {
        integrator.beginTimeStep(k * step, step);
        integrator.solve();
        integrator.acceptTimeStep();
    }
    Price price{flap};
    price.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    price.nUnknowns = std::count(model.fixed().begin(), model.fixed().end(), false);
    price.tip = tipOf(*body, integrator.state().displacement);
    return price;
}

// Short ones are solved several times, the shortest time counts.
Price solve(const Flap& flap) {
    Price price = solveOnce(flap);
    for (int k = 0; k < 4 && price.seconds < 0.1; ++k) {
        price.seconds = std::min(price.seconds, solveOnce(flap).seconds);
    }
    return price;
}

// Elements along the height that are tried.
std::vector<int> meshes(const std::string& kinematics, int degree, bool isQuick) {
    std::vector<int> all = kinematics == "planeStrain" || kinematics == "solid"
                               ? std::vector<int>{4, 8, 16, 32, 64}
                               : std::vector<int>{2, 4, 8, 16, 32, 64};
    const std::size_t nSolid = degree == 1 ? 5 : degree <= 3 ? 4 : 3;
    if (kinematics == "solid") {
        all.resize(nSolid);
    }
    if (isQuick) {
        all.resize(std::min<std::size_t>(all.size(), degree == 5 ? 2 : 3));
    }
    return all;
}

std::vector<Price> pricesOf(const std::string& strains, bool isQuick) {
    std::vector<Price> prices;
    for (const char* kinematics : {"beam", "shell", "planeStrain", "solid"}) {
        const bool bendsThinly =
            kinematics == std::string("beam") || kinematics == std::string("shell");
        for (int degree = bendsThinly ? 2 : 1; degree <= 5; ++degree) {
            for (const int nElements : meshes(kinematics, degree, isQuick)) {
                prices.push_back(solve({kinematics, strains, degree, nElements}));
            }
        }
    }
    const double beam = solve({"beam", strains, 5, 64}).tip;
    const double shell = solve({"shell", strains, 5, 64}).tip;
    const double plane = solve({"planeStrain", strains, 5, isQuick ? 64 : 128}).tip;
    for (Price& price : prices) {
        const double same = price.flap.kinematics == "beam"    ? beam
                            : price.flap.kinematics == "shell" ? shell
                                                               : plane;
        price.error = 100 * std::abs(price.tip / same - 1);
        price.modelError = 100 * std::abs(price.tip / plane - 1);
    }
    return prices;
}

std::string text(const Price& price) {
    return fmt::format("{},{},{},{},{},{:.2e},{:.8f},{:.2e},{:.3f}\n", price.flap.kinematics,
                       price.flap.strains, price.flap.degree, price.flap.nElements, price.nUnknowns,
                       price.seconds, price.tip, price.error, price.modelError);
}

/// The fewest seconds of each kinematics for an error against plane strain [percent].
void printCheapest(const std::vector<Price>& prices, double limit) {
    std::map<std::string, const Price*> best;
    for (const Price& price : prices) {
        const Price*& own = best[price.flap.kinematics];
        if (price.modelError <= limit && (!own || price.seconds < own->seconds)) {
            own = &price;
        }
    }
    for (const auto& [kinematics, price] : best) {
        fmt::print("  {:12} {}\n", kinematics,
                   price ? fmt::format("degree {}, {} elements along the height: {} unknowns, "
                                       "{:.2e} s",
                                       price->flap.degree, price->flap.nElements, price->nUnknowns,
                                       price->seconds)
                         : "does not reach it");
    }
}

/// @return  whether the values with a reference keep their limits
bool judge(const std::vector<Price>& prices, const std::string& strains) {
    bool good = true;
    const auto check = [&](const std::string& what, double error, double limit) {
        fmt::print("  {}: off by {:.2e} %, limit {:g} %: {}\n", what, error, limit,
                   error <= limit ? "ok" : "OUTSIDE");
        good = good && error <= limit;
    };
    const auto finest = [&](const std::string& kinematics, int degree) {
        const Price* found = nullptr;
        for (const Price& price : prices) {
            if (price.flap.kinematics == kinematics && price.flap.degree == degree) {
                found = &price;
            }
        }
        return *found;
    };
    if (strains == "linear") {
        const double stiffness =
            youngsModulus / (1 - poissonsRatio * poissonsRatio) * std::pow(thickness, 3) / 12;
        const double exact = tractionOf(strains) / (8 * stiffness);
        check("linear beam of degree 4 against q L^4 / 8 E I",
              100 * std::abs(finest("beam", 4).tip / exact - 1), 1e-6);
    }
    // Their strains differ where stretch and bending meet.
    check("finest shell of degree 4 against the beam",
          100 * std::abs(finest("shell", 4).tip / finest("beam", 4).tip - 1), 0.2);
    for (const Price& price : prices) {
        if (price.flap.kinematics != "solid") {
            continue;
        }
        for (const Price& plane : prices) {
            const bool isTwin = plane.flap.kinematics == "planeStrain" &&
                                plane.flap.degree == price.flap.degree &&
                                plane.flap.nElements == price.flap.nElements;
            if (isTwin && price.flap.nElements == 8) {
                check(fmt::format("solid of degree {} and 8 elements against planeStrain",
                                  price.flap.degree),
                      100 * std::abs(price.tip / plane.tip - 1), 1e-5);
            }
        }
    }
    return good;
}

} // namespace

int main(int argc, char** argv) {
    try {
        std::ofstream file(argv[1]);
        const auto write = [&](const std::string& line) {
            fmt::print("{}", line);
            std::fflush(stdout);
            file << line;
        };
        write("kinematics,strains,degree,elements,unknowns,processor_seconds,tip_m,"
              "error_percent,error_against_plane_strain_percent\n");
        bool good = true;
        for (const char* strains : {"linear", "nonlinear"}) {
            const std::vector<Price> prices = pricesOf(strains, argc > 2);
            for (const Price& price : prices) {
                write(text(price));
            }
            for (const double limit : {5.0, 1.0, 0.1}) {
                fmt::print("{} strains, cheapest within {} % of plane strain:\n", strains, limit);
                printCheapest(prices, limit);
            }
            good = judge(prices, strains) && good;
        }
        return good ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
