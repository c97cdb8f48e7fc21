// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/BeamEntries.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

void requireUsable(const BeamModel& model, bool isInSpace) {
    if (model.rotaryInertia && model.strains == Strains::nonlinear) {
        throw model.error("rotaryInertia", "yes is not available with nonlinear strains, where the "
                                           "mass would depend on the motion; remove it");
    }
    if (isInSpace && model.width && *model.width != model.thickness) {
        throw model.error("width", fmt::format("{:g} is not the thickness {:g}: a beam in space "
                                               "bends alike in all directions, so its section is "
                                               "a square; remove it",
                                               *model.width, model.thickness));
    }
}

void requireUsable(const CableModel& model, bool) {
    if (model.strains == Strains::linear && !model.prestress) {
        throw model.error("", "entry 'prestress' is missing: a cable with linear strains has no "
                              "other stiffness across its axis");
    }
}

// E, or E/(1 - nu^2) where the section cannot strain across the plane.
double axialModulus(const CurveModel& model, const ElasticMaterial& material,
                    SectionStrain byDefault) {
    return model.section.value_or(byDefault) == SectionStrain::planeStrain
               ? material.planeStressModulus()
               : material.youngsModulus;
}

BeamSection makeSection(const CurveModel& model, const ElasticMaterial& material, bool bends,
                        bool isInSpace) {
    if (isInSpace && model.section == SectionStrain::planeStrain) {
        throw model.error("section", "planeStrain is not available in space, where a line is a rod "
                                     "with the modulus E; remove it");
    }
    BeamSection section;
    section.thickness = model.thickness;
    section.width = model.width.value_or(isInSpace ? model.thickness : 1);
    const double area = section.thickness * section.width;
    const double secondMoment = area * section.thickness * section.thickness / 12;
    const double modulus =
        axialModulus(model, material,
                     bends && !isInSpace ? SectionStrain::planeStrain : SectionStrain::planeStress);
    section.axialStiffness = modulus * area;
    section.bendingStiffness = bends ? modulus * secondMoment : 0;
    section.mass = material.density * area;
    section.massDamping = material.massDamping;
    section.stiffnessDamping = material.stiffnessDamping;
    return section;
}

BeamSection makeSection(const BeamEntries& entries, bool isInSpace) {
    BeamSection section = makeSection(entries.model, entries.material, true, isInSpace);
    if (entries.model.rotaryInertia) {
        section.rotaryInertia = entries.material.density * section.thickness * section.width *
                                section.thickness * section.thickness / 12;
    }
    return section;
}

BeamSection makeSection(const CableEntries& entries, bool isInSpace) {
    BeamSection section = makeSection(entries.model, entries.material, false, isInSpace);
    section.prestress = entries.model.prestress.value_or(0) * section.thickness * section.width;
    return section;
}

void requireComponents(const Located& entries, const std::string& name,
                       const std::vector<Formula>& vector, int dimension) {
    if (vector.size() != static_cast<std::size_t>(dimension)) {
        throw entries.error(
            name, fmt::format("must have {} values here, but has {}", dimension, vector.size()));
    }
}

BeamSupport makeSupport(const BeamSupportEntries& support, bool isInSpace) {
    const std::array<bool, 4> fixed = fixedComponents<4>(support.fix);
    if (fixed[2] && !isInSpace) {
        throw support.error("fix", "'z' is not a component in the plane; allowed: x, y and "
                                   "rotation of a beam");
    }
    BeamSupport result{support.end};
    result.x = fixed[0];
    result.y = fixed[1];
    result.z = fixed[2];
    result.rotation = fixed[3];
    if (support.displacement) {
        requireComponents(support, "displacement", *support.displacement, isInSpace ? 3 : 2);
    }
    result.name = nameOf(support.end, endChoices());
    result.motion = supportMotion(support, support.displacement, fixed);
    return result;
}

// A load that follows the motion needs a side, or an axis to turn about.
void requireNoFollower(const CableLoadEntries& load) {
    if (load.moment) {
        throw load.error("moment", "is not available in space, where a moment that turns with the "
                                   "end has no one axis; give a force");
    }
    if (load.pressure) {
        throw load.error("pressure", "is not available in space, where a line has no side; give "
                                     "traction");
    }
}

void addEndLoad(const CableLoadEntries& load, int dimension, BeamLoads& loads) {
    if (load.traction || load.gravity || load.pressure) {
        throw load.error("", "traction, gravity and pressure act all along the axis; remove end, "
                             "or give force or moment");
    }
    if (!load.force && !load.moment) {
        throw load.error("", "give force or moment at the end");
    }
    if (load.force) {
        requireComponents(load, "force", *load.force, dimension);
    }
    loads.ends.push_back({*load.end, load.force, load.moment});
}

void addLoad(const CableLoadEntries& load, int dimension, BeamLoads& loads) {
    if (dimension == 3) {
        requireNoFollower(load);
    }
    if (load.end) {
        addEndLoad(load, dimension, loads);
        return;
    }
    if (load.force || load.moment) {
        throw load.error("", "entry 'end' is missing: force and moment act on one");
    }
    if (load.traction.has_value() + load.gravity.has_value() + load.pressure.has_value() != 1) {
        throw load.error("", "give exactly one of: traction, gravity, pressure");
    }
    if (load.traction) {
        requireComponents(load, "traction", *load.traction, dimension);
        loads.tractions.push_back(*load.traction);
    } else if (load.gravity) {
        requireComponents(load, "gravity", *load.gravity, dimension);
        loads.gravities.push_back(*load.gravity);
    } else {
        loads.pressures.push_back(*load.pressure);
    }
}

// What a closed curve is taken for must not be silent: its ends are not joined.
geometry::NurbsCurve makeAxis(const CurveGeometry& shape, const Discretisation<1>& basis) {
    geometry::NurbsCurve curve = refined(shape.curve(), basis);
    const geometry::Points& points = curve.controlPoints();
    const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
    const double gap = (points.row(0) - points.row(points.rows() - 1)).norm();
    constexpr double sameEnds = 1e-9;
    if (gap <= sameEnds * size && !shape.isSlit) {
        throw shape.error("", "the curve ends where it starts, but its ends are not joined: model "
                              "a part with supports of symmetry, or take a plane solid or a "
                              "shell; slit: yes leaves it open");
    }
    return curve;
}

template <class Entries>
BeamDescription make(const Entries& entries, const CaseContext& context) {
    const int dimension = entries.geometry.dimension();
    const bool isInSpace = dimension == 3;
    if (isInSpace && context.isCoupled) {
        throw entries.error("coupling", "a line in space cannot be coupled: without torsion "
                                        "nothing says how its surface moves; couple a shell or "
                                        "solid, or a line in the plane");
    }
    requireUsable(entries.model, isInSpace);
    BeamDescription line{makeAxis(entries.geometry, entries.discretisation),
                         makeSection(entries, isInSpace),
                         entries.model.strains,
                         {},
                         {},
                         dimension};
    for (const BeamSupportEntries& support : entries.supports) {
        line.supports.push_back(makeSupport(support, isInSpace));
    }
    for (const CableLoadEntries& load : entries.loads) {
        addLoad(load, dimension, line.loads);
    }
    return line;
}

} // namespace

BeamDescription makeBeam(const BeamEntries& entries, const CaseContext& context) {
    return make(entries, context);
}

BeamDescription makeCable(const CableEntries& entries, const CaseContext& context) {
    return make(entries, context);
}

} // namespace tokay::structure
