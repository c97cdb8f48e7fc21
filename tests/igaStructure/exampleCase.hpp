// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "igaStructure/case/readCase.hpp"

#include <string>

namespace tokay::structure {

/// A valid case file, with one piece of its text replaced.
/// @param from  must occur in it
inline std::string exampleText(const std::string& from = "", const std::string& to = "") {
    std::string text = "geometry:\n"
                       "  rectangle: {origin: [-0.05, 0], size: [0.1, 1]}\n"
                       "discretisation:\n"
                       "  degree: [2, 3]\n"
                       "  elements: [1, 8]\n"
                       "model:\n"
                       "  kinematics: planeStrain\n"
                       "  strains: linear\n"
                       "material:\n"
                       "  type: StVenantKirchhoff\n"
                       "  youngsModulus: 4e6\n"
                       "  poissonsRatio: 0.3\n"
                       "  density: 3000\n"
                       "supports:\n"
                       "  - {edge: bottom, fix: [x, y]}\n"
                       "loads:\n"
                       "  - {edge: left, traction: [\"100*y\", 0]}\n"
                       "time:\n"
                       "  step: 0.01\n"
                       "  end: 0.1\n"
                       "output:\n"
                       "  watchPoints:\n"
                       "    - {name: tip, at: [0, 1]}\n";
    const auto place = text.find(from);
    if (place == std::string::npos) {
        throw std::logic_error("the example has no '" + from + "'");
    }
    return text.replace(place, from.size(), to);
}

inline Case readText(const std::string& text, const std::string& fileName = "case.yaml") {
    return readCaseText(text, fileName);
}

} // namespace tokay::structure
