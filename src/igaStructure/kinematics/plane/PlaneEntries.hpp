// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/CaseContext.hpp"
#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/ModelEntries.hpp"
#include "igaStructure/kinematics/bodySchema.hpp"
#include "igaStructure/kinematics/plane/PlaneSolidCase.hpp"
#include "igaStructure/kinematics/shapes.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// Entries of `geometry` of a plane solid.
struct PlaneGeometry : Located {
    bool isSlit = false;
    std::optional<RectangleShape> rectangle;
    std::optional<NurbsSurfaceShape> nurbs;

    static const SchemaOf<PlaneGeometry>& schema() {
        static const SchemaOf<PlaneGeometry> schema =
            SchemaOf<PlaneGeometry>{{"rectangle", &PlaneGeometry::rectangle, rectangleMeaning},
                                    {"nurbs", &PlaneGeometry::nurbs, nurbsSurfaceMeaning}}
                .exactlyOne()
                .with(slitSchema<PlaneGeometry>());
        return schema;
    }
};

/// Entries of `model` with planeStrain, and with planeStress.
struct PlaneStrainModel : ModelEntries {
    double thickness = 1;

    static const SchemaOf<PlaneStrainModel>& schema() {
        static const SchemaOf<PlaneStrainModel> schema =
            SchemaOf<PlaneStrainModel>().with(ModelEntries::schema());
        return schema;
    }
};
struct PlaneStressModel : PlaneStrainModel {
    static const SchemaOf<PlaneStressModel>& schema() {
        static const SchemaOf<PlaneStressModel> schema =
            SchemaOf<PlaneStressModel>()
                .with(PlaneStrainModel::schema())
                .with(SchemaOf<PlaneStressModel>{thicknessEntry<PlaneStressModel>("plate")});
        return schema;
    }
};

/// An item of `supports`.
struct PlaneSupport : Located {
    geometry::Edge edge = geometry::Edge::left;
    std::vector<Fixed> fix;
    std::optional<std::array<Formula, 2>> displacement;

    static const SchemaOf<PlaneSupport>& schema() {
        static const SchemaOf<PlaneSupport> schema = {
            {"edge", &PlaneSupport::edge, edgeChoices(), "Constrained edge.", required},
            {"fix", &PlaneSupport::fix, planeComponents(), fixMeaning, required},
            {"displacement", &PlaneSupport::displacement, "", "m", supportDisplacementMeaning,
             otherwise("`0`")}};
        return schema;
    }
};

/// An item of `loads`.
struct PlaneLoad : Located {
    std::optional<geometry::Edge> edge;
    std::optional<std::array<Formula, 2>> traction;
    std::optional<std::array<Formula, 2>> gravity;

    static const SchemaOf<PlaneLoad>& schema() {
        static const SchemaOf<PlaneLoad> schema = {
            {"edge", &PlaneLoad::edge, edgeChoices(), "Edge on which the traction acts."},
            {"traction", &PlaneLoad::traction, "", "Pa",
             "Force per reference area along x and y; keeps its direction as the body deforms."},
            {"gravity", &PlaneLoad::gravity, "", "m/s^2",
             "Acceleration along x and y that acts on the mass."}};
        return schema;
    }
};

/// Entries of a case file that describe a plane solid.
template <class Model>
struct PlaneEntries : Located {
    PlaneGeometry geometry;
    Discretisation<2> discretisation;
    Model model;
    MaterialEntries<Laws::linear> material;
    std::vector<PlaneSupport> supports;
    std::vector<PlaneLoad> loads;
    CouplingEntries<WetParts::edges> coupling;

    static const SchemaOf<PlaneEntries>& schema() {
        static const SchemaOf<PlaneEntries> schema =
            bodySchema<PlaneEntries>("each has either edge and traction, or gravity");
        return schema;
    }
};

/// @throws InputError for entries that do not fit each other
PlaneSolidCase makePlaneStrain(const PlaneEntries<PlaneStrainModel>& entries, const CaseContext&);
PlaneSolidCase makePlaneStress(const PlaneEntries<PlaneStressModel>& entries, const CaseContext&);

} // namespace tokay::structure
