// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/kinematics/CaseContext.hpp"
#include "igaStructure/kinematics/Coupling.hpp"
#include "igaStructure/kinematics/ModelEntries.hpp"
#include "igaStructure/kinematics/bodySchema.hpp"
#include "igaStructure/kinematics/shapes.hpp"
#include "igaStructure/kinematics/shell/element/ShellDescription.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// Entries of `geometry` of a shell or membrane.
struct ShellGeometry : Located {
    bool isSlit = false;
    std::optional<RectangleShape> rectangle;
    std::optional<PlateShape> plate;
    std::optional<CylinderShape> cylinder;
    std::optional<NurbsSurfaceShape> nurbs;
    std::optional<std::string> cadJson;
    std::optional<double> tolerance;

    static const SchemaOf<ShellGeometry>& schema() {
        static const SchemaOf<ShellGeometry> schema =
            SchemaOf<ShellGeometry>{
                {"rectangle", &ShellGeometry::rectangle, rectangleMeaning},
                {"plate", &ShellGeometry::plate, plateMeaning},
                {"cylinder", &ShellGeometry::cylinder, cylinderMeaning},
                {"nurbs", &ShellGeometry::nurbs, nurbsSurfaceMeaning},
                {"cadJson", &ShellGeometry::cadJson,
                 "File of trimmed patches and their edges, relative to the case file; patches are "
                 "joined along edges that they share or that coincide. The normal of a face with "
                 "swapped_surface_normal is reversed, and its xi with it."}}
                .exactlyOne()
                .with(slitSchema<ShellGeometry>())
                .with(SchemaOf<ShellGeometry>{
                    {"tolerance", &ShellGeometry::tolerance, "(0, inf)", "m",
                     "cadJson: largest distance by which trimming curves may miss each other, the "
                     "rim of their surface, or the edges that they coincide with. Corrections are "
                     "in the log.",
                     otherwise("the file's model_tolerance, else 1e-6 of the size of the "
                               "surface")}});
        return schema;
    }
};

/// An item of `model.faceThickness`.
struct FaceThickness : Located {
    std::string face;
    double thickness = 0;

    static const SchemaOf<FaceThickness>& schema() {
        static const SchemaOf<FaceThickness> schema = {
            {"face", &FaceThickness::face, "Name of the face.", required},
            {"thickness", &FaceThickness::thickness, "(0, inf)", "m", "Thickness of the face.",
             required}};
        return schema;
    }
};

/// An item of `model.faceMaterial`.
struct FaceMaterial : Located {
    std::string face;
    double youngsModulus = 0;
    double density = 0;

    static const SchemaOf<FaceMaterial>& schema() {
        static const SchemaOf<FaceMaterial> schema = {
            {"face", &FaceMaterial::face, "Name of the face.", required},
            {"youngsModulus", &FaceMaterial::youngsModulus, "(0, inf)", "Pa",
             "Young's modulus of the face.", required},
            {"density", &FaceMaterial::density, "(0, inf)", "kg/m^3", "Density of the face.",
             required}};
        return schema;
    }
};

inline const Choices<EdgeMethod>& edgeMethods() {
    static const Choices<EdgeMethod> choices = {
        {"penalty", EdgeMethod::penalty, "penalty springs."},
        {"nitsche", EdgeMethod::nitsche,
         "Nitsche's method with the least stabilisation (linear strains; with bending, "
         "StVenantKirchhoff)."},
        {"lagrange", EdgeMethod::lagrange, "Lagrange multipliers along the edge."},
        {"egm", EdgeMethod::egm,
         "supports of trimming curves are strong, by the extended gradient method; joints and all "
         "else by the default."}};
    return choices;
}

inline const Choices<EgmResidual>& egmResiduals() {
    static const Choices<EgmResidual> choices = {
        {"none", EgmResidual::none, "left out, whatever the physics."},
        {"physical", EgmResidual::physical, "on what trimming leaves of elements."},
        {"whole", EgmResidual::whole,
         "on whole elements: formulas of loads go on where the body is trimmed away."}};
    return choices;
}

inline const Choices<EgmForm>& egmForms() {
    static const Choices<EgmForm> choices = {
        {"closed", EgmForm::closed, "all unknowns are solved for at once."},
        {"iterated", EgmForm::iterated,
         "control values next to the curve follow from the solution before, until it changes by "
         "less than the tolerance."}};
    return choices;
}

inline const Choices<EgmContinuation>& egmContinuations() {
    static const Choices<EgmContinuation> choices = {
        {"jumps", EgmContinuation::jumps, "small jumps of derivatives between elements."},
        {"gradient", EgmContinuation::gradient,
         "the derivative across the curve, continued from uncut elements by moving least "
         "squares."}};
    return choices;
}

/// Entries of `model.egm`.
struct EgmEntries : Located {
    EgmForm form = EgmForm::closed;
    std::optional<EgmContinuation> continuation;
    std::optional<EgmResidual> residual;
    std::optional<double> gamma;
    double delta = 1;
    double tolerance = 1e-6;
    int maxIterations = 100;

    static const SchemaOf<EgmEntries>& schema() {
        static const SchemaOf<EgmEntries> schema = {
            {"form", &EgmEntries::form, egmForms(), "How control values and equilibrium are met."},
            {"continuation", &EgmEntries::continuation, egmContinuations(),
             "What makes control values next to a supported trimming curve go on from the others.",
             otherwise("`jumps` with form closed, `gradient` with iterated")},
            {"residual", &EgmEntries::residual, egmResiduals(),
             "jumps: the strong form of equilibrium, with linear strains and without inertia, as "
             "a part of what control values next to the curve minimise.",
             otherwise("`whole` with linear strains, scheme static and no coupling, else `none`")},
            {"gamma", &EgmEntries::gamma, "(0, inf)", "", "jumps: factor on them.",
             otherwise("0.5 at degree 1, else 0.01")},
            {"delta", &EgmEntries::delta, "(0, inf)", "", "Factor on the residual."},
            {"tolerance", &EgmEntries::tolerance, "(0, 1)", "",
             "iterated: relative change of the displacement at which the iteration ends."},
            {"maxIterations", &EgmEntries::maxIterations, "[1, inf)", "",
             "iterated: most solutions in a step, beyond which it fails."}};
        return schema;
    }
};

inline const Choices<SliverTreatment>& sliverTreatments() {
    static const Choices<SliverTreatment> choices = {
        {"scaling", SliverTreatment::scaling,
         "unknowns are scaled by the diagonal of the stiffness matrix, as always."},
        {"extension", SliverTreatment::extension,
         "also, their polynomials are tied to those of a full neighbour."}};
    return choices;
}

/// Entries of `model` of a shell.
struct ShellModel : ModelEntries {
    double thickness = 0;
    std::vector<FaceThickness> faceThickness;
    std::vector<FaceMaterial> faceMaterial;
    std::optional<EdgeMethod> edgeMethod;
    std::optional<double> penalty;
    std::optional<EgmEntries> egm;
    std::optional<SliverTreatment> sliverTreatment;
    double prestress = 0; ///< of a membrane

    static const SchemaOf<ShellModel>& schema() {
        static const SchemaOf<ShellModel> schema =
            SchemaOf<ShellModel>()
                .with(ModelEntries::schema())
                .with(SchemaOf<ShellModel>{
                    thicknessEntry<ShellModel>("faces"),
                    {"faceThickness", &ShellModel::faceThickness, "Faces of another thickness.",
                     otherwise("`[]`")},
                    {"faceMaterial", &ShellModel::faceMaterial,
                     "Faces of another stiffness and density.", otherwise("`[]`")},
                    {"edgeMethod", &ShellModel::edgeMethod, edgeMethods(),
                     "How patches are joined, and edges supported, where the basis cannot do it "
                     "exactly.",
                     otherwise("`penalty` if the entry penalty is given, and with scheme explicit; "
                               "else `nitsche` with linear strains where it is possible, else "
                               "`lagrange`")},
                    {"penalty", &ShellModel::penalty, "(0, inf)", "",
                     "penalty, lagrange: stiffness of the springs at joints and weak supports over "
                     "that of an element, E t/((1 - nu^2) h) for displacements and E t^3/(12 (1 - "
                     "nu^2) h) for rotations. nitsche: factor of the stabilisation.",
                     otherwise("penalty: `1e3`, lagrange: `1e6`, nitsche: `1`")},
                    {"egm", &ShellModel::egm, "Options of edgeMethod egm.", otherwise("`{}`")},
                    {"sliverTreatment", &ShellModel::sliverTreatment, sliverTreatments(),
                     "Treatment of cut elements of which trimming leaves less than a fifth.",
                     otherwise("`extension`; with scheme explicit, which excludes it, "
                               "`scaling`")}});
        return schema;
    }
};

/// Entries of `model` of a membrane.
struct MembraneModel : ShellModel {
    static const SchemaOf<MembraneModel>& schema() {
        static const SchemaOf<MembraneModel> schema =
            SchemaOf<MembraneModel>()
                .with(ShellModel::schema())
                .with(SchemaOf<MembraneModel>{
                    {"prestress", &MembraneModel::prestress, "", "Pa",
                     "Stress in all directions of the reference configuration, tension "
                     "positive."}});
        return schema;
    }
};

/// Entries that name an edge, of supports and of loads.
struct ShellEdgeEntries : Located {
    std::optional<geometry::Edge> edge;
    std::optional<std::string> brepEdge;
    std::optional<std::array<double, 3>> point;

    static SchemaOf<ShellEdgeEntries> schema() {
        return {{"edge", &ShellEdgeEntries::edge, edgeChoices(),
                 "Edge of a single patch that is not trimmed."},
                {"brepEdge", &ShellEdgeEntries::brepEdge, "Name of an edge of the model."},
                {"point", &ShellEdgeEntries::point, "", "m", "Point of the surface."}};
    }
};

/// An item of `supports` of a shell or membrane.
struct ShellSupport : ShellEdgeEntries {
    std::vector<Fixed> fix;
    std::optional<std::array<Formula, 3>> displacement;
    std::optional<bool> weak;

    template <class Support>
    static SchemaOf<Support> schemaWith(const Choices<Fixed>& choices, const char* meaning) {
        return SchemaOf<Support>()
            .with(ShellEdgeEntries::schema())
            .with(SchemaOf<Support>{
                {"fix", &Support::fix, choices, meaning, required},
                {"displacement", &Support::displacement, "", "m", supportDisplacementMeaning,
                 otherwise("`0`")},
                {"weak", &Support::weak,
                 "Whether an edge is supported weakly, by springs, even where the basis could do "
                 "it exactly.",
                 otherwise("`no`")}});
    }

    static const SchemaOf<ShellSupport>& schema() {
        static const SchemaOf<ShellSupport> schema = schemaWith<ShellSupport>(
            componentsAndRotation(),
            "Displacement components, and rotation about the edge, that are zero there.");
        return schema;
    }
};
struct MembraneSupport : ShellSupport {
    static const SchemaOf<MembraneSupport>& schema() {
        static const SchemaOf<MembraneSupport> schema =
            schemaWith<MembraneSupport>(spatialComponents(), fixMeaning);
        return schema;
    }
};

/// An item of `loads` of a shell or membrane.
struct ShellLoad : ShellEdgeEntries {
    std::optional<std::string> face;
    std::optional<std::array<Formula, 3>> traction;
    std::optional<Formula> pressure;
    std::optional<std::array<Formula, 3>> gravity;
    std::optional<std::array<Formula, 3>> lineForce;
    std::optional<Formula> lineMoment;
    std::optional<std::array<Formula, 3>> force;

    template <class Load>
    static SchemaOf<Load> membraneSchema() {
        return SchemaOf<Load>()
            .with(ShellEdgeEntries::schema())
            .with(SchemaOf<Load>{
                {"face", &Load::face, "Name of the face on which traction or pressure act.",
                 otherwise("all faces")},
                {"traction", &Load::traction, "", "Pa",
                 "Force per reference area along x, y and z; keeps its direction as the body "
                 "deforms."},
                {"pressure", &Load::pressure, "", "Pa",
                 "Pressure along the current normal, on the current area."},
                {"gravity", &Load::gravity, "", "m/s^2",
                 "Acceleration along x, y and z that acts on the mass."},
                {"lineForce", &Load::lineForce, "", "N/m",
                 "Force per reference length of an edge; keeps its direction."},
                {"force", &Load::force, "", "N", "Force at a point; keeps its direction."}});
    }

    static const SchemaOf<ShellLoad>& schema() {
        static const SchemaOf<ShellLoad> schema =
            membraneSchema<ShellLoad>().with(SchemaOf<ShellLoad>{
                {"lineMoment", &ShellLoad::lineMoment, "", "N",
                 "Moment per reference length about an edge; positive turns the normal outwards "
                 "across it."}});
        return schema;
    }
};
struct MembraneLoad : ShellLoad {
    static const SchemaOf<MembraneLoad>& schema() {
        static const SchemaOf<MembraneLoad> schema = membraneSchema<MembraneLoad>();
        return schema;
    }
};

/// Entries of a case file that describe a shell or membrane.
template <class Model, class Support, class Load>
struct SurfaceEntries : Located {
    ShellGeometry geometry;
    Discretisation<2> discretisation;
    Model model;
    MaterialEntries<Laws::all> material;
    std::vector<Support> supports;
    std::vector<Load> loads;
    CouplingEntries<WetParts::surface> coupling;

    static const SchemaOf<SurfaceEntries>& schema() {
        static const SchemaOf<SurfaceEntries> schema = bodySchema<SurfaceEntries>(
            "each has traction or pressure, with or without face; or gravity; or an edge and a "
            "line load; or point and force");
        return schema;
    }
};
using ShellEntries = SurfaceEntries<ShellModel, ShellSupport, ShellLoad>;
using MembraneEntries = SurfaceEntries<MembraneModel, MembraneSupport, MembraneLoad>;

/// @throws InputError for entries that do not fit each other or the model
ShellDescription makeShell(const ShellEntries& entries, const CaseContext& context);
ShellDescription makeMembrane(const MembraneEntries& entries, const CaseContext& context);

} // namespace tokay::structure
