// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"
#include "geometry/spline/NurbsSurface.hpp"
#include "geometry/spline/NurbsVolume.hpp"

#include <string>

namespace tokay::structure {

/// Names of the edges of a patch and of the faces of a volume.
inline const Choices<geometry::Edge>& edgeChoices() {
    using geometry::Edge;
    static const Choices<Edge> choices = {
        {"left", Edge::left}, {"right", Edge::right}, {"bottom", Edge::bottom}, {"top", Edge::top}};
    return choices;
}

inline const Choices<geometry::Side>& faceChoices() {
    using geometry::Side;
    static const Choices<Side> choices = {{"left", Side::left},     {"right", Side::right},
                                          {"bottom", Side::bottom}, {"top", Side::top},
                                          {"back", Side::back},     {"front", Side::front}};
    return choices;
}

/// Meanings of entries that several kinematics have.
constexpr auto rectangleMeaning = "Axis-parallel rectangle in the plane z = 0; its edges are left, "
                                  "right, bottom and top.";
constexpr auto plateMeaning = "Flat parallelogram in space; left and right are its first and last "
                              "xi, bottom and top its first and last eta.";
constexpr auto cylinderMeaning = "Part of a cylinder about an axis along z; xi runs along the "
                                 "angle, eta along z, the normal points outwards.";
constexpr auto nurbsSurfaceMeaning =
    "NURBS patch; left and right are its first and last xi, bottom "
    "and top its first and last eta.";
constexpr auto fixMeaning = "Displacement components that are zero there.";

/// Entry `geometry.slit`.
template <class Geometry>
SchemaOf<Geometry> slitSchema() {
    return {{"slit", &Geometry::isSlit,
             "Whether edges or faces that coincide stay open. no: they are joined, opposite ones "
             "of a body that is closed in itself (a pipe, a ring) and those of different patches, "
             "even if a cad.json does not share them. yes: only edges that a cad.json shares are "
             "joined."}};
}

/// The sections of a case file that describe a body.
/// @param loads  which entries an item of `loads` may combine
template <class Entries>
SchemaOf<Entries> bodySchema(const std::string& loads) {
    return {
        {"geometry", &Entries::geometry,
         "The body in its reference configuration: exactly one shape.", required},
        {"discretisation", &Entries::discretisation,
         "Basis of the displacement: the geometry's own, refined.", required},
        {"model", &Entries::model, "Mechanical model.", required},
        {"material", &Entries::material, "Material.", required},
        {"supports", &Entries::supports, "Supports; an empty list leaves the body free.", required},
        {"loads", &Entries::loads, "Loads besides those of a fluid; " + loads + ".",
         otherwise("`[]`")},
        {"coupling", &Entries::coupling,
         "Coupling to a fluid or another structure; ignored in a run alone.", otherwise("none")}};
}

} // namespace tokay::structure
