// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJson.hpp"
#include "geometry/brep/cadJsonSplines.hpp"
#include "geometry/spline/curveParts.hpp"

#include <fmt/format.h>

#include <map>

namespace tokay::geometry {

namespace {

std::string nameOf(const LocatedNode& node) {
    if (node.has("brep_name")) {
        return node.required("brep_name").text();
    }
    return std::to_string(node.required("brep_id").integer());
}

/// Curve of a face by the number that edges call it by.
struct NumberedCurve {
    int trimIndex;
    NurbsCurve curve;
};

NumberedCurve readTrim(const LocatedNode& node, int otherwise) {
    const int index = node.has("trim_index") ? node.required("trim_index").integer() : otherwise;
    const NurbsCurve curve = readCurve(node.required("parameter_curve"));
    const bool isForward =
        !node.has("curve_direction") || node.required("curve_direction").boolean();
    return {index, isForward ? curve : reversed(curve)};
}

/// Curve numbers in the face by "trim_index".
using TrimNumbers = std::map<int, int>;

class FaceReader {
  public:
    explicit FaceReader(const LocatedNode& node) : node_(node) {}

    BrepFace read() {
        const std::string name = nameOf(node_);
        const NurbsSurface surface = readSurface(node_.required("surface"));
        std::vector<TrimmingLoop> loops;
        for (const LocatedNode& loop : node_.itemsOf("boundary_loops")) {
            loops.push_back(readLoop(loop));
        }
        std::vector<NurbsCurve> embedded;
        for (const LocatedNode& loop : node_.itemsOf("embedded_loops")) {
            for (const LocatedNode& curve : loop.required("trimming_curves").items()) {
                embedded.push_back(readCounted(curve));
            }
        }
        for (const LocatedNode& curve : node_.itemsOf("embedded_edges")) {
            embedded.push_back(readCounted(curve));
        }
        const bool isSwapped = node_.has("swapped_surface_normal") &&
                               node_.required("swapped_surface_normal").boolean();
        return node_.make([&] {
            return BrepFace{loops.empty() ? TrimmedPatch(surface, name)
                                          : TrimmedPatch(surface, loops, name),
                            isSwapped, embedded};
        });
    }

    const TrimNumbers& trims() const { return trims_; }

  private:
    NurbsCurve readCounted(const LocatedNode& node) {
        const int number = static_cast<int>(trims_.size());
        NumberedCurve trim = readTrim(node, number);
        if (!trims_.emplace(trim.trimIndex, number).second) {
            throw node.error(
                fmt::format("the trim_index {} occurs twice in this face", trim.trimIndex));
        }
        return std::move(trim.curve);
    }

    TrimmingLoop readLoop(const LocatedNode& node) {
        LoopKind kind = LoopKind::outer;
        if (node.has("loop_type")) {
            const LocatedNode type = node.required("loop_type");
            if (type.text() != "outer" && type.text() != "inner") {
                throw type.error(
                    fmt::format("the loop type \"{}\" must be outer or inner", type.text()));
            }
            kind = type.text() == "outer" ? LoopKind::outer : LoopKind::inner;
        }
        std::vector<NurbsCurve> curves;
        for (const LocatedNode& curve : node.required("trimming_curves").items()) {
            curves.push_back(readCounted(curve));
        }
        return node.make([&] { return TrimmingLoop(kind, curves); });
    }

    const LocatedNode& node_;
    TrimNumbers trims_;
};

class ModelReader {
  public:
    CadJson read(const LocatedNode& root) {
        const std::vector<LocatedNode> breps = root.required("breps").items();
        for (const LocatedNode& brep : breps) {
            for (const LocatedNode& face : brep.itemsOf("faces")) {
                readFace(face);
            }
        }
        if (faces_.empty()) {
            throw root.required("breps").error("there is no face in any brep");
        }
        std::vector<BrepEdge> edges;
        for (const LocatedNode& brep : breps) {
            for (const LocatedNode& edge : brep.itemsOf("edges")) {
                edges.push_back(readEdge(edge));
            }
            if (const std::size_t n = brep.itemsOf("vertices").size()) {
                notes_.push_back(brep.error(fmt::format("{} vertices are not used", n)).what());
            }
        }
        double tolerance = 0;
        if (root.has("tolerances") && root.required("tolerances").has("model_tolerance")) {
            tolerance = root.required("tolerances").required("model_tolerance").number();
        }
        BrepModel model =
            root.make([&] { return BrepModel(std::move(faces_), std::move(edges), tolerance); });
        checkDirections(model);
        return {std::move(model), std::move(notes_)};
    }

  private:
    void readFace(const LocatedNode& node) {
        FaceReader reader(node);
        BrepFace face = reader.read();
        if (!numbers_.emplace(face.patch.name(), static_cast<int>(faces_.size())).second) {
            throw node.error(fmt::format("two faces are named \"{}\"", face.patch.name()));
        }
        trims_.push_back(reader.trims());
        faces_.push_back(std::move(face));
    }

    BrepEdge readEdge(const LocatedNode& node) {
        BrepEdge edge{nameOf(node), {}};
        if (node.has("3d_curve")) {
            edge.curve = readCurve(node.required("3d_curve"));
        }
        for (const LocatedNode& trim : node.itemsOf("topology")) {
            edge.trims.push_back(readTopology(trim));
        }
        return edge;
    }

    BrepTrim readTopology(const LocatedNode& node) const {
        const std::string name = nameOf(node);
        const auto face = numbers_.find(name);
        if (face == numbers_.end()) {
            throw node.error(fmt::format("there is no face \"{}\"", name));
        }
        const LocatedNode index = node.required("trim_index");
        const auto curve = trims_[face->second].find(index.integer());
        if (curve == trims_[face->second].end()) {
            throw index.error(fmt::format("the face \"{}\" has no curve of trim_index {}", name,
                                          index.integer()));
        }
        const bool isForward =
            !node.has("relative_direction") || node.required("relative_direction").boolean();
        return {face->second, curve->second, isForward};
    }

    /// Files differ in what a direction is relative to: points decide.
    void checkDirections(BrepModel& model) {
        std::vector<BrepEdge> edges = model.edges();
        bool changed = false;
        for (BrepEdge& edge : edges) {
            for (std::size_t i = 1; i < edge.trims.size(); ++i) {
                const bool isAlong =
                    runsAlong(model.curveInSpace(edge.trims[0]), model.curveInSpace(edge.trims[i]));
                const bool isForward = isAlong == edge.trims[0].isForward;
                if (isForward == edge.trims[i].isForward) {
                    continue;
                }
                notes_.push_back(
                    fmt::format("edge \"{}\": relative_direction contradicts the curves, "
                                "which are followed",
                                edge.name));
                edge.trims[i].isForward = isForward;
                changed = true;
            }
        }
        if (changed) {
            model = BrepModel(model.faces(), std::move(edges), model.tolerance());
        }
    }

    std::vector<BrepFace> faces_;
    std::map<std::string, int> numbers_;
    std::vector<TrimNumbers> trims_;
    std::vector<std::string> notes_;
};

} // namespace

CadJson readCadJson(const std::string& path) {
    return ModelReader().read(LocatedNode::fromJsonFile(path));
}

} // namespace tokay::geometry
