// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/readShell.hpp"

#include "geometry/brep/ModelProjector.hpp"
#include "igaStructure/caseFile/CaseSection.hpp"
#include "igaStructure/caseFile/requireUsed.hpp"
#include "igaStructure/kinematics/readBrepModel.hpp"
#include "igaStructure/kinematics/readMaterial.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

namespace {

std::string kinematicsOf(const CaseSection& file) {
    return file.section("model").text("kinematics");
}

std::vector<double> readThickness(const CaseSection& section, const geometry::BrepModel& model) {
    section.require("thickness", section.text("kinematics") + " needs it");
    std::vector<double> thickness(model.faces().size(), section.number("thickness"));
    for (const CaseSection& item : section.list("faceThickness")) {
        try {
            thickness[model.faceNumber(item.text("face"))] = item.number("thickness");
        } catch (const InputError& error) {
            throw item.error("face", error.what());
        }
    }
    return thickness;
}

std::vector<ShellMaterial> readFaceMaterial(const CaseSection& section,
                                            const ShellMaterial& material,
                                            const geometry::BrepModel& model) {
    if (section.list("faceMaterial").empty()) {
        return {};
    }
    std::vector<ShellMaterial> all(model.faces().size(), material);
    for (const CaseSection& item : section.list("faceMaterial")) {
        try {
            ShellMaterial& own = all[model.faceNumber(item.text("face"))];
            own.youngsModulus = item.number("youngsModulus");
            own.density = item.number("density");
        } catch (const InputError& error) {
            throw item.error("face", error.what());
        }
    }
    return all;
}

EdgeMethod readEdgeMethod(const CaseSection& section) {
    const std::string name = section.text("edgeMethod");
    return name == "nitsche"    ? EdgeMethod::nitsche
           : name == "lagrange" ? EdgeMethod::lagrange
                                : EdgeMethod::penalty;
}

// Springs at edges and what ties slivers shorten the stable step of an explicit scheme:
// the softest springs are its default, and slivers, whose lumped mass is next to
// nothing, cannot be tied.
void readEdgesAndSlivers(const CaseSection& section, bool isExplicit, ShellDescription& shell) {
    if (section.has("edgeMethod")) {
        shell.edgeMethod = readEdgeMethod(section);
    } else if (isExplicit) {
        shell.edgeMethod = EdgeMethod::penalty;
    }
    if (section.has("penalty")) {
        shell.penalty = section.number("penalty");
    }
    const bool isExtended = section.has("sliverTreatment")
                                ? section.text("sliverTreatment") == "extension"
                                : !isExplicit;
    if (isExtended && isExplicit) {
        throw section.error("sliverTreatment",
                            "extension cannot be used with scheme explicit, whose step would "
                            "vanish with the lumped mass of slivers: take scaling, or an "
                            "implicit scheme");
    }
    shell.sliverTreatment = isExtended ? SliverTreatment::extension : SliverTreatment::scaling;
}

// Reads supports and loads, which name edges, faces and points of the model.
class Reader {
  public:
    Reader(const CaseSection& file, const geometry::BrepModel& model)
        : file_(file), model_(model), kinematics_(kinematicsOf(file)) {}

    void readSupports(ShellDescription& shell) const {
        for (const CaseSection& section : file_.list("supports")) {
            requireUsed(section, {"edge", "brepEdge", "point", "fix", "weak"}, kinematics_);
            const std::vector<std::string> fix =
                section.words("fix", {"x", "y", "z", "rotation"}, "a " + kinematics_);
            const auto fixes = [&](const char* word) {
                return std::find(fix.begin(), fix.end(), word) != fix.end();
            };
            const std::array<bool, 3> fixed = {fixes("x"), fixes("y"), fixes("z")};
            if (section.has("point")) {
                requireUsed(section, {"point", "fix"}, "a support at a point");
                const geometry::ModelProjection at = place(section);
                shell.pointSupports.push_back({at.face, {at.xi, at.eta}, fixed});
                continue;
            }
            const bool weak = section.has("weak") && section.yesNo("weak");
            shell.edgeSupports.push_back({trims(section), fixed, fixes("rotation"), weak});
        }
    }

    ShellLoads readLoads() const {
        ShellLoads loads;
        for (const CaseSection& section : file_.list("loads")) {
            requireUsed(section,
                        {"edge", "brepEdge", "face", "point", "traction", "pressure", "gravity",
                         "lineForce", "lineMoment", "force"},
                        kinematics_);
            read(section, loads);
        }
        return loads;
    }

  private:
    void read(const CaseSection& section, ShellLoads& loads) const {
        int nKinds = 0;
        for (const char* kind :
             {"traction", "pressure", "gravity", "lineForce", "lineMoment", "force"}) {
            nKinds += section.has(kind) ? 1 : 0;
        }
        if (nKinds != 1) {
            throw section.error("", "give exactly one of: traction, pressure, gravity, lineForce, "
                                    "lineMoment, force");
        }
        if (section.has("gravity")) {
            requireUsed(section, {"gravity"}, "gravity");
            loads.gravities.push_back(readVectorField(section, "gravity"));
        } else if (section.has("traction") || section.has("pressure")) {
            readOnFaces(section, loads);
        } else if (section.has("force")) {
            requireUsed(section, {"point", "force"}, "a force");
            section.require("point", "a force acts there");
            const geometry::ModelProjection at = place(section);
            loads.pointForces.push_back(
                {at.face, {at.xi, at.eta}, readVectorField(section, "force")});
        } else {
            readOnEdge(section, loads);
        }
    }

    void readOnFaces(const CaseSection& section, ShellLoads& loads) const {
        requireUsed(section, {"face", "traction", "pressure"}, "a load on faces");
        if (section.has("pressure")) {
            loads.pressures.push_back({faces(section), readScalarField(section, "pressure")});
            return;
        }
        for (const int face : faces(section)) {
            loads.tractions.push_back({face, readVectorField(section, "traction")});
        }
    }

    void readOnEdge(const CaseSection& section, ShellLoads& loads) const {
        requireUsed(section, {"edge", "brepEdge", "lineForce", "lineMoment"}, "a load on an edge");
        const geometry::BrepTrim trim = trims(section).front();
        if (section.has("lineForce")) {
            loads.edgeForces.push_back({trim, readVectorField(section, "lineForce")});
        } else {
            loads.edgeMoments.push_back({trim, readScalarField(section, "lineMoment")});
        }
    }

    std::vector<geometry::BrepTrim> trims(const CaseSection& section) const {
        if (section.has("edge") == section.has("brepEdge")) {
            throw section.error("", "give one of: edge, brepEdge, point");
        }
        if (section.has("brepEdge")) {
            return model_.edges()[numberOf(section, "brepEdge")].trims;
        }
        if (model_.faces().size() > 1 || model_.patch(0).isTrimmed()) {
            throw section.error("edge", "left, right, bottom and top are edges of a single patch "
                                        "that is not trimmed; name an edge of the model by "
                                        "brepEdge");
        }
        // Curves of a whole patch run counter-clockwise from the bottom.
        constexpr int curveOf[] = {3, 1, 0, 2};
        return {{0, curveOf[static_cast<int>(geometry::edgeFromName(section.text("edge")))]}};
    }

    int numberOf(const CaseSection& section, const std::string& entry) const {
        try {
            return entry == "face" ? model_.faceNumber(section.text(entry))
                                   : model_.edgeNumber(section.text(entry));
        } catch (const InputError& error) {
            throw section.error(entry, error.what());
        }
    }

    std::vector<int> faces(const CaseSection& section) const {
        if (section.has("face")) {
            return {numberOf(section, "face")};
        }
        std::vector<int> all(model_.faces().size());
        for (std::size_t k = 0; k < all.size(); ++k) {
            all[k] = static_cast<int>(k);
        }
        return all;
    }

    geometry::ModelProjection place(const CaseSection& section) const {
        constexpr double sloppiness = 1e-6; // a coordinate typed by a person has some digits only
        const std::vector<double> x = section.numbers("point", 3);
        const geometry::ModelProjection found =
            geometry::ModelProjector(model_).closest({x[0], x[1], x[2]});
        if (found.distance > sloppiness * model_.size()) {
            throw section.error("point",
                                fmt::format("lies {:.4g} m outside the surface", found.distance));
        }
        return found;
    }

    const CaseSection& file_;
    const geometry::BrepModel& model_;
    std::string kinematics_;
};

} // namespace

ShellDescription readShell(const CaseSection& file, const std::string& directory) {
    const CaseSection section = file.section("model");
    const std::string kinematics = kinematicsOf(file);
    requireUsed(section,
                {"kinematics", "strains", "thickness", "faceThickness", "faceMaterial",
                 kinematics == "membrane" ? "prestress" : "thickness", "edgeMethod", "penalty",
                 "sliverTreatment"},
                kinematics);
    ShellDescription shell{readBrepModel(file, directory), {}, readMaterial(file)};
    shell.thickness = readThickness(section, shell.model);
    shell.faceMaterial = readFaceMaterial(section, shell.material, shell.model);
    shell.strains = section.text("strains") == "linear" ? Strains::linear : Strains::nonlinear;
    shell.bending = kinematics == "shell";
    if (section.has("prestress")) {
        const double stress = section.number("prestress");
        shell.prestress = {stress, stress, 0};
    }
    readEdgesAndSlivers(section, file.section("time").text("scheme") == "explicit", shell);
    const Reader reader(file, shell.model);
    reader.readSupports(shell);
    shell.loads = reader.readLoads();
    return shell;
}

} // namespace tokay::structure
