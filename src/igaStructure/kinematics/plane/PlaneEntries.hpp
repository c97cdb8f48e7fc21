// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/CaseContext.hpp"
#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/ModelEntries.hpp"
#include "igaStructure/kinematics/bodySchema.hpp"
#include "igaStructure/kinematics/plane/PlaneSolidCase.hpp"
#include "igaStructure/kinematics/shapes.hpp"
#include "igaStructure/kinematics/shell/ShellEntries.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace tokay::structure {

/// Entries of `geometry` of a plane solid.
struct PlaneGeometry : Located {
    bool isSlit = false;
    std::optional<RectangleShape> rectangle;
    std::optional<NurbsSurfaceShape> nurbs;
    std::optional<std::string> cadJson;
    std::optional<double> tolerance;

    static const SchemaOf<PlaneGeometry>& schema() {
        static const SchemaOf<PlaneGeometry> schema =
            SchemaOf<PlaneGeometry>{{"rectangle", &PlaneGeometry::rectangle, rectangleMeaning},
                                    {"nurbs", &PlaneGeometry::nurbs, nurbsSurfaceMeaning},
                                    {"cadJson", &PlaneGeometry::cadJson,
                                     "File of trimmed patches in the plane z = 0 and of their "
                                     "edges, as of a shell."}}
                .exactlyOne()
                .with(slitSchema<PlaneGeometry>())
                .with(SchemaOf<PlaneGeometry>{{"tolerance", &PlaneGeometry::tolerance, "(0, inf)",
                                               "m", "cadJson: as of a shell.",
                                               otherwise("as of a shell")}});
        return schema;
    }
};

/// Entries of `model` with planeStrain, and with planeStress.
struct PlaneStrainModel : ModelEntries {
    double thickness = 1;
    std::optional<EdgeMethod> edgeMethod;
    std::optional<double> penalty;
    std::optional<SliverTreatment> sliverTreatment;

    static const SchemaOf<PlaneStrainModel>& schema() {
        static const SchemaOf<PlaneStrainModel> schema =
            SchemaOf<PlaneStrainModel>()
                .with(ModelEntries::schema())
                .with(SchemaOf<PlaneStrainModel>{
                    {"edgeMethod", &PlaneStrainModel::edgeMethod, edgeMethods(),
                     "cadJson: how patches are joined, and edges supported, where the basis "
                     "cannot do it exactly.",
                     otherwise("`penalty` if the entry penalty is given, with scheme explicit, and "
                               "with nonlinear strains; else `nitsche`")},
                    {"penalty", &PlaneStrainModel::penalty, "(0, inf)", "",
                     "cadJson: as of a membrane.", otherwise("as of a membrane")},
                    {"sliverTreatment", &PlaneStrainModel::sliverTreatment, sliverTreatments(),
                     "cadJson: treatment of cut elements of which trimming leaves less than a "
                     "fifth.",
                     otherwise("`extension`; with scheme explicit, which excludes it, "
                               "`scaling`")}});
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
    std::optional<geometry::Edge> edge;
    std::optional<std::string> brepEdge;
    std::vector<Fixed> fix;
    std::optional<std::array<Formula, 2>> displacement;
    std::optional<bool> weak;

    static const SchemaOf<PlaneSupport>& schema() {
        static const SchemaOf<PlaneSupport> schema = {
            {"edge", &PlaneSupport::edge, edgeChoices(), "Constrained edge of a single patch."},
            {"brepEdge", &PlaneSupport::brepEdge, "cadJson: name of the constrained edge."},
            {"fix", &PlaneSupport::fix, planeComponents(), fixMeaning, required},
            {"displacement", &PlaneSupport::displacement, "", "m", supportDisplacementMeaning,
             otherwise("`0`")},
            {"weak", &PlaneSupport::weak,
             "cadJson: whether an edge is supported weakly even where the basis could do it "
             "exactly.",
             otherwise("`no`")}};
        return schema;
    }
};

/// An item of `loads`.
struct PlaneLoad : Located {
    std::optional<geometry::Edge> edge;
    std::optional<std::string> brepEdge;
    std::optional<std::array<Formula, 2>> traction;
    std::optional<std::array<Formula, 2>> gravity;

    static const SchemaOf<PlaneLoad>& schema() {
        static const SchemaOf<PlaneLoad> schema = {
            {"edge", &PlaneLoad::edge, edgeChoices(), "Edge on which the traction acts."},
            {"brepEdge", &PlaneLoad::brepEdge,
             "cadJson: name of the edge on which the traction acts."},
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

/// One patch that is not trimmed, or a model of trimmed ones.
using PlaneCase = std::variant<PlaneSolidCase, PlanePatchesCase>;

/// @throws InputError for entries that do not fit each other
PlaneCase makePlaneStrain(const PlaneEntries<PlaneStrainModel>& entries,
                          const CaseContext& context);
PlaneCase makePlaneStress(const PlaneEntries<PlaneStressModel>& entries,
                          const CaseContext& context);

} // namespace tokay::structure
