// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/CaseContext.hpp"
#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/ModelEntries.hpp"
#include "igaStructure/kinematics/bodySchema.hpp"
#include "igaStructure/kinematics/shapes.hpp"
#include "igaStructure/kinematics/solid/SolidDescription.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// Entries of `geometry` of a solid: a volume, or its middle surface.
struct SolidGeometry : Located {
    bool isSlit = false;
    std::optional<BlockShape> block;
    std::optional<RectangleShape> rectangle;
    std::optional<PlateShape> plate;
    std::optional<CylinderShape> cylinder;
    std::optional<NurbsSolidShape> nurbs;

    bool isVolume() const { return block || (nurbs && nurbs->isVolume()); }
    geometry::NurbsVolume volume() const;
    geometry::NurbsVolume thickened(double thickness) const;

    static const SchemaOf<SolidGeometry>& schema() {
        static const SchemaOf<SolidGeometry> schema =
            SchemaOf<SolidGeometry>{
                {"block", &SolidGeometry::block,
                 "Axis-parallel box; left and right are its first and last x, bottom and top its "
                 "first and last y, back and front its first and last z."},
                {"rectangle", &SolidGeometry::rectangle, rectangleMeaning},
                {"plate", &SolidGeometry::plate, plateMeaning},
                {"cylinder", &SolidGeometry::cylinder, cylinderMeaning},
                {"nurbs", &SolidGeometry::nurbs,
                 "NURBS volume; left and right are its first and last xi, bottom and top its first "
                 "and last eta, back and front its first and last zeta. Or a patch, which is the "
                 "middle surface; zeta is then along the normal."}}
                .exactlyOne()
                .with(slitSchema<SolidGeometry>());
        return schema;
    }
};

/// Entries of `model`.
struct SolidModel : ModelEntries {
    std::optional<double> thickness;

    static const SchemaOf<SolidModel>& schema() {
        static const SchemaOf<SolidModel> schema =
            SchemaOf<SolidModel>()
                .with(ModelEntries::schema())
                .with(SchemaOf<SolidModel>{
                    {"thickness", &SolidModel::thickness, "(0, inf)", "m",
                     "Thickness of a solid that is given by its middle surface.",
                     otherwise("required with a middle surface")}});
        return schema;
    }
};

/// An item of `supports`.
struct SolidSupportEntries : Located {
    std::vector<geometry::Side> faces;
    std::vector<Fixed> fix;
    std::optional<std::array<Formula, 3>> displacement;

    static const SchemaOf<SolidSupportEntries>& schema() {
        static const SchemaOf<SolidSupportEntries> schema = {
            {"faces", &SolidSupportEntries::faces, faceChoices(),
             "Constrained face; of two faces their common edge, of three their corner.", required},
            {"fix", &SolidSupportEntries::fix, spatialComponents(), fixMeaning, required},
            {"displacement", &SolidSupportEntries::displacement, "", "m",
             supportDisplacementMeaning, otherwise("`0`")}};
        return schema;
    }
};

/// An item of `loads`.
struct SolidLoad : Located {
    std::optional<geometry::Side> face;
    std::optional<std::array<Formula, 3>> traction;
    std::optional<Formula> pressure;
    std::optional<std::array<Formula, 3>> gravity;

    static const SchemaOf<SolidLoad>& schema() {
        static const SchemaOf<SolidLoad> schema = {
            {"face", &SolidLoad::face, faceChoices(), "Face on which traction or pressure act."},
            {"traction", &SolidLoad::traction, "", "Pa",
             "Force per reference area along x, y and z; keeps its direction as the body deforms."},
            {"pressure", &SolidLoad::pressure, "", "Pa",
             "Pressure on the face, on its current area and against its current normal."},
            {"gravity", &SolidLoad::gravity, "", "m/s^2",
             "Acceleration along x, y and z that acts on the mass."}};
        return schema;
    }
};

/// Entries of a case file that describe a solid.
struct SolidEntries : Located {
    SolidGeometry geometry;
    Discretisation<3> discretisation;
    SolidModel model;
    MaterialEntries<Laws::compressible> material;
    std::vector<SolidSupportEntries> supports;
    std::vector<SolidLoad> loads;
    CouplingEntries<WetParts::faces> coupling;

    static const SchemaOf<SolidEntries>& schema() {
        static const SchemaOf<SolidEntries> schema =
            bodySchema<SolidEntries>("each has either face and traction or pressure, or gravity");
        return schema;
    }
};

/// @throws InputError for entries that do not fit each other
SolidDescription makeSolid(const SolidEntries& entries, const CaseContext&);

} // namespace tokay::structure
