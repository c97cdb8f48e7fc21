#pragma once

#include "geometry/NurbsSurface.hpp"
#include "igaStructure/caseFile/Formula.hpp"
#include "igaStructure/caseFile/OutputOptions.hpp"
#include "igaStructure/model/Material.hpp"
#include "igaStructure/timeIntegration/NewtonOptions.hpp"
#include "igaStructure/timeIntegration/TimeScheme.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// Zero displacement components of an edge.
struct Support {
    geometry::Edge edge = geometry::Edge::bottom;
    std::array<bool, 2> fixed = {false, false};
};

/// Force per reference area on an edge [Pa]; keeps its direction.
struct EdgeTraction {
    geometry::Edge edge = geometry::Edge::left;
    std::array<Formula, 2> traction;
};

/// Acceleration field that acts on the mass [m/s^2].
struct Gravity {
    std::array<Formula, 2> acceleration;
};

/// Time steps of a run alone.
struct TimeSteps {
    double step = 0; ///< [s]
    double end = 0;  ///< [s]
};

/// All that a case file says, checked.
struct Case {
    std::string name;
    std::string file;
    std::string directory;          ///< of the case file; results go below it
    geometry::NurbsSurface surface; ///< refined
    bool nonlinear = false;
    Material material;
    std::vector<Support> supports;
    std::vector<EdgeTraction> tractions;
    std::vector<Gravity> gravities;
    TimeScheme timeScheme;
    std::optional<TimeSteps> timeSteps;
    NewtonOptions newton;
    OutputOptions output;
    std::optional<CouplingOptions> coupling;
};

/// @throws InputError for the first mistake
Case readCase(const std::string& fileName);

} // namespace tokay::structure
