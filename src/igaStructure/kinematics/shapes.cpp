// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shapes.hpp"

#include "geometry/primitives/primitives.hpp"
#include "geometry/primitives/volumePrimitives.hpp"
#include "geometry/spline/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

namespace {

constexpr double radians = M_PI / 180;

geometry::Point point(const std::array<double, 3>& x) {
    return {x[0], x[1], x[2]};
}

// Rows that all NURBS shapes share.
template <class Shape>
SchemaOf<Shape> nurbsSchema(std::initializer_list<EntryOf<Shape>> knots) {
    return SchemaOf<Shape>{
        {"degree", &Shape::degree, degreeRange, "", "Polynomial degree along each parameter.",
         required},
        {"knotsXi", &Shape::knotsXi, "", "", "Open knot vector along xi.", required}}
        .with(SchemaOf<Shape>(knots))
        .with(SchemaOf<Shape>{{"controlPoints", &Shape::controlPoints, "", "m",
                               "Control points, xi running fastest, then eta; z is 0 if not given.",
                               required},
                              {"weights", &Shape::weights, "(0, inf)", "",
                               "Weights, one per control point.", otherwise("all 1")}});
}

template <class Shape>
EntryOf<Shape> etaEntry() {
    return {"knotsEta", &Shape::knotsEta, "", "", "Open knot vector along eta.", required};
}

} // namespace

geometry::NurbsSurface RectangleShape::surface() const {
    return at("", [&] { return geometry::rectangle({origin[0], origin[1], 0}, size[0], size[1]); });
}

geometry::NurbsCurve LineShape::curve() const {
    return at("to", [&] { return geometry::line(point(from.at), point(to.at)); });
}

geometry::NurbsCurve ArcShape::curve() const {
    return at("angles", [&] {
        return geometry::arc(point(centre.at), radius, radians * angles[0], radians * angles[1]);
    });
}

geometry::NurbsSurface PlateShape::surface() const {
    return at("", [&] { return geometry::plate(point(origin), point(edgeXi), point(edgeEta)); });
}

geometry::NurbsSurface CylinderShape::surface() const {
    return at("", [&] {
        return geometry::cylinderPatch(point(base), radius, height, radians * angles[0],
                                       radians * angles[1]);
    });
}

geometry::NurbsVolume BlockShape::volume() const {
    return at("", [&] { return geometry::block(point(origin), point(size)); });
}

geometry::NurbsCurve NurbsShape::curve() const {
    requireDegrees(1);
    return at("", [&]() -> geometry::NurbsCurve {
        return {geometry::KnotVector(degree[0], knotsXi), points(), weightVector()};
    });
}

geometry::NurbsSurface NurbsShape::surface() const {
    requireDegrees(2);
    return at("", [&]() -> geometry::NurbsSurface {
        return {geometry::KnotVector(degree[0], knotsXi), geometry::KnotVector(degree[1], knotsEta),
                points(), weightVector()};
    });
}

geometry::NurbsVolume NurbsShape::volume() const {
    requireDegrees(3);
    return at("", [&]() -> geometry::NurbsVolume {
        return {geometry::KnotVector(degree[0], knotsXi), geometry::KnotVector(degree[1], knotsEta),
                geometry::KnotVector(degree[2], *knotsZeta), points(), weightVector()};
    });
}

bool NurbsShape::isSpatial() const {
    return std::any_of(controlPoints.begin(), controlPoints.end(),
                       [](const Coordinates& point) { return point.isSpatial; });
}

geometry::Points NurbsShape::points() const {
    geometry::Points all(controlPoints.size(), 3);
    for (std::size_t k = 0; k < controlPoints.size(); ++k) {
        all.row(k) = point(controlPoints[k].at).transpose();
    }
    return all;
}

Eigen::VectorXd NurbsShape::weightVector() const {
    return weights ? Eigen::VectorXd(
                         Eigen::Map<const Eigen::VectorXd>(weights->data(), weights->size()))
                   : Eigen::VectorXd();
}

void NurbsShape::requireDegrees(std::size_t count) const {
    if (degree.size() != count) {
        throw error("degree", fmt::format("must have {} value{} here, but has {}", count,
                                          count == 1 ? "" : "s", degree.size()));
    }
}

const SchemaOf<NurbsCurveShape>& NurbsCurveShape::schema() {
    static const SchemaOf<NurbsCurveShape> schema = nurbsSchema<NurbsCurveShape>({});
    return schema;
}

const SchemaOf<NurbsSurfaceShape>& NurbsSurfaceShape::schema() {
    static const SchemaOf<NurbsSurfaceShape> schema =
        nurbsSchema<NurbsSurfaceShape>({etaEntry<NurbsSurfaceShape>()});
    return schema;
}

const SchemaOf<NurbsSolidShape>& NurbsSolidShape::schema() {
    static const SchemaOf<NurbsSolidShape> schema =
        nurbsSchema<NurbsSolidShape>({etaEntry<NurbsSolidShape>(),
                                      {"knotsZeta", &NurbsSolidShape::knotsZeta, "", "",
                                       "Open knot vector along zeta of a volume.",
                                       otherwise("none: the shape is the middle surface")}});
    return schema;
}

geometry::NurbsCurve refined(const geometry::NurbsCurve& coarse, const Discretisation<1>& basis) {
    if (basis.degree[0] < coarse.degree()) {
        throw basis.error("degree", fmt::format("{} is below the geometry's {}", basis.degree[0],
                                                coarse.degree()));
    }
    return geometry::refine(coarse, basis.degree[0], basis.elements[0]);
}

geometry::NurbsSurface refined(const geometry::NurbsSurface& coarse,
                               const Discretisation<2>& basis) {
    const auto [p, q] = basis.degree;
    if (p < coarse.u().degree() || q < coarse.v().degree()) {
        throw basis.error("degree", fmt::format("[{}, {}] is below the geometry's [{}, {}]", p, q,
                                                coarse.u().degree(), coarse.v().degree()));
    }
    return geometry::refine(coarse, p, q, basis.elements[0], basis.elements[1]);
}

geometry::NurbsVolume refined(const geometry::NurbsVolume& coarse, const Discretisation<3>& basis) {
    return basis.at("degree",
                    [&] { return geometry::refine(coarse, basis.degree, basis.elements); });
}

} // namespace tokay::structure
