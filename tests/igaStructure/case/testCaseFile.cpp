// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/couplingPresets.hpp"
#include "igaStructure/case/kinematicsTypes.hpp"
#include "igaStructure/exampleCase.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>
#include <sstream>

using namespace tokay;
using namespace tokay::structure;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

std::string mistake(const std::string& text) {
    try {
        readText(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string mistake(const std::string& from, const std::string& to) {
    return mistake(exampleText(from, to));
}

} // namespace

TEST(CaseFile, valid_file_is_read_with_its_values_and_defaults) {
    const Case read = readText(exampleText());
    EXPECT_EQ(read.name, "case");
    const auto& solid = std::get<PlaneSolidCase>(read.structure);
    EXPECT_EQ(solid.surface.nControlPoints(), 3 * 11);
    EXPECT_EQ(solid.material.youngsModulus, 4e6);
    EXPECT_EQ(solid.material.thickness, 1);
    EXPECT_TRUE(solid.supports.at(0).fixed[0] && solid.supports.at(0).fixed[1]);
    EXPECT_EQ(solid.loads.tractions.at(0).traction[0]({0, 0.5, 0}, 0), 50);
    EXPECT_EQ(read.timeSteps->step, 0.01);
    EXPECT_EQ(read.output.interval, 10);
    EXPECT_FALSE(read.coupling);
}

TEST(CaseFile, tangents_are_kept_unless_the_run_is_static_or_the_file_says_otherwise) {
    EXPECT_EQ(readText(exampleText()).newton.reuseContraction, 0.1);
    EXPECT_EQ(readText(exampleText("time:", "time:\n  scheme: static")).newton.reuseContraction, 0);
    const std::string given = "newton: {reuseContraction: 0.3}\ntime:";
    EXPECT_EQ(readText(exampleText("time:", given)).newton.reuseContraction, 0.3);
    EXPECT_EQ(readText(exampleText("time:", given + "\n  scheme: static")).newton.reuseContraction,
              0.3);
}

TEST(CaseFile, unknown_entry_is_reported_with_place_and_the_closest_known_one) {
    EXPECT_THAT(mistake("poissonsRatio", "poisonsRatio"),
                AllOf(HasSubstr("case.yaml:12:3: material: unknown entry 'poisonsRatio'"),
                      HasSubstr("did you mean 'poissonsRatio'?"), HasSubstr("youngsModulus")));
}

TEST(CaseFile, nothing_is_suggested_for_an_entry_that_resembles_none) {
    EXPECT_THAT(mistake("  density: 3000", "  density: 3000\n  colour: 1"),
                AllOf(HasSubstr("case.yaml:14:3: material: unknown entry 'colour'; known here"),
                      Not(HasSubstr("did you mean"))));
}

TEST(CaseFile, entry_given_twice_is_reported_with_both_lines) {
    EXPECT_THAT(mistake("  density: 3000", "  density: 3000\n  density: 1"),
                AllOf(HasSubstr("case.yaml:14:3: material: entry 'density' is given twice"),
                      HasSubstr("line 13")));
}

TEST(CaseFile, missing_entry_is_reported_with_its_meaning) {
    EXPECT_THAT(mistake("  density: 3000\n", ""),
                AllOf(HasSubstr("case.yaml:10:3: material: entry 'density' is missing"),
                      HasSubstr("Density in the reference configuration")));
}

TEST(CaseFile, wrong_type_is_reported_with_what_was_given) {
    EXPECT_THAT(mistake("4e6", "stiff"),
                HasSubstr("case.yaml:11:18: material.youngsModulus: must be a number, but is "
                          "'stiff'"));
    EXPECT_THAT(mistake("4e6", "[1, 2]"), HasSubstr("must be a number, but is a list"));
    EXPECT_THAT(mistake("4e6", ".nan"), HasSubstr("must be a finite number"));
    EXPECT_THAT(mistake("[1, 8]", "[1, 2.5]"),
                HasSubstr("case.yaml:5:17: discretisation.elements[1]: must be an integer"));
    EXPECT_THAT(mistake("output:", "newton: {lineSearch: 3}\noutput:"),
                HasSubstr("newton.lineSearch: must be yes or no, but is '3'"));
    EXPECT_THAT(mistake("time:\n  step: 0.01\n  end: 0.1\n", "time: 3\n"),
                HasSubstr("time: must be a map with the entries scheme"));
}

TEST(CaseFile, value_out_of_range_is_reported_with_the_range) {
    EXPECT_THAT(mistake("0.3", "0.5"),
                HasSubstr("case.yaml:12:18: material.poissonsRatio: 0.5 is out of range; allowed: "
                          "(-1, 0.5)"));
    EXPECT_THAT(mistake("4e6", "0"), HasSubstr("allowed: (0, inf) Pa"));
    EXPECT_THAT(mistake("[1, 8]", "[0, 8]"), HasSubstr("elements[0]: 0 is out of range"));
}

TEST(CaseFile, word_that_is_not_allowed_is_reported_with_the_allowed_ones) {
    EXPECT_THAT(mistake("planeStrain", "planestrain"),
                AllOf(HasSubstr("model.kinematics: 'planestrain' is not allowed; did you mean "
                                "'planeStrain'?"),
                      HasSubstr("allowed: planeStrain, planeStress")));
    EXPECT_THAT(mistake("edge: bottom", "edge: base"),
                HasSubstr("case.yaml:15:12: supports[0].edge: 'base' is not allowed"));
}

TEST(CaseFile, list_of_wrong_length_is_reported) {
    EXPECT_THAT(mistake("[0.1, 1]", "[0.1, 1, 2]"),
                HasSubstr("geometry.rectangle.size: must have 2 values, but has 3"));
    EXPECT_THAT(mistake("fix: [x, y]", "fix: []"), HasSubstr("supports[0].fix: is empty"));
}

TEST(CaseFile, formula_that_cannot_be_read_is_reported_with_its_place) {
    EXPECT_THAT(mistake("100*y", "100*w"),
                AllOf(HasSubstr("case.yaml:17:29: loads[0].traction[0]: formula '100*w'"),
                      HasSubstr("\"w\""), HasSubstr("variables are x, y, z [m] and t [s]")));
    EXPECT_THAT(mistake("100*y", "sin("), HasSubstr("formula 'sin(' cannot be read"));
}

TEST(CaseFile, text_that_is_not_YAML_is_reported_with_its_place) {
    EXPECT_THAT(mistake("size: [0.1, 1]", "size: [0.1, 1"),
                AllOf(HasSubstr("case.yaml:"), HasSubstr("this is not YAML")));
    EXPECT_THAT(mistake(""), HasSubstr("must be a map with the entries name, geometry"));
}

TEST(CaseFile, file_that_does_not_exist_is_reported) {
    EXPECT_THROW(
        {
            try {
                readCase("nowhere/case.yaml");
            } catch (const InputError& error) {
                EXPECT_STREQ(error.what(), "cannot read case file 'nowhere/case.yaml': No such "
                                           "file or directory");
                throw;
            }
        },
        InputError);
}

TEST(CaseFile, entries_that_exclude_each_other_are_reported) {
    EXPECT_THAT(mistake("  rectangle: {origin: [-0.05, 0], size: [0.1, 1]}\n", "  {}\n"),
                HasSubstr("geometry: give exactly one of: rectangle, nurbs"));
    EXPECT_THAT(mistake("[2, 3]", "[2, 0]"), HasSubstr("degree[1]: 0 is out of range"));
    EXPECT_THAT(
        mistake("  strains: linear", "  strains: linear\n  thickness: 2"),
        HasSubstr(
            "model: 'thickness' is not an option of planeStrain; allowed: kinematics, strains"));
    EXPECT_THAT(mistake("planeStrain", "planeStress"),
                HasSubstr("model: entry 'thickness' is missing: Thickness of the plate"));
    EXPECT_THAT(mistake("traction: [\"100*y\", 0]", "traction: [0]"),
                HasSubstr("loads[0].traction: must have 2 values, but has 1"));
    EXPECT_THAT(mistake("edge: bottom, ", ""),
                HasSubstr("supports[0]: entry 'edge' is missing: Constrained edge"));
    EXPECT_THAT(mistake("output:", "coupling: {}\noutput:"),
                HasSubstr("coupling: entry 'interface' is missing: Wet edges"));
    EXPECT_THAT(
        mistake("output:", "coupling: {interface: [left], mapping: {type: offset}}\noutput:"),
        HasSubstr("mapping.type: 'offset' is not allowed; allowed: nearestElement"));
    EXPECT_THAT(mistake("at: [0, 1]", "at: [0]"),
                HasSubstr("output.watchPoints[0].at: must be [x, y] or [x, y, z]"));
    EXPECT_THAT(mistake("traction: [\"100*y\", 0]", "gravity: [0, -1]"),
                HasSubstr("loads[0]: give either edge and traction, or gravity alone"));
    EXPECT_THAT(
        mistake("  step: 0.01\n", "  step: 0.01\n  beta: 0.3\n"),
        HasSubstr(
            "time: 'beta' is not an option of generalisedAlpha; allowed: scheme, spectralRadius"));
    EXPECT_THAT(
        mistake("  step: 0.01\n", "  step: 0.01\n  scheme: static\n  substeps: 4\n"),
        HasSubstr("time: 'substeps' is not an option of static; allowed: scheme, minDeltaT"));
    EXPECT_THAT(mistake("  end: 0.1\n", ""), HasSubstr("time: entry 'end' is missing"));
    EXPECT_THAT(mistake("end: 0.1", "end: 0.001"), HasSubstr("shorter than one step"));
    EXPECT_THAT(mistake("output:", "coupling:\n  interface: [left]\n  acceleration: {type: aitken, "
                                   "reusedTimeSteps: 3}\noutput:"),
                HasSubstr("coupling.acceleration: 'reusedTimeSteps' is not an option of aitken"));
}

namespace {

/// Log of the coupling's options without the line of the preset.
std::string optionsOf(const std::string& coupling) {
    std::string text =
        describeCoupling(*readText(exampleText("output:", coupling + "output:")).coupling);
    const auto line = text.find("  preset");
    if (line != std::string::npos) {
        text.erase(line, text.find('\n', line) + 1 - line);
    }
    return text;
}

/// "  acceleration: {type: block}\n"
std::string asYaml(const PresetEntry& entry) {
    const auto dot = entry.name.find('.');
    return dot == std::string::npos ? "  " + entry.name + ": " + entry.value + "\n"
                                    : "  " + entry.name.substr(0, dot) + ": {" +
                                          entry.name.substr(dot + 1) + ": " + entry.value + "}\n";
}

} // namespace

TEST(CaseFile, preset_is_the_same_as_its_entries) {
    for (const CouplingPreset& preset : couplingPresets()) {
        std::string entries;
        for (const PresetEntry& entry : preset.caseFile) {
            entries += asYaml(entry);
        }
        const std::string coupling = "coupling:\n  interface: [left]\n";
        const std::string named = coupling + "  preset: " + preset.name + "\n";
        EXPECT_EQ(optionsOf(named), optionsOf(coupling + entries)) << preset.name;
        const Case read = readText(exampleText("output:", named + "output:"));
        EXPECT_THAT(describeCoupling(*read.coupling),
                    HasSubstr("preset " + preset.name + " sets " + listed(preset.caseFile)));
    }
}

TEST(CaseFile, balanced_preset_is_the_default) {
    const std::string coupling = "coupling:\n  interface: [left]\n";
    EXPECT_EQ(optionsOf(coupling + "  preset: balanced\n"), optionsOf(coupling));
}

TEST(CaseFile, entry_that_is_given_wins_over_the_preset) {
    const std::string coupling = "coupling:\n  interface: [left]\n  preset: reference\n";
    const Case read = readText(exampleText("output:", coupling + "  predictor: constant\noutput:"));
    EXPECT_EQ(read.coupling->options.predictor, coupling::Extrapolation::constant);
    EXPECT_THAT(describeCoupling(*read.coupling), Not(HasSubstr("sets predictor")));
}

TEST(CaseFile, preset_that_is_none_is_reported_with_its_place) {
    EXPECT_THAT(mistake("output:", "coupling:\n  interface: [left]\n  preset: quick\noutput:"),
                AllOf(HasSubstr("case.yaml:23:11: coupling.preset: 'quick' is not allowed"),
                      HasSubstr("allowed: fast, balanced, reference")));
    EXPECT_THAT(mistake("output:", "coupling:\n  interface: [left]\n  preset: [fast]\noutput:"),
                HasSubstr("coupling.preset: must be one of: fast, balanced, reference"));
}

TEST(CaseFile, substeps_do_not_go_with_the_block_method) {
    const std::string time = "time:\n";
    const std::string text = exampleText("output:", "coupling:\n  interface: [left]\noutput:");
    const auto withSubsteps = [&](std::string whole) {
        return whole.replace(whole.find(time), time.size(), time + "  substeps: 4\n");
    };
    const Case given = readText(withSubsteps(text));
    EXPECT_EQ(given.coupling->substeps, 4);
    EXPECT_EQ(given.coupling->options.acceleration.type, "iqnIls");
    EXPECT_EQ(readText(text).coupling->substeps, 1);
    std::string block = text;
    block.replace(block.find("[left]\noutput"), 7, "[left]\n  acceleration: {type: block}\n");
    EXPECT_EQ(readText(block).coupling->options.acceleration.type, "block");
    try {
        readText(withSubsteps(block));
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("coupling.acceleration: type 'block' does not go with "
                                            "time.substeps 4"));
        EXPECT_THAT(error.what(), HasSubstr("case.yaml:"));
    }
}

TEST(CaseFile, nurbs_patch_that_does_not_fit_its_knots_is_reported_with_its_place) {
    const std::string patch = "  nurbs: {degree: [1, 1], knotsXi: [0, 0, 1, 1], knotsEta: [0, 0, "
                              "1, 1], controlPoints: [[0, 0], [1, 0], [0, 1]]}\n";
    EXPECT_THAT(mistake("  rectangle: {origin: [-0.05, 0], size: [0.1, 1]}\n", patch),
                HasSubstr("case.yaml:2:10: geometry.nurbs: "));
}

namespace {

// Visits each entry of a schema and of the sections, lists and choices inside it.
void forEachEntry(const Schema& schema, void* options, const std::string& path,
                  const std::function<void(const Entry&, void*, const std::string&)>& visit) {
    for (const Entry& entry : schema.entries) {
        const std::string name = path + entry.name;
        visit(entry, options, name);
        const Slot slot = entry.slot(options);
        if (const auto* section = std::get_if<Section>(&slot)) {
            forEachEntry(*section->schema, section->options, name + ".", visit);
        } else if (const auto* list = std::get_if<SectionList>(&slot)) {
            forEachEntry(*list->schema, list->append(), name + "[].", visit);
        }
        for (const Alternative& alternative : entry.alternatives) {
            for (const Entry& own : alternative.own.entries) {
                EXPECT_FALSE(own.meaning.empty()) << path << own.name;
            }
        }
    }
}

} // namespace

TEST(CaseFile, every_entry_has_a_unique_path_and_a_meaning_and_its_default_is_in_its_range) {
    for (const KinematicsType& kinematics : kinematicsTypes()) {
        std::set<std::string> paths;
        const auto body = kinematics.makeEntries();
        const auto visit = [&](const Entry& entry, void* options, const std::string& path) {
            EXPECT_TRUE(paths.insert(path).second) << kinematics.name << ": " << path;
            EXPECT_FALSE(entry.meaning.empty()) << kinematics.name << ": " << path;
            if (entry.fallback.isRequired || (entry.isSet && !entry.isSet(options))) {
                return;
            }
            const Slot slot = entry.slot(options);
            if (const auto* number = std::get_if<double*>(&slot)) {
                EXPECT_TRUE(entry.range.contains(**number)) << path << ": " << **number;
            } else if (const auto* integer = std::get_if<int*>(&slot)) {
                EXPECT_TRUE(entry.range.contains(**integer)) << path << ": " << **integer;
            }
        };
        forEachEntry(*kinematics.schema, body->entries(), "", visit);
        EXPECT_GT(paths.size(), 20u) << kinematics.name;
    }
}

TEST(CaseFile, manual_has_the_table_of_entries_as_the_reader_uses_it) {
    std::ifstream file(TOKAY_SOURCE_DIR "/doc/reference/caseFile.md");
    std::ostringstream manual;
    manual << file.rdbuf();
    EXPECT_THAT(manual.str(), HasSubstr(describeCaseEntries()))
        << "igaStructure entries prints what doc/reference/caseFile.md must contain";
}
