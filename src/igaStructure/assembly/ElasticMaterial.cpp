// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/ElasticMaterial.hpp"

#include <fmt/format.h>

#include <limits>

namespace tokay::structure {

namespace {

const char* nameOf(MaterialLaw law) {
    switch (law) {
    case MaterialLaw::stVenantKirchhoff:
        return "St. Venant-Kirchhoff";
    case MaterialLaw::neoHookean:
        return "neo-Hookean";
    case MaterialLaw::incompressibleNeoHookean:
        return "incompressible neo-Hookean";
    }
    return "";
}

} // namespace

double ElasticMaterial::lambda() const {
    return law == MaterialLaw::incompressibleNeoHookean
               ? std::numeric_limits<double>::infinity()
               : youngsModulus * poissonsRatio / ((1 + poissonsRatio) * (1 - 2 * poissonsRatio));
}

double ElasticMaterial::mu() const {
    return law == MaterialLaw::incompressibleNeoHookean ? youngsModulus / 3
                                                        : youngsModulus / (2 * (1 + poissonsRatio));
}

double ElasticMaterial::planeStressModulus() const {
    return youngsModulus / (1 - poissonsRatio * poissonsRatio);
}

std::string ElasticMaterial::description() const {
    return fmt::format("{}: E {:g} Pa, nu {:g}, density {:g} kg/m^3", nameOf(law), youngsModulus,
                       poissonsRatio, density);
}

} // namespace tokay::structure
