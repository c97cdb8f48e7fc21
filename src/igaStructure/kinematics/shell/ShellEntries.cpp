// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/ShellEntries.hpp"

#include "geometry/brep/ModelProjector.hpp"
#include "geometry/brep/cadJson.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numeric>

namespace tokay::structure {

namespace {

constexpr double sameEdge = 1e-6; // of the size: coordinates of a file have some digits only

// A patch with its edges: a closed one is joined to itself along its seam.
geometry::BrepModel wholeSurface(const geometry::NurbsSurface& surface, bool isSlit) {
    const std::vector<geometry::BrepFace> faces = {{geometry::TrimmedPatch(surface, "shell")}};
    const geometry::BrepModel alone(faces);
    constexpr double never = -1;
    std::vector<geometry::BrepEdge> edges =
        geometry::coincidentEdges(faces, isSlit ? never : sameEdge * alone.size());
    for (geometry::BrepEdge& edge : edges) {
        edge.isFound = edge.trims.size() > 1;
    }
    return geometry::BrepModel(faces, std::move(edges));
}

geometry::BrepModel readModel(const std::string& path, const ShellGeometry& shape) {
    geometry::BrepModel model = geometry::readCadJson(path, shape.tolerance);
    return shape.isSlit ? model
                        : geometry::withCoincidentEdges(
                              model, shape.tolerance.value_or(
                                         std::max(model.tolerance(), sameEdge * model.size())));
}

geometry::BrepModel makeModel(const ShellGeometry& shape, const std::string& directory) {
    if (shape.cadJson) {
        return readModel((std::filesystem::path(directory) / *shape.cadJson).string(), shape);
    }
    if (shape.tolerance) {
        throw shape.error("tolerance", "goes with cadJson: other shapes have no trimming curves");
    }
    return wholeSurface(shape.rectangle  ? shape.rectangle->surface()
                        : shape.plate    ? shape.plate->surface()
                        : shape.cylinder ? shape.cylinder->surface()
                                         : shape.nurbs->surface(),
                        shape.isSlit);
}

geometry::BrepModel refinedModel(const ShellGeometry& shape, const Discretisation<2>& basis,
                                 const std::string& directory) {
    const geometry::BrepModel model = makeModel(shape, directory);
    return basis.at("degree", [&] {
        return model.refined(basis.degree[0], basis.degree[1], basis.elements[0],
                             basis.elements[1]);
    });
}

std::vector<double> makeThickness(const ShellModel& entries, const geometry::BrepModel& model) {
    std::vector<double> thickness(model.faces().size(), entries.thickness);
    for (const FaceThickness& item : entries.faceThickness) {
        thickness[item.at("face", [&] { return model.faceNumber(item.face); })] = item.thickness;
    }
    return thickness;
}

std::vector<ShellMaterial> makeFaceMaterial(const ShellModel& entries,
                                            const ShellMaterial& material,
                                            const geometry::BrepModel& model) {
    if (entries.faceMaterial.empty()) {
        return {};
    }
    std::vector<ShellMaterial> all(model.faces().size(), material);
    for (const FaceMaterial& item : entries.faceMaterial) {
        ShellMaterial& own = all[item.at("face", [&] { return model.faceNumber(item.face); })];
        own.youngsModulus = item.youngsModulus;
        own.density = item.density;
    }
    return all;
}

// Springs at edges and what ties slivers shorten the stable step of an explicit scheme:
// the softest springs are its default, and slivers, whose lumped mass is next to
// nothing, cannot be tied.
void setEdgesAndSlivers(const ShellModel& entries, bool isExplicit, ShellDescription& shell) {
    shell.edgeMethod = entries.edgeMethod;
    if (!shell.edgeMethod && isExplicit) {
        shell.edgeMethod = EdgeMethod::penalty;
    }
    shell.penalty = entries.penalty;
    shell.sliverTreatment = entries.sliverTreatment.value_or(
        isExplicit ? SliverTreatment::scaling : SliverTreatment::extension);
    if (isExplicit && shell.sliverTreatment == SliverTreatment::extension) {
        throw entries.error("sliverTreatment",
                            "extension cannot be used with scheme explicit, whose step would "
                            "vanish with the lumped mass of slivers: take scaling, or an "
                            "implicit scheme");
    }
}

// The strong form knows loads that are formulas, and no inertia.
EgmOptions egmOptions(const ShellModel& model, const CaseContext& context) {
    const EgmEntries entries = model.egm.value_or(EgmEntries());
    if (model.egm && model.edgeMethod != EdgeMethod::egm) {
        throw model.error("egm", "goes with edgeMethod egm");
    }
    EgmOptions options;
    options.form = entries.form;
    options.continuation = entries.continuation.value_or(
        entries.form == EgmForm::closed ? EgmContinuation::jumps : EgmContinuation::gradient);
    options.gamma = entries.gamma;
    options.delta = entries.delta;
    options.tolerance = entries.tolerance;
    options.maxIterations = entries.maxIterations;
    const bool isAtRest = model.strains == Strains::linear && !context.isDynamic;
    if (entries.residual.value_or(EgmResidual::none) != EgmResidual::none &&
        (!isAtRest || options.continuation == EgmContinuation::gradient)) {
        throw entries.error("residual", "the strong form is that of linear strains at rest, and "
                                        "goes with continuation jumps: take none, or strains "
                                        "linear and scheme static");
    }
    options.residual = entries.residual;
    if (!isAtRest || context.isCoupled) {
        options.residual = entries.residual.value_or(EgmResidual::none);
    }
    return options;
}

/// Finds the edges, faces and points of the model that supports and loads name.
class ModelParts {
  public:
    explicit ModelParts(const geometry::BrepModel& model) : model_(model) {}

    std::vector<geometry::BrepTrim> trims(const ShellEdgeEntries& entries) const {
        if (entries.edge.has_value() == entries.brepEdge.has_value() || entries.point) {
            throw entries.error("", "give one of: edge, brepEdge, point");
        }
        if (entries.brepEdge) {
            return entries.at("brepEdge", [&] {
                return model_.edges()[model_.edgeNumber(*entries.brepEdge)].trims;
            });
        }
        if (model_.faces().size() > 1 || model_.patch(0).isTrimmed()) {
            throw entries.error("edge", "left, right, bottom and top are edges of a single patch "
                                        "that is not trimmed; name an edge of the model by "
                                        "brepEdge");
        }
        // Curves of a whole patch run counter-clockwise from the bottom.
        constexpr int curveOf[] = {3, 1, 0, 2};
        return {{0, curveOf[static_cast<int>(*entries.edge)]}};
    }

    std::vector<int> faces(const ShellLoad& load) const {
        if (load.face) {
            return {load.at("face", [&] { return model_.faceNumber(*load.face); })};
        }
        std::vector<int> all(model_.faces().size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }

    geometry::ModelProjection closest(const ShellEdgeEntries& entries) const {
        constexpr double sloppiness = 1e-6; // a coordinate typed by a person has some digits only
        const auto& [x, y, z] = *entries.point;
        const geometry::ModelProjection found = geometry::ModelProjector(model_).closest({x, y, z});
        if (found.distance > sloppiness * model_.size()) {
            throw entries.error("point",
                                fmt::format("lies {:.4g} m outside the surface", found.distance));
        }
        return found;
    }

  private:
    const geometry::BrepModel& model_;
};

void addSupport(const ShellSupport& support, const ModelParts& parts, ShellDescription& shell) {
    const std::array<bool, 3> fixed = fixedComponents<3>(support.fix);
    const bool isClamped = fixedComponents<4>(support.fix)[3];
    const SupportMotion motion = supportMotion(support, support.displacement, fixed);
    if (!support.point) {
        shell.edgeSupports.push_back(
            {parts.trims(support), fixed, isClamped, support.weak.value_or(false), motion,
             support.edge ? nameOf(*support.edge, edgeChoices()) : *support.brepEdge});
        return;
    }
    if (support.edge || support.brepEdge || support.weak) {
        throw support.error("", "give one of: edge, brepEdge, point; weak only with an edge");
    }
    if (isClamped) {
        throw support.error("fix", "a point has no rotation; allowed: x, y, z");
    }
    const geometry::ModelProjection at = parts.closest(support);
    shell.pointSupports.push_back({at.face, {at.xi, at.eta}, fixed, motion, "point"});
}

void requireOneLoad(const ShellLoad& load) {
    const bool isOnEdge = load.lineForce || load.lineMoment;
    const bool isOnFaces = load.traction || load.pressure;
    const int nLoads = load.traction.has_value() + load.pressure.has_value() +
                       load.gravity.has_value() + load.lineForce.has_value() +
                       load.lineMoment.has_value() + load.force.has_value();
    if (nLoads != 1) {
        throw load.error("", "give exactly one of: traction, pressure, gravity, lineForce, "
                             "lineMoment, force");
    }
    if (load.force && !load.point) {
        throw load.error("", "entry 'point' is missing: a force acts there");
    }
    if ((load.point && !load.force) || (load.face && !isOnFaces) ||
        ((load.edge || load.brepEdge) && !isOnEdge)) {
        throw load.error("", "edge and brepEdge go with lineForce and lineMoment, face with "
                             "traction and pressure, point with force; remove the others");
    }
}

void addLoad(const ShellLoad& load, const ModelParts& parts, ShellLoads& loads) {
    requireOneLoad(load);
    if (load.gravity) {
        loads.gravities.push_back(vectorField(*load.gravity));
    } else if (load.pressure) {
        loads.pressures.push_back({parts.faces(load), scalarField(*load.pressure)});
    } else if (load.traction) {
        for (const int face : parts.faces(load)) {
            loads.tractions.push_back({face, vectorField(*load.traction)});
        }
    } else if (load.force) {
        const geometry::ModelProjection at = parts.closest(load);
        loads.pointForces.push_back({at.face, {at.xi, at.eta}, vectorField(*load.force)});
    } else if (load.lineForce) {
        loads.edgeForces.push_back({parts.trims(load).front(), vectorField(*load.lineForce)});
    } else {
        loads.edgeMoments.push_back({parts.trims(load).front(), scalarField(*load.lineMoment)});
    }
}

template <class Entries>
ShellDescription make(const Entries& entries, bool bends, const CaseContext& context) {
    ShellDescription shell{
        refinedModel(entries.geometry, entries.discretisation, context.directory),
        {},
        entries.material.material()};
    const ShellModel& model = entries.model;
    shell.thickness = makeThickness(model, shell.model);
    shell.faceMaterial = makeFaceMaterial(model, shell.material, shell.model);
    shell.strains = model.strains;
    shell.bending = bends;
    shell.prestress = {model.prestress, model.prestress, 0};
    setEdgesAndSlivers(model, context.isExplicit, shell);
    shell.egm = egmOptions(model, context);
    const ModelParts parts(shell.model);
    for (const ShellSupport& support : entries.supports) {
        addSupport(support, parts, shell);
    }
    for (const ShellLoad& load : entries.loads) {
        addLoad(load, parts, shell.loads);
    }
    return shell;
}

} // namespace

ShellDescription makeShell(const ShellEntries& entries, const CaseContext& context) {
    return make(entries, true, context);
}

ShellDescription makeMembrane(const MembraneEntries& entries, const CaseContext& context) {
    return make(entries, false, context);
}

} // namespace tokay::structure
