// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Formula.hpp"
#include "geometry/spline/NurbsCurve.hpp"
#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/SupportTrace.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// Resultant properties of a beam or cable, for its whole width.
struct BeamSection {
    double axialStiffness = 0;   ///< [N]
    double bendingStiffness = 0; ///< 0: a cable [N m^2]
    double prestress = 0;        ///< axial force in the reference configuration [N]
    double mass = 0;             ///< per length [kg/m]
    double rotaryInertia = 0;    ///< per length; 0: neglected [kg m]
    double thickness = 0;        ///< [m]
    double width = 1;            ///< across the plane [m]
    double massDamping = 0;      ///< Rayleigh [1/s]
    double stiffnessDamping = 0; ///< Rayleigh [s]

    bool bends() const { return bendingStiffness > 0; }
};

/// An end of a beam: where its parameter starts, or ends.
enum class BeamEnd { start, end };

/// Support of an end of a beam.
struct BeamSupport {
    BeamEnd end;
    bool x = false;
    bool y = false;
    bool rotation = false;
    bool z = false; ///< in space
    SupportMotion motion = nullptr;
    std::string name = {};
};

/// A force that keeps its direction, and in the plane a moment (counter-clockwise),
/// on an end of a beam, for its whole width.
struct EndLoad {
    BeamEnd end;
    std::optional<std::vector<Formula>> force; ///< x, y and in space z [N]
    std::optional<Formula> moment;             ///< [N m]
};

/// Vectors have the components x, y and in space z.
struct BeamLoads {
    std::vector<EndLoad> ends;
    /// Per reference area; they keep their direction [Pa].
    std::vector<std::vector<Formula>> tractions;
    std::vector<std::vector<Formula>> gravities; ///< [m/s^2]
    std::vector<Formula> pressures; ///< in the plane, on the left side, follow the motion [Pa]
};

/// Description of a beam or cable: all that a case file says of it.
struct BeamDescription {
    geometry::NurbsCurve curve; ///< refined
    BeamSection section;
    Strains strains;
    std::vector<BeamSupport> supports;
    BeamLoads loads;
    int dimension; ///< 2: in the plane z = 0; 3: in space
};

} // namespace tokay::structure
