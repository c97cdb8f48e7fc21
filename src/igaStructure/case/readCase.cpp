// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/case/readCase.hpp"

#include "common/couplingPresets.hpp"
#include "common/digest.hpp"
#include "coupling/couplingMethods.hpp"
#include "igaStructure/case/kinematicsTypes.hpp"
#include "igaStructure/caseFile/describeSchema.hpp"
#include "igaStructure/caseFile/readOptions.hpp"
#include "igaStructure/caseFile/readValue.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>

namespace tokay::structure {

namespace {

/// Entries of a case file that every kinematics has alike.
struct CommonEntries : Located {
    std::optional<std::string> name;
    TimeOptions time;
    NewtonOptions newton;
    OutputOptions output;

    static const SchemaOf<CommonEntries>& schema() {
        static const SchemaOf<CommonEntries> schema = {
            {"name", &CommonEntries::name, "Name of the case in the names of results.",
             otherwise("the case file's name without .yaml")},
            {"time", &CommonEntries::time, "Time integration.", otherwise("`{}`")},
            {"newton", &CommonEntries::newton, "Newton's method, with nonlinear strains.",
             otherwise("`{}`")},
            {"output", &CommonEntries::output, "Results.", otherwise("`{}`")}};
        return schema;
    }

    void requireValid() const {
        time.requireValid();
        output.requireValid();
    }

    // The name becomes one of files and a folder, and stands in XML.
    std::string usableName(const std::string& fileName) const {
        const std::string usable = name.value_or(std::filesystem::path(fileName).stem().string());
        const bool isUsable = !usable.empty() && usable.front() != '.' &&
                              std::none_of(usable.begin(), usable.end(), [](unsigned char c) {
                                  return std::iscntrl(c) || std::strchr("/\\<>&\"'", c);
                              });
        if (!isUsable) {
            throw error("name", fmt::format("'{}' cannot name results; take letters, digits, "
                                            "blanks, '-', '_' and '.', not '.' first",
                                            shortened(usable)));
        }
        return usable;
    }
};

std::vector<Alternative> kinematicsNames() {
    std::vector<Alternative> names;
    for (const KinematicsType& type : kinematicsTypes()) {
        names.push_back({type.name, type.meaning, {}});
    }
    return names;
}

std::vector<Alternative> presetNames() {
    std::vector<Alternative> names;
    for (const Choice<std::string>& choice : presetChoices()) {
        names.push_back({choice.name, choice.meaning, {}});
    }
    return names;
}

/// Adds an entry by its path, "acceleration.type", unless it is there.
/// @return whether it was added
bool addIfMissing(const LocatedNode& map, const std::string& path, const std::string& value) {
    if (!map.node.IsMap()) {
        return false; // the reader says what is wrong
    }
    const std::size_t dot = path.find('.');
    const std::string first = path.substr(0, dot);
    YAML::Node node = map.node; // shares the map
    if (dot == std::string::npos) {
        const bool isMissing = !map.has(first);
        if (isMissing) {
            node[first] = value;
        }
        return isMissing;
    }
    if (!map.has(first)) {
        node[first] = YAML::Node(YAML::NodeType::Map);
    }
    return addIfMissing(map.child(first), path.substr(dot + 1), value);
}

/// Reads the root of a case file.
class CaseReader {
  public:
    explicit CaseReader(LocatedNode root) : root_(std::move(root)) {}

    Case read() {
        const KinematicsType& kinematics = findKinematics();
        const std::unique_ptr<BodyEntries> body = kinematics.makeEntries();
        CommonEntries common;
        setDefaults(kinematics, common, body->coupling());
        applyPreset(body->coupling());
        readEntries(kinematics, common, *body);
        common.requireValid();
        return make(common, *body);
    }

  private:
    // The kinematics decides about all entries: it is looked up before they are read.
    const KinematicsType& findKinematics() const {
        if (!root_.node.IsMap()) {
            throw wrongKind(root_, "a map with the entries name, geometry, model, ...");
        }
        const LocatedNode model = root_.child("model");
        const LocatedNode word =
            model.node.IsDefined() && model.node.IsMap() ? model.child("kinematics") : model;
        return word.node.IsDefined() && word.node.IsScalar()
                   ? kinematicsTypes()[readChoice(word, kinematicsNames())]
                   : kinematicsTypes().front(); // the reader says what is missing
    }

    // Defaults that depend on other sections. Mistakes in these are reported here, too.
    void setDefaults(const KinematicsType& kinematics, CommonEntries& common, Coupling& coupling) {
        const LocatedNode section = root_.child("time");
        TimeOptions time;
        if (section.node.IsDefined()) {
            readOptions(section, time);
        }
        context_.isExplicit = time.scheme == TimeOptions::centralDifferences;
        context_.isDynamic = time.scheme != TimeOptions::quasiStatic;
        context_.isCoupled = root_.child("coupling").node.IsDefined();
        common.newton.lineSearch = !kinematics.bendsThinly;
        common.newton.reuseContraction = time.scheme == TimeOptions::quasiStatic ? 0 : 0.1;
        coupling.substeps = time.substeps;
        if (time.substeps > 1) {
            coupling.options.acceleration.type = "iqnIls";
        }
    }

    // A preset's entries that the file does not give are added to it.
    void applyPreset(Coupling& coupling) const {
        const LocatedNode section = root_.child("coupling");
        if (!section.node.IsDefined() || !section.has("preset")) {
            return;
        }
        const CouplingPreset& preset =
            couplingPresets()[readChoice(section.child("preset"), presetNames())];
        std::vector<PresetEntry> set;
        for (const PresetEntry& entry : preset.caseFile) {
            if (addIfMissing(section, entry.name, entry.value)) {
                set.push_back(entry);
            }
        }
        coupling.presetReport = fmt::format("  {}\n", describePreset(preset.name, set));
    }

    void readEntries(const KinematicsType& kinematics, CommonEntries& common, BodyEntries& body) {
        struct Both {
            void* common;
            void* body;
        } both{&common, body.entries()};
        const Schema bodySchema =
            kinematics.schema->in([](void* all) { return static_cast<Both*>(all)->body; });
        Schema schema =
            CommonEntries::schema().in([](void* all) { return static_cast<Both*>(all)->common; });
        schema.entries.insert(schema.entries.begin() + 1, bodySchema.entries.begin(),
                              bodySchema.entries.end());
        schema.locate = [&kinematics](void* all, const Located& location) {
            CommonEntries::schema().locate(static_cast<Both*>(all)->common, location);
            kinematics.schema->locate(static_cast<Both*>(all)->body, location);
        };
        MadeChoice choice{kinematics.name, {}};
        for (const KinematicsType& other : kinematicsTypes()) {
            choice.others.push_back(other.schema);
        }
        readOptions(root_, schema, &both, choice);
    }

    Case make(const CommonEntries& common, BodyEntries& body) {
        const std::filesystem::path path(root_.file);
        context_.directory = path.has_parent_path() ? path.parent_path().string() : ".";
        Case result{common.usableName(root_.file),
                    root_.file,
                    context_.directory,
                    body.make(context_),
                    common.time.scheme(common.time),
                    std::nullopt,
                    common.newton,
                    common.output,
                    std::nullopt,
                    root_.child("supports").error("").what(),
                    geometryPlace(),
                    digest("geometry") + digest("discretisation")};
        if (const auto& step = common.time.step) {
            result.timeSteps = {*step, *common.time.end, common.time.minDeltaT.value_or(*step)};
        }
        result.output.directory =
            (std::filesystem::path(context_.directory) / common.output.directory).string();
        if (context_.isCoupled) {
            requireValid(body.coupling());
            result.coupling = body.coupling();
        }
        return result;
    }

    // The tangent of the block method is that of one step of the structure.
    static void requireValid(const Coupling& coupling) {
        structure::requireValid(coupling);
        if (coupling.substeps > 1 && coupling.options.acceleration.type == "block") {
            throw coupling.error("acceleration",
                                 fmt::format("type 'block' does not go with time.substeps {}: its "
                                             "tangent is that of a single step; choose iqnIls or "
                                             "mvqn, or remove time.substeps",
                                             coupling.substeps));
        }
        try {
            coupling::requireValid(coupling.options);
        } catch (const InputError& error) {
            throw coupling.error("acceleration", error.what()); // options that exclude each other
        }
    }

    // Of a NURBS its control points.
    std::string geometryPlace() const {
        const LocatedNode geometry = root_.child("geometry");
        const LocatedNode shape = geometry.child(geometry.node.begin()->first.Scalar());
        const LocatedNode points = shape.node.IsMap() ? shape.child("controlPoints") : shape;
        return (points.node.IsDefined() ? points : shape).error("").what();
    }

    std::string digest(const std::string& section) const {
        YAML::Emitter text;
        text << YAML::Flow << root_.child(section).node;
        return tokay::digest(text.c_str());
    }

    LocatedNode root_;
    CaseContext context_;
};

} // namespace

Case readCase(const std::string& fileName) {
    return CaseReader(readYaml(fileName)).read();
}

Case readCaseText(const std::string& text, const std::string& fileName) {
    return CaseReader(parseYaml(text, fileName)).read();
}

std::string describeCaseEntries() {
    SchemaTables tables;
    std::string text = "\n## Entries of every case\n" + tables.table("", CommonEntries::schema());
    text += "\n## Kinematics\n\n`model.kinematics` decides which other entries there are.\n\n"
            "| kinematics | meaning |\n|---|---|\n";
    for (const KinematicsType& type : kinematicsTypes()) {
        text += fmt::format("| `{}` | {} |\n", type.name, type.meaning);
    }
    for (const KinematicsType& type : kinematicsTypes()) {
        text += fmt::format("\n### kinematics: {}\n", type.name) + tables.table("", *type.schema);
    }
    return text;
}

} // namespace tokay::structure
