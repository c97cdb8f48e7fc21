// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace tokay::structure {

/// The flap of exampleText() as a beam, with one piece of its text replaced.
/// @param from  must occur in it
inline std::string exampleBeamText(const std::string& from = "", const std::string& to = "") {
    std::string text = "geometry:\n"
                       "  line: {from: [0, 0], to: [0, 1]}\n"
                       "discretisation: {degree: [3], elements: [8]}\n"
                       "model: {kinematics: beam, strains: nonlinear, thickness: 0.1}\n"
                       "material:\n"
                       "  type: StVenantKirchhoff\n"
                       "  youngsModulus: 4e6\n"
                       "  poissonsRatio: 0.3\n"
                       "  density: 3000\n"
                       "supports:\n"
                       "  - {end: start, fix: [x, y, rotation]}\n"
                       "loads:\n"
                       "  - {traction: [\"100*y\", 0]}\n"
                       "time: {step: 0.01, end: 0.1}\n"
                       "output:\n"
                       "  watchPoints:\n"
                       "    - {name: tip, at: [0, 1]}\n"
                       "    - {name: corner, at: [0.05, 1]}\n";
    const auto place = text.find(from);
    if (place == std::string::npos) {
        throw std::logic_error("the example has no '" + from + "'");
    }
    return text.replace(place, from.size(), to);
}

} // namespace tokay::structure
