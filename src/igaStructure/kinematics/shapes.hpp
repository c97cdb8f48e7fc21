// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "geometry/spline/NurbsCurve.hpp"
#include "geometry/spline/NurbsSurface.hpp"
#include "geometry/spline/NurbsVolume.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tokay::structure {

/// Entries of `geometry` in the case file: each shape has its own, and makes the
/// curve, surface or volume. These throw InputError, with the location, if the
/// entries describe none.

/// Of surfaces, curves and discretisations, in files as in the case file:
/// KnotVector::maxDegree.
constexpr const char* degreeRange = "[1, 24]";
static_assert(geometry::KnotVector::maxDegree == 24);

struct RectangleShape : Located {
    std::array<double, 2> origin = {0, 0};
    std::array<double, 2> size = {1, 1};

    geometry::NurbsSurface surface() const;

    static const SchemaOf<RectangleShape>& schema() {
        static const SchemaOf<RectangleShape> schema = {
            {"origin", &RectangleShape::origin, "", "m", "Lower left corner.", required},
            {"size", &RectangleShape::size, "(0, inf)", "m", "Extent along x and y.", required}};
        return schema;
    }
};

struct LineShape : Located {
    Coordinates from;
    Coordinates to;

    geometry::NurbsCurve curve() const;
    bool isSpatial() const { return from.isSpatial || to.isSpatial; }

    static const SchemaOf<LineShape>& schema() {
        static const SchemaOf<LineShape> schema = {
            {"from", &LineShape::from, "", "m",
             "Start point; a z coordinate, even 0, puts the line in space.", required},
            {"to", &LineShape::to, "", "m", "End point, likewise.", required}};
        return schema;
    }
};

struct ArcShape : Located {
    Coordinates centre;
    double radius = 1;
    std::array<double, 2> angles = {0, 90};

    geometry::NurbsCurve curve() const;
    bool isSpatial() const { return centre.isSpatial; }

    static const SchemaOf<ArcShape>& schema() {
        static const SchemaOf<ArcShape> schema = {
            {"centre", &ArcShape::centre, "", "m",
             "Centre of the circle; a z coordinate, even 0, puts the arc in space.", required},
            {"radius", &ArcShape::radius, "(0, inf)", "m", "Radius.", required},
            {"angles", &ArcShape::angles, "", "degrees",
             "Start and end angle, counter-clockwise from the x axis, in ascending order.",
             required}};
        return schema;
    }
};

struct PlateShape : Located {
    std::array<double, 3> origin = {0, 0, 0};
    std::array<double, 3> edgeXi = {1, 0, 0};
    std::array<double, 3> edgeEta = {0, 1, 0};

    geometry::NurbsSurface surface() const;

    static const SchemaOf<PlateShape>& schema() {
        static const SchemaOf<PlateShape> schema = {
            {"origin", &PlateShape::origin, "", "m", "Corner at which both edges start.", required},
            {"edgeXi", &PlateShape::edgeXi, "", "m", "Edge vector along xi.", required},
            {"edgeEta", &PlateShape::edgeEta, "", "m", "Edge vector along eta.", required}};
        return schema;
    }
};

struct CylinderShape : Located {
    std::array<double, 3> base = {0, 0, 0};
    double radius = 1;
    double height = 1;
    std::array<double, 2> angles = {0, 90};

    geometry::NurbsSurface surface() const;

    static const SchemaOf<CylinderShape>& schema() {
        static const SchemaOf<CylinderShape> schema = {
            {"base", &CylinderShape::base, "", "m", "Lower end of the axis.", required},
            {"radius", &CylinderShape::radius, "(0, inf)", "m", "Radius.", required},
            {"height", &CylinderShape::height, "(0, inf)", "m", "Height.", required},
            {"angles", &CylinderShape::angles, "", "degrees",
             "Start and end angle, counter-clockwise from the x axis, in ascending order.",
             required}};
        return schema;
    }
};

struct BlockShape : Located {
    std::array<double, 3> origin = {0, 0, 0};
    std::array<double, 3> size = {1, 1, 1};

    geometry::NurbsVolume volume() const;

    static const SchemaOf<BlockShape>& schema() {
        static const SchemaOf<BlockShape> schema = {
            {"origin", &BlockShape::origin, "", "m", "Corner with the least coordinates.",
             required},
            {"size", &BlockShape::size, "(0, inf)", "m", "Extent along x, y and z.", required}};
        return schema;
    }
};

/// Control points, knots and weights of a curve, surface or volume.
struct NurbsShape : Located {
    std::vector<int> degree;
    std::vector<double> knotsXi;
    std::vector<double> knotsEta;
    std::optional<std::vector<double>> knotsZeta;
    std::vector<Coordinates> controlPoints;
    std::optional<std::vector<double>> weights;

    geometry::NurbsCurve curve() const;
    geometry::NurbsSurface surface() const;
    geometry::NurbsVolume volume() const;
    bool isSpatial() const;
    bool isVolume() const { return knotsZeta.has_value(); }

  private:
    geometry::Points points() const;
    Eigen::VectorXd weightVector() const;
    void requireDegrees(std::size_t count) const;
};

struct NurbsCurveShape : NurbsShape {
    static const SchemaOf<NurbsCurveShape>& schema();
};
struct NurbsSurfaceShape : NurbsShape {
    static const SchemaOf<NurbsSurfaceShape>& schema();
};
/// A volume, or the middle surface of one.
struct NurbsSolidShape : NurbsShape {
    static const SchemaOf<NurbsSolidShape>& schema();
};

/// Entries of `discretisation`.
template <std::size_t nParameters>
struct Discretisation : Located {
    std::array<int, nParameters> degree = {};
    std::array<int, nParameters> elements = {};

    static const SchemaOf<Discretisation>& schema() {
        static const std::string along = nParameters == 1   ? "xi"
                                         : nParameters == 2 ? "xi and eta"
                                                            : "xi, eta and zeta";
        static const SchemaOf<Discretisation> schema = {
            {"degree", &Discretisation::degree, degreeRange, "",
             "Polynomial degree along " + along + ", at least the geometry's.", required},
            {"elements", &Discretisation::elements, "[1, 100000]", "",
             "Number of elements per knot span of the geometry along " + along + ".", required}};
        return schema;
    }
};

/// Curve, surface or volume in the basis of the displacement.
geometry::NurbsCurve refined(const geometry::NurbsCurve& coarse, const Discretisation<1>& basis);
geometry::NurbsSurface refined(const geometry::NurbsSurface& coarse,
                               const Discretisation<2>& basis);
geometry::NurbsVolume refined(const geometry::NurbsVolume& coarse, const Discretisation<3>& basis);

} // namespace tokay::structure
