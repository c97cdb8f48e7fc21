// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/readCase.hpp"

#include "common/errors.hpp"
#include "igaStructure/case/readCoupling.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"
#include "igaStructure/kinematics/beam/readBeam.hpp"
#include "igaStructure/kinematics/plane/readPlaneSolid.hpp"
#include "igaStructure/kinematics/readGeometry.hpp"
#include "igaStructure/kinematics/shell/readShell.hpp"
#include "igaStructure/kinematics/solid/readSolid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>

namespace tokay::structure {

namespace {

StructureCase readStructure(const CaseSection& file, const std::string& directory) {
    const std::string kinematics = file.section("model").text("kinematics");
    if (kinematics == "shell" || kinematics == "membrane") {
        return readShell(file, directory);
    }
    if (kinematics == "solid") {
        return readSolid(file);
    }
    const CaseSection material = file.section("material");
    if (material.text("type") != "StVenantKirchhoff") {
        throw material.error("type", fmt::format("'{}' is a material of shells, membranes and "
                                                 "solids, not of {}",
                                                 material.text("type"), kinematics));
    }
    if (kinematics == "beam" || kinematics == "cable") {
        return readBeam(file);
    }
    return readPlaneSolid(file);
}

TimeIntegration readTimeScheme(const CaseSection& section) {
    const auto numberOr = [&](const char* name, double otherwise) {
        return section.has(name) ? section.number(name) : otherwise;
    };
    const std::string scheme = section.text("scheme");
    if (scheme == "static") {
        requireUsed(section, {"scheme", "step", "end", "smallestStep"}, "scheme static");
        return TimeScheme::quasiStatic();
    }
    if (scheme == "explicit") {
        requireUsed(section, {"scheme", "step", "end"}, "scheme explicit");
        return CentralDifferences{};
    }
    if (scheme == "arcLength") {
        requireUsed(section, {"scheme", "step", "end", "largestSteps"}, "scheme arcLength");
        EquilibriumPath path;
        if (section.has("largestSteps")) {
            path.maxSteps = section.integer("largestSteps");
        }
        return path;
    }
    if (scheme == "newmark") {
        requireUsed(section, {"scheme", "beta", "gamma", "step", "end", "smallestStep", "substeps"},
                    "scheme newmark");
        return TimeScheme::newmark(numberOr("beta", 0.25), numberOr("gamma", 0.5));
    }
    requireUsed(section, {"scheme", "spectralRadius", "step", "end", "smallestStep", "substeps"},
                "scheme generalisedAlpha");
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
    TimeSteps steps{section.number("step"), section.number("end"), section.number("step")};
    if (steps.end < steps.step) {
        throw section.error(
            "end", fmt::format("{} s is shorter than one step of {} s", steps.end, steps.step));
    }
    if (section.has("smallestStep")) {
        steps.smallestStep = section.number("smallestStep");
    }
    return steps;
}

NewtonOptions readNewton(const CaseSection& file) {
    const CaseSection section = file.section("newton");
    const std::string kinematics = file.section("model").text("kinematics");
    const bool isStatic = file.section("time").text("scheme") == "static";
    const bool bendsThinly = kinematics == "shell" || kinematics == "beam";
    return {section.number("tolerance"), section.integer("maximumIterations"),
            section.has("lineSearch") ? section.yesNo("lineSearch") : !bendsThinly,
            section.has("reuseContraction") ? section.number("reuseContraction")
            : isStatic                      ? 0
                                            : 0.1};
}

// The name becomes one of files and a folder, and stands in XML.
std::string readName(const CaseSection& file, const std::string& fileName) {
    const std::string name =
        file.has("name") ? file.text("name") : std::filesystem::path(fileName).stem().string();
    const bool isUsable = !name.empty() && name.front() != '.' &&
                          std::none_of(name.begin(), name.end(), [](unsigned char c) {
                              return std::iscntrl(c) || std::strchr("/\\<>&\"'", c);
                          });
    if (!isUsable) {
        throw file.error("name", fmt::format("'{}' cannot name results; take letters, digits, "
                                             "blanks, '-', '_' and '.', not '.' first",
                                             name));
    }
    return name;
}

// Names of columns: a table's columns are separated by white space.
WatchPoint readWatchPoint(const CaseSection& section, const std::vector<WatchPoint>& earlier) {
    WatchPoint point{section.text("name"), readCoordinates(section, "at")};
    const bool isUsable = !point.name.empty() &&
                          std::none_of(point.name.begin(), point.name.end(), [](unsigned char c) {
                              return std::iscntrl(c) || std::isspace(c) || std::strchr("#[]\"", c);
                          });
    if (!isUsable) {
        throw section.error("name", fmt::format("'{}' cannot name columns of a table; leave out "
                                                "white space, '#', '\"', '[' and ']'",
                                                point.name));
    }
    const bool isKnown = std::any_of(earlier.begin(), earlier.end(), [&](const WatchPoint& other) {
        return other.name == point.name;
    });
    if (isKnown) {
        throw section.error("name", fmt::format("'{}' is the name of two watch points; give each "
                                                "its own",
                                                point.name));
    }
    return point;
}

OutputOptions readOutput(const CaseSection& section, const std::string& directory) {
    OutputOptions output;
    output.directory = (std::filesystem::path(directory) / section.text("directory")).string();
    output.interval = section.integer("interval");
    if (section.has("fields")) {
        output.fields = section.words("fields");
    }
    output.cells = section.text("cells") == "bezier" ? CellShape::bezier : CellShape::quads;
    output.subdivision = section.integer("subdivision");
    for (const CaseSection& item : section.list("watchPoints")) {
        output.watchPoints.push_back(readWatchPoint(item, output.watchPoints));
    }
    return output;
}

// Of a NURBS its control points.
std::string geometryPlace(const CaseSection& geometry) {
    return geometry.has("nurbs") ? geometry.section("nurbs").error("controlPoints", "").what()
                                 : geometry.error(geometry.givenNames().front(), "").what();
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
    return {readName(file, fileName),
            fileName,
            directory,
            readStructure(file, directory),
            readTimeScheme(time),
            readTimeSteps(time),
            readNewton(file),
            readOutput(file.section("output"), directory),
            isCoupled ? std::optional(readCoupling(file)) : std::nullopt,
            file.error("supports", "").what(),
            geometryPlace(file.section("geometry")),
            file.section("geometry").digest() + file.section("discretisation").digest()};
}

} // namespace tokay::structure
