// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/version.hpp"
#include "geometry/bezier/PlaneBezier.hpp"
#include "tokayMap/mapFiles.hpp"
#include "tokayMap/readSide.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <new>

namespace {

using namespace tokay;
using tool::MapOptions;

template <class Value>
CLI::CheckedTransformer oneOf(const std::map<std::string, Value>& names) {
    CLI::CheckedTransformer transformer(names);
    transformer.description("");
    return transformer;
}

const CLI::Validator finitePositive(
    [](const std::string& text) {
        double value = 0;
        const bool isNumber = CLI::detail::lexical_cast(text, value);
        return isNumber && value > 0 && std::isfinite(value)
                   ? std::string()
                   : text + " is out of range; allowed: (0, inf)";
    },
    "POSITIVE");

const std::map<std::string, mapper::ValuesAt> places = {{"vertices", mapper::ValuesAt::vertices},
                                                        {"faces", mapper::ValuesAt::faces}};

void addWhat(CLI::App& app, MapOptions& options) {
    app.add_option("FROM", options.from, "Mesh (.vtu, .vtp, .obj) or spline model (cad.json)")
        ->required();
    app.add_option("TO", options.to, "The other side; where the field goes");
    auto* what = app.add_option_group("what", "What is mapped");
    what->add_option("--field", options.field, "Field of FROM");
    what->add_option("--values", options.valuesFile,
                     "Table, a row a vertex, face or control point of FROM");
    what->add_option("--test-function", options.testFunction,
                     "Formula in x, y, z; the error against it is printed");
    what->require_option(0, 1);
    app.add_flag("--conservative", options.conservative,
                 "The field holds forces: keep their sum (transpose of the mapping back)");
    app.add_option("-o,--output", options.output, "The mapped field, for ParaView (.vtu)");
    app.add_option("--report", options.report, "The report as JSON");
}

void addOperator(CLI::App& app, tool::OperatorOptions& options) {
    using tool::Operator;
    app.add_option("--operator", options.kind,
                   "nearestNeighbour, nearestElement (default), rbf or mortar")
        ->transform(oneOf<Operator>({{"nearestNeighbour", Operator::nearestNeighbour},
                                     {"nearestElement", Operator::nearestElement},
                                     {"rbf", Operator::rbf},
                                     {"mortar", Operator::mortar}}));
    app.add_option("--gap-limit", options.gapLimit,
                   "Largest gap, relative to the size of the source (0.01, rbf 0.1)")
        ->check(finitePositive);
    app.add_flag("--allow-gaps", options.allowGaps, "Count points beyond it, do not refuse them");
    app.add_option_function<std::string>(
        "--kernel",
        [&options](const std::string& name) {
            options.rbf.kernel = mapper::radialKernelFromName(name);
        },
        "rbf: thinPlate (default), compactC2, compactC4 or compactC6");
    using mapper::RbfSolution;
    app.add_option(
           "--solution", options.rbf.solution,
           "rbf: automatic (default: by kernel and number of points), global or partitionOfUnity")
        ->transform(oneOf<RbfSolution>({{"automatic", RbfSolution::automatic},
                                        {"global", RbfSolution::global},
                                        {"partitionOfUnity", RbfSolution::partitionOfUnity}}));
    app.add_option("--radius", options.rbf.radius, "rbf: radius of compact kernels [m]")
        ->check(finitePositive);
    app.add_option("--neighbours", options.rbf.nNeighbours,
                   "rbf: points within the radius of compact kernels, if no radius is given")
        ->check(CLI::PositiveNumber);
    using mapper::MortarBasis;
    app.add_option("--basis", options.mortar.basis, "mortar: standard (default) or dual")
        ->transform(
            oneOf<MortarBasis>({{"standard", MortarBasis::standard}, {"dual", MortarBasis::dual}}));
    using mapper::SingularMass;
    app.add_option(
           "--singular", options.mortar.singular,
           "mortar, values that the interface leaves open: refuse (default), minimumNorm or "
           "gradientTerm")
        ->transform(oneOf<SingularMass>({{"refuse", SingularMass::refuse},
                                         {"minimumNorm", SingularMass::minimumNorm},
                                         {"gradientTerm", SingularMass::gradientTerm}}));
}

void addSides(CLI::App& app, MapOptions& options) {
    app.add_option("--from-at", options.fromAt, "Values of FROM: vertices or faces")
        ->transform(oneOf(places));
    app.add_option("--to-at", options.toAt, "Values of TO: vertices (default) or faces")
        ->transform(oneOf(places));
    app.add_option("--degree", options.degree, "Degree to which spline models are raised")
        ->check(CLI::Range(1, geometry::PlaneBezier::maxDegree));
    app.add_option("--divisions", options.nDivisions,
                   "Parts into which each knot span of spline models is cut")
        ->check(CLI::Range(1, 1000));
    app.add_option("--from-edges", options.edgesFrom,
                   "Edges of a spline model FROM, in place of its surface")
        ->delimiter(',');
    app.add_option("--to-edges", options.edgesTo,
                   "Edges of a spline model TO, in place of its surface")
        ->delimiter(',');
    app.add_option("--scale-from", options.scaleFrom, "Lengths of FROM times this are metres")
        ->check(finitePositive);
    app.add_option("--scale-to", options.scaleTo, "Lengths of TO times this are metres")
        ->check(finitePositive);
}

int runProgram(int argc, char** argv) {
    CLI::App app("Maps a field from one mesh or spline model to another", "tokay-map");
    app.set_version_flag("--version", std::string("tokay-map ") + version);
    MapOptions options;
    bool list = false;
    addWhat(app, options);
    addOperator(app, options.mapping);
    addSides(app, options);
    app.add_flag("--list", list, "Print the fields of FROM and stop");
    CLI11_PARSE(app, argc, argv);
    if (list) {
        fmt::print("{}", tool::listFields(tool::readMesh(options.from)));
        return 0;
    }
    if (options.to.empty()) {
        return app.exit(CLI::RequiredError("TO"));
    }
    fmt::print("{}", tool::mapFiles(options));
    return 0;
}

int fail(const std::string& message) {
    fmt::print(stderr, "tokay-map: error: {}\n", message);
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return runProgram(argc, argv);
    } catch (const std::bad_alloc&) {
        return fail("out of memory");
    } catch (const std::exception& error) {
        return fail(error.what());
    }
}
