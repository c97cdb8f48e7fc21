// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/readGeometry.hpp"

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

namespace {

geometry::NurbsSurface readRectangle(const CaseSection& section) {
    const std::vector<double> origin = section.numbers("origin");
    const std::vector<double> size = section.numbers("size");
    return geometry::rectangle({origin[0], origin[1], 0}, size[0], size[1]);
}

geometry::NurbsSurface readNurbsSurface(const CaseSection& section) {
    const std::vector<int> degree = section.integers("degree", 2);
    section.require("knotsEta", "a surface has them");
    try {
        return {geometry::KnotVector(degree[0], section.numbers("knotsXi")),
                geometry::KnotVector(degree[1], section.numbers("knotsEta")),
                readControlPoints(section), readWeights(section)};
    } catch (const InputError& error) {
        throw section.error("", error.what());
    }
}

geometry::NurbsSurface refined(const geometry::NurbsSurface& coarse, const CaseSection& section) {
    const std::vector<int> degree = section.integers("degree", 2);
    const std::vector<int> elements = section.integers("elements", 2);
    if (degree[0] < coarse.u().degree() || degree[1] < coarse.v().degree()) {
        throw section.error("degree",
                            fmt::format("[{}, {}] is below the geometry's [{}, {}]", degree[0],
                                        degree[1], coarse.u().degree(), coarse.v().degree()));
    }
    return geometry::refine(coarse, degree[0], degree[1], elements[0], elements[1]);
}

std::string curveShape(const CaseSection& geometry) {
    return geometry.exactlyOne({"line", "arc", "nurbs"});
}

geometry::NurbsCurve readStraightLine(const CaseSection& section) {
    const geometry::Point from = readCoordinates(section, "from");
    const geometry::Point to = readCoordinates(section, "to");
    try {
        return geometry::line(from, to);
    } catch (const InputError& error) {
        throw section.error("to", error.what());
    }
}

geometry::NurbsCurve readArc(const CaseSection& section) {
    const geometry::Point centre = readCoordinates(section, "centre");
    const std::vector<double> angles = section.numbers("angles");
    constexpr double radians = M_PI / 180;
    try {
        return geometry::arc(centre, section.number("radius"), radians * angles[0],
                             radians * angles[1]);
    } catch (const InputError& error) {
        throw section.error("angles", error.what());
    }
}

geometry::NurbsCurve readNurbsCurve(const CaseSection& section) {
    requireUsed(section, {"degree", "knotsXi", "controlPoints", "weights"}, "a line");
    try {
        return {geometry::KnotVector(section.integers("degree", 1)[0], section.numbers("knotsXi")),
                readControlPoints(section), readWeights(section)};
    } catch (const InputError& error) {
        throw section.error("", error.what());
    }
}

geometry::NurbsCurve refined(const geometry::NurbsCurve& coarse, const CaseSection& section) {
    const int degree = section.integers("degree", 1)[0];
    if (degree < coarse.degree()) {
        throw section.error("degree",
                            fmt::format("{} is below the geometry's {}", degree, coarse.degree()));
    }
    return geometry::refine(coarse, degree, section.integers("elements", 1)[0]);
}

} // namespace

geometry::Points readControlPoints(const CaseSection& section) {
    const std::vector<std::vector<double>> rows = section.points("controlPoints");
    geometry::Points points = geometry::Points::Zero(rows.size(), 3);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (std::size_t c = 0; c < rows[k].size(); ++c) {
            points(k, c) = rows[k][c];
        }
    }
    return points;
}

Eigen::VectorXd readWeights(const CaseSection& section) {
    if (!section.has("weights")) {
        return {};
    }
    const std::vector<double> given = section.numbers("weights");
    return Eigen::Map<const Eigen::VectorXd>(given.data(), given.size());
}

geometry::NurbsCurve readCurve(const CaseSection& file) {
    const CaseSection section = file.section("geometry");
    const std::string shape = curveShape(section);
    const CaseSection given = section.section(shape);
    return refined(shape == "line"  ? readStraightLine(given)
                   : shape == "arc" ? readArc(given)
                                    : readNurbsCurve(given),
                   file.section("discretisation"));
}

int curveDimension(const CaseSection& file) {
    const CaseSection section = file.section("geometry");
    const std::string shape = curveShape(section);
    const CaseSection given = section.section(shape);
    std::vector<std::vector<double>> points;
    if (shape == "line") {
        points = {given.numbers("from"), given.numbers("to")};
    } else if (shape == "arc") {
        points = {given.numbers("centre")};
    } else {
        points = given.points("controlPoints");
    }
    const bool hasZ = std::any_of(points.begin(), points.end(),
                                  [](const auto& point) { return point.size() == 3; });
    return hasZ ? 3 : 2;
}

bool isSlit(const CaseSection& file) {
    return file.section("geometry").yesNo("slit");
}

geometry::Point readCoordinates(const CaseSection& section, const std::string& name) {
    const std::vector<double> given = section.numbers(name);
    if (given.size() != 2 && given.size() != 3) {
        throw section.error(
            name, fmt::format("must be [x, y] or [x, y, z], but has {} values", given.size()));
    }
    return {given[0], given[1], given.size() == 3 ? given[2] : 0};
}

geometry::NurbsSurface readUnrefinedSurface(const CaseSection& section) {
    return section.has("nurbs") ? readNurbsSurface(section.section("nurbs"))
                                : readRectangle(section.section("rectangle"));
}

geometry::NurbsSurface readSurface(const CaseSection& file) {
    const CaseSection section = file.section("geometry");
    section.exactlyOne({"rectangle", "nurbs"});
    return refined(readUnrefinedSurface(section), file.section("discretisation"));
}

} // namespace tokay::structure
