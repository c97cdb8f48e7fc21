// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tokay {

/// An entry by its path, "acceleration.type", and its value as a file gives it.
struct PresetEntry {
    std::string name;
    std::string value;
};

/// A named set of defaults of a coupled run that trades accuracy for cost. An entry that a
/// file gives wins. Both sides have the same names; each sets the entries of its own files.
struct CouplingPreset {
    std::string name;
    std::string meaning;
    std::string tolerance;                   ///< in residualControl: of coupling and velocity
    std::vector<PresetEntry> functionObject; ///< of structureCoupling
    std::vector<PresetEntry> caseFile;       ///< of `coupling` in the structure's case file
};

/// All presets. What each costs and how accurate it is: benchmarks/fsi.
inline const std::vector<CouplingPreset>& couplingPresets() {
    static const std::vector<CouplingPreset> presets = {
        {"fast",
         "displacements to about a percent; forces may be noise.",
         "1e-3",
         {{"pressureTolerance", "relaxed"}},
         {{"predictor", "quadratic"}}},
        {"balanced",
         "displacements to a few thousandths, less than what the usual time steps leave.",
         "1e-4",
         {{"pressureTolerance", "relaxed"}},
         {{"predictor", "quadratic"}}},
        {"reference",
         "displacements to some 1e-6, forces to a thousandth.",
         "1e-6",
         {{"pressureTolerance", "relaxed"}},
         {{"predictor", "quadratic"}}}};
    return presets;
}

/// The preset of a name; null if there is none.
inline const CouplingPreset* findCouplingPreset(const std::string& name) {
    for (const CouplingPreset& preset : couplingPresets()) {
        if (preset.name == name) {
            return &preset;
        }
    }
    return nullptr;
}

/// "predictor linear, pressureTolerance fixed"; "nothing" of none.
inline std::string listed(const std::vector<PresetEntry>& entries) {
    std::string text;
    for (const PresetEntry& entry : entries) {
        text += (text.empty() ? "" : ", ") + entry.name + " " + entry.value;
    }
    return text.empty() ? "nothing" : text;
}

/// What a log says of a preset: the entries that it has set.
inline std::string describePreset(const std::string& name, const std::vector<PresetEntry>& set) {
    return "preset " + name + " sets " + listed(set) +
           (set.empty() ? ": all of its entries are given" : "");
}

} // namespace tokay
