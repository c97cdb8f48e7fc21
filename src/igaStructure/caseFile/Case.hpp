#pragma once

#include "coupling/CouplingOptions.hpp"
#include "geometry/NurbsSurface.hpp"
#include "igaStructure/caseFile/OutputOptions.hpp"
#include "igaStructure/model/Loads.hpp"
#include "igaStructure/model/Material.hpp"
#include "igaStructure/model/Strains.hpp"
#include "igaStructure/model/Supports.hpp"
#include "igaStructure/timeIntegration/NewtonOptions.hpp"
#include "igaStructure/timeIntegration/TimeScheme.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

/// Time steps of a run alone, which begins at 0.
struct TimeSteps {
    double step; ///< [s]
    double end;  ///< [s]
};

/// Entries of `coupling` in the case file.
struct Coupling {
    std::vector<geometry::Edge> interface;
    double gapLimit; ///< relative to the interface's extent
    coupling::CouplingOptions options;
};

/// All that a case file says, checked and with its defaults.
struct Case {
    std::string name;
    std::string file;
    std::string directory;          ///< of the case file; results go below it
    geometry::NurbsSurface surface; ///< refined
    Strains strains;
    Material material;
    std::vector<Support> supports;
    Loads loads;
    TimeScheme timeScheme;
    std::optional<TimeSteps> timeSteps;
    NewtonOptions newton;
    OutputOptions output;
    std::optional<Coupling> coupling;
};

} // namespace tokay::structure
