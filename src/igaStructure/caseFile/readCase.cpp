#include "igaStructure/caseFile/readCase.hpp"

#include "common/errors.hpp"
#include "geometry/primitives.hpp"
#include "geometry/refinement.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/readCoupling.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace tokay::structure {

namespace {

geometry::NurbsSurface readRectangle(const CaseSection& section) {
    const std::vector<double> origin = section.numbers("origin");
    const std::vector<double> size = section.numbers("size");
    return geometry::rectangle({origin[0], origin[1], 0}, size[0], size[1]);
}

geometry::NurbsSurface readNurbs(const CaseSection& section) {
    const std::vector<int> degree = section.integers("degree");
    const std::vector<std::vector<double>> rows = section.points("controlPoints");
    geometry::Points points(rows.size(), 3);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        points.row(k) << rows[k][0], rows[k][1], 0;
    }
    Eigen::VectorXd weights;
    if (section.has("weights")) {
        const std::vector<double> given = section.numbers("weights");
        weights = Eigen::Map<const Eigen::VectorXd>(given.data(), given.size());
    }
    try {
        return {geometry::KnotVector(degree[0], section.numbers("knotsXi")),
                geometry::KnotVector(degree[1], section.numbers("knotsEta")), points, weights};
    } catch (const InputError& error) {
        throw section.error("", error.what());
    }
}

geometry::NurbsSurface readGeometry(const CaseSection& section) {
    if (section.has("rectangle") == section.has("nurbs")) {
        throw section.error("", "give exactly one of: rectangle, nurbs");
    }
    return section.has("nurbs") ? readNurbs(section.section("nurbs"))
                                : readRectangle(section.section("rectangle"));
}

geometry::NurbsSurface refine(const geometry::NurbsSurface& coarse, const CaseSection& section) {
    const std::vector<int> degree = section.integers("degree");
    const std::vector<int> elements = section.integers("elements");
    if (degree[0] < coarse.u().degree() || degree[1] < coarse.v().degree()) {
        throw section.error("degree",
                            fmt::format("[{}, {}] is below the geometry's [{}, {}]", degree[0],
                                        degree[1], coarse.u().degree(), coarse.v().degree()));
    }
    return geometry::refine(coarse, degree[0], degree[1], elements[0], elements[1]);
}

Material readMaterial(const CaseSection& file) {
    const CaseSection model = file.section("model");
    const CaseSection section = file.section("material");
    const CaseSection damping = section.section("rayleighDamping");
    Material material;
    material.youngsModulus = section.number("youngsModulus");
    material.poissonsRatio = section.number("poissonsRatio");
    material.density = section.number("density");
    material.massDamping = damping.number("mass");
    material.stiffnessDamping = damping.number("stiffness");
    if (model.text("kinematics") == "planeStrain") {
        requireUsed(model, {"kinematics", "strains"}, "planeStrain");
        return material;
    }
    material.kinematics = Kinematics::planeStress;
    if (!model.has("thickness")) {
        throw model.error("", "entry 'thickness' is missing: planeStress needs it");
    }
    material.thickness = model.number("thickness");
    return material;
}

std::vector<Support> readSupports(const CaseSection& file) {
    std::vector<Support> supports;
    for (const CaseSection& section : file.list("supports")) {
        Support support{geometry::edgeFromName(section.text("edge")), {false, false}};
        for (const std::string& component : section.words("fix")) {
            support.fixed[component == "x" ? 0 : 1] = true;
        }
        supports.push_back(support);
    }
    return supports;
}

std::array<Formula, 2> pair(std::vector<Formula> formulas) {
    return {std::move(formulas[0]), std::move(formulas[1])};
}

Loads readLoads(const CaseSection& file) {
    Loads loads;
    for (const CaseSection& section : file.list("loads")) {
        const bool onEdge = section.has("edge") && section.has("traction");
        const bool onEdgeOrPart = section.has("edge") || section.has("traction");
        if (section.has("gravity") == onEdgeOrPart || onEdge != onEdgeOrPart) {
            throw section.error("", "give either edge and traction, or gravity alone");
        }
        if (onEdge) {
            loads.tractions.push_back(
                {geometry::edgeFromName(section.text("edge")), pair(section.formulas("traction"))});
        } else {
            loads.gravities.push_back({pair(section.formulas("gravity"))});
        }
    }
    return loads;
}

TimeScheme readTimeScheme(const CaseSection& section) {
    const auto numberOr = [&](const char* name, double otherwise) {
        return section.has(name) ? section.number(name) : otherwise;
    };
    const std::string scheme = section.text("scheme");
    if (scheme == "static") {
        requireUsed(section, {"scheme", "step", "end"}, "scheme static");
        return TimeScheme::quasiStatic();
    }
    if (scheme == "newmark") {
        requireUsed(section, {"scheme", "beta", "gamma", "step", "end"}, "scheme newmark");
        return TimeScheme::newmark(numberOr("beta", 0.25), numberOr("gamma", 0.5));
    }
    requireUsed(section, {"scheme", "spectralRadius", "step", "end"}, "scheme generalisedAlpha");
    return TimeScheme::generalisedAlpha(numberOr("spectralRadius", 0.8));
}

std::optional<TimeSteps> readTimeSteps(const CaseSection& section) {
    if (!section.has("step") && !section.has("end")) {
        return std::nullopt;
    }
    for (const char* name : {"step", "end"}) {
        if (!section.has(name)) {
            throw section.error("", fmt::format("entry '{}' is missing: a run alone needs step "
                                                "and end (a coupled run neither)",
                                                name));
        }
    }
    const TimeSteps steps{section.number("step"), section.number("end")};
    if (steps.end < steps.step) {
        throw section.error(
            "end", fmt::format("{} s is shorter than one step of {} s", steps.end, steps.step));
    }
    return steps;
}

NewtonOptions readNewton(const CaseSection& section) {
    return {section.number("tolerance"), section.integer("maximumIterations"),
            section.yesNo("lineSearch")};
}

OutputOptions readOutput(const CaseSection& section, const std::string& directory) {
    OutputOptions output;
    output.directory = (std::filesystem::path(directory) / section.text("directory")).string();
    output.interval = section.integer("interval");
    output.fields = section.words("fields");
    output.cells = section.text("cells") == "bezier" ? CellShape::bezier : CellShape::quads;
    output.subdivision = section.integer("subdivision");
    for (const CaseSection& item : section.list("watchPoints")) {
        const std::vector<double> at = item.numbers("at");
        output.watchPoints.push_back({item.text("name"), {at[0], at[1]}});
    }
    return output;
}

} // namespace

Case readCase(const std::string& fileName) {
    return readCase(CaseSection::fromFile(fileName), fileName);
}

Case readCase(const CaseSection& file, const std::string& fileName) {
    const std::filesystem::path path(fileName);
    const std::string directory = path.has_parent_path() ? path.parent_path().string() : ".";
    const CaseSection time = file.section("time");
    const bool isCoupled = file.has("coupling");
    return {file.has("name") ? file.text("name") : path.stem().string(),
            fileName,
            directory,
            refine(readGeometry(file.section("geometry")), file.section("discretisation")),
            file.section("model").text("strains") == "linear" ? Strains::linear
                                                              : Strains::nonlinear,
            readMaterial(file),
            readSupports(file),
            readLoads(file),
            readTimeScheme(time),
            readTimeSteps(time),
            readNewton(file.section("newton")),
            readOutput(file.section("output"), directory),
            isCoupled ? std::optional(readCoupling(file.section("coupling"))) : std::nullopt};
}

} // namespace tokay::structure
