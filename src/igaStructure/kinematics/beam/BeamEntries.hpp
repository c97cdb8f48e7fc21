// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/CaseContext.hpp"
#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/ModelEntries.hpp"
#include "igaStructure/kinematics/beam/BeamDescription.hpp"
#include "igaStructure/kinematics/bodySchema.hpp"
#include "igaStructure/kinematics/shapes.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// Entries of `geometry` of a beam or cable.
struct CurveGeometry : Located {
    bool isSlit = false;
    std::optional<LineShape> line;
    std::optional<ArcShape> arc;
    std::optional<NurbsCurveShape> nurbs;

    geometry::NurbsCurve curve() const {
        return line ? line->curve() : arc ? arc->curve() : nurbs->curve();
    }
    /// 3 if a point of the curve has a z, be it 0; else 2.
    int dimension() const {
        const bool isSpatial = line  ? line->isSpatial()
                               : arc ? arc->isSpatial()
                                     : nurbs->isSpatial();
        return isSpatial ? 3 : 2;
    }

    static const SchemaOf<CurveGeometry>& schema() {
        static const SchemaOf<CurveGeometry> schema =
            SchemaOf<CurveGeometry>{
                {"line", &CurveGeometry::line, "Straight axis."},
                {"arc", &CurveGeometry::arc,
                 "Circular axis parallel to the plane of x and y; of a beam, in the plane and at "
                 "most a quarter of a circle."},
                {"nurbs", &CurveGeometry::nurbs,
                 "NURBS curve; a z coordinate of a control point, even 0, puts it in space."}}
                .exactlyOne()
                .with(slitSchema<CurveGeometry>());
        return schema;
    }
};

/// Strain of the section across the plane.
enum class SectionStrain { planeStrain, planeStress };

inline const Choices<SectionStrain>& sectionStrains() {
    static const Choices<SectionStrain> choices = {
        {"planeStrain", SectionStrain::planeStrain,
         "none, modulus E/(1 - nu^2) (a strip of a wide plate)."},
        {"planeStress", SectionStrain::planeStress,
         "free, modulus E (a rod; the only one in space)."}};
    return choices;
}

/// Entries of `model` of a beam or cable.
struct CurveModel : ModelEntries {
    double thickness = 0;
    std::optional<double> width;
    std::optional<SectionStrain> section;

    static SchemaOf<CurveModel> schema(bool bends) {
        return SchemaOf<CurveModel>()
            .with(ModelEntries::schema())
            .with(SchemaOf<CurveModel>{
                {"thickness", &CurveModel::thickness, "(0, inf)", "m",
                 "Thickness of the section in the plane.", required},
                {"width", &CurveModel::width, "(0, inf)", "m",
                 std::string("Width of the rectangular section across the plane, on which forces "
                             "per unit depth act.") +
                     (bends ? " A beam in space has a square section." : ""),
                 otherwise("`1`; in space the thickness")},
                {"section", &CurveModel::section, sectionStrains(),
                 "Strain of the section across the plane.",
                 otherwise(bends ? "`planeStrain`; in space `planeStress`" : "`planeStress`")}});
    }
};
struct BeamModel : CurveModel {
    bool rotaryInertia = false;

    static const SchemaOf<BeamModel>& schema() {
        static const SchemaOf<BeamModel> schema =
            SchemaOf<BeamModel>()
                .with(CurveModel::schema(true))
                .with(SchemaOf<BeamModel>{
                    {"rotaryInertia", &BeamModel::rotaryInertia,
                     "Whether the section's rotary inertia counts (linear strains)."}});
        return schema;
    }
};
struct CableModel : CurveModel {
    std::optional<double> prestress;

    static const SchemaOf<CableModel>& schema() {
        static const SchemaOf<CableModel> schema =
            SchemaOf<CableModel>()
                .with(CurveModel::schema(false))
                .with(SchemaOf<CableModel>{
                    {"prestress", &CableModel::prestress, "", "Pa",
                     "Axial stress in the reference configuration, tension positive.",
                     otherwise("`0`; required with linear strains")}});
        return schema;
    }
};

inline const Choices<BeamEnd>& endChoices() {
    static const Choices<BeamEnd> choices = {{"start", BeamEnd::start}, {"end", BeamEnd::end}};
    return choices;
}

/// An item of `supports` of a beam.
struct BeamSupportEntries : Located {
    BeamEnd end = BeamEnd::start;
    std::vector<Fixed> fix;
    std::optional<std::vector<Formula>> displacement;

    static const SchemaOf<BeamSupportEntries>& schema() {
        static const SchemaOf<BeamSupportEntries> schema = {
            {"end", &BeamSupportEntries::end, endChoices(), "Constrained end.", required},
            {"fix", &BeamSupportEntries::fix, componentsAndRotation(),
             "Displacement components, and rotation of the section (in space about both axes "
             "across the beam), that are zero there.",
             required},
            {"displacement", &BeamSupportEntries::displacement, "", "m", supportDisplacementMeaning,
             otherwise("`0`")}};
        return schema;
    }
};
/// An item of `supports` of a cable.
struct CableSupportEntries : BeamSupportEntries {
    static const SchemaOf<CableSupportEntries>& schema() {
        static const SchemaOf<CableSupportEntries> schema = {
            {"end", &CableSupportEntries::end, endChoices(), "Constrained end.", required},
            {"fix", &CableSupportEntries::fix, spatialComponents(), fixMeaning, required},
            {"displacement", &CableSupportEntries::displacement, "", "m",
             supportDisplacementMeaning, otherwise("`0`")}};
        return schema;
    }
};

/// An item of `loads` of a cable.
struct CableLoadEntries : Located {
    std::optional<BeamEnd> end;
    std::optional<std::vector<Formula>> force;
    std::optional<Formula> moment; ///< of a beam
    std::optional<std::vector<Formula>> traction;
    std::optional<std::vector<Formula>> gravity;
    std::optional<Formula> pressure;

    static const SchemaOf<CableLoadEntries>& schema() {
        static const SchemaOf<CableLoadEntries> schema = {
            {"end", &CableLoadEntries::end, endChoices(), "End on which force or moment act."},
            {"force", &CableLoadEntries::force, "", "N",
             "Force along x and y (in space: and z) on the whole width; keeps its direction."},
            {"traction", &CableLoadEntries::traction, "", "Pa",
             "Force per reference area along x and y (in space: and z), all along the axis; keeps "
             "its direction."},
            {"gravity", &CableLoadEntries::gravity, "", "m/s^2",
             "Acceleration along x and y (in space: and z) that acts on the mass."},
            {"pressure", &CableLoadEntries::pressure, "", "Pa",
             "Pressure on the left side, seen along the axis, in the plane; stays normal to the "
             "axis and acts on the current length (linear strains: on the reference)."}};
        return schema;
    }
};
/// An item of `loads` of a beam.
struct BeamLoadEntries : CableLoadEntries {
    static const SchemaOf<BeamLoadEntries>& schema() {
        static const SchemaOf<BeamLoadEntries> schema =
            SchemaOf<BeamLoadEntries>()
                .with(CableLoadEntries::schema())
                .with(SchemaOf<BeamLoadEntries>{
                    {"moment", &BeamLoadEntries::moment, "", "N m",
                     "Moment at the end of a beam in the plane, counter-clockwise, on the whole "
                     "width."}});
        return schema;
    }
};

/// Entries of a case file that describe a beam or cable.
template <class Model, class Support, class Load>
struct CurveEntries : Located {
    CurveGeometry geometry;
    Discretisation<1> discretisation;
    Model model;
    MaterialEntries<Laws::linear> material;
    std::vector<Support> supports;
    std::vector<Load> loads;
    CouplingEntries<WetParts::all> coupling;

    static const SchemaOf<CurveEntries>& schema() {
        static const SchemaOf<CurveEntries> schema = bodySchema<CurveEntries>(
            "each has end with force or moment, or traction, or gravity, or pressure");
        return schema;
    }
};
using BeamEntries = CurveEntries<BeamModel, BeamSupportEntries, BeamLoadEntries>;
using CableEntries = CurveEntries<CableModel, CableSupportEntries, CableLoadEntries>;

/// @throws InputError for entries that do not fit each other
BeamDescription makeBeam(const BeamEntries& entries, const CaseContext& context);
BeamDescription makeCable(const CableEntries& entries, const CaseContext& context);

} // namespace tokay::structure
