// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/LoopSnapper.hpp"
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

/// Curve numbers in the face by "trim_index".
using TrimNumbers = std::map<int, int>;

/// Face of a file, and how to find its curves.
struct ReadFace {
    BrepFace face;
    TrimNumbers trims;
    /// Number of curves in loops; those after them are embedded.
    int nLoopCurves = 0;
    /// The file's normal is opposite to xi x eta.
    bool isSwapped = false;
};

/// Curves that an edge may name but that cannot be read, by "trim_index": why.
using UnreadCurves = std::map<int, std::string>;

LoopCurve readTrim(const LocatedNode& node, int otherwise) {
    const int index = node.has("trim_index") ? node.required("trim_index").integer() : otherwise;
    const NurbsCurve curve = readCurve(node.required("parameter_curve"));
    const bool isForward =
        !node.has("curve_direction") || node.required("curve_direction").boolean();
    return {isForward ? curve : reversed(curve), index};
}

Parameters mirrored(const Parameters& point, const KnotVector& xi) {
    const double x = point[0];
    return {x == xi.first()  ? xi.last()
            : x == xi.last() ? xi.first()
                             : xi.first() + xi.last() - x,
            point[1]};
}

NurbsCurve mirrored(const NurbsCurve& curve, const KnotVector& xi) {
    Points points = curve.controlPoints();
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        points.row(i).head<2>() = mirrored(Parameters(points.row(i).head<2>()), xi);
    }
    return curve.withControlPoints(std::move(points));
}

/// Face with xi reversed, so that the normal of its surface is the file's. Loops run the
/// other way then, so their curves are numbered backwards.
void mirror(ReadFace& read) {
    const TrimmedPatch& patch = read.face.patch;
    const KnotVector& xi = patch.surface().u();
    std::vector<TrimmingLoop> loops;
    std::vector<int> numbers(read.nLoopCurves);
    int first = 0;
    for (const TrimmingLoop& loop : patch.loops()) {
        std::vector<NurbsCurve> curves;
        const int n = static_cast<int>(loop.curves().size());
        for (int i = n - 1; i >= 0; --i) {
            numbers[first + i] = first + n - 1 - i;
            curves.push_back(reversed(mirrored(loop.curves()[i], xi)));
        }
        first += n;
        loops.emplace_back(loop.kind(), std::move(curves));
    }
    for (auto& [index, number] : read.trims) {
        number = number < read.nLoopCurves ? numbers[number] : number;
    }
    for (NurbsCurve& curve : read.face.embeddedCurves) {
        curve = mirrored(curve, xi);
    }
    read.face.patch = TrimmedPatch(reversedXi(patch.surface()), std::move(loops), patch.name());
}

class FaceReader {
  public:
    FaceReader(const LocatedNode& node, std::optional<double> tolerance)
        : node_(node), surface_(readSurface(node.required("surface"))),
          snapper_(surface_, tolerance.value_or(1e-6 * sizeOf(surface_))) {}

    ReadFace read() {
        std::vector<TrimmingLoop> loops;
        for (const LocatedNode& loop : node_.itemsOf("boundary_loops")) {
            loops.push_back(readLoop(loop));
        }
        const std::string name = nameOf(node_);
        TrimmedPatch patch = node_.make([&] {
            return loops.empty() ? TrimmedPatch(surface_, name)
                                 : TrimmedPatch(surface_, std::move(loops), name);
        });
        // A patch without an outer loop has got the rim as its first.
        const int nRim = static_cast<int>(countCurves(patch)) - nCurves_;
        for (auto& [index, number] : trims_) {
            number += nRim;
        }
        nCurves_ += nRim;
        const int nLoopCurves = nCurves_;
        ReadFace result{{std::move(patch), readEmbedded()}, std::move(trims_), nLoopCurves, false};
        result.isSwapped = node_.has("swapped_surface_normal") &&
                           node_.required("swapped_surface_normal").boolean();
        if (result.isSwapped) {
            mirror(result);
        }
        return result;
    }

    const SnapStatistics& snapped() const { return snapper_.statistics(); }
    const UnreadCurves& unread() const { return unread_; }

  private:
    static double sizeOf(const NurbsSurface& surface) {
        return Box::around(surface.controlPoints()).diagonal();
    }
    static std::size_t countCurves(const TrimmedPatch& patch) {
        std::size_t n = 0;
        for (const TrimmingLoop& loop : patch.loops()) {
            n += loop.curves().size();
        }
        return n;
    }

    /// Gives the curve the next number of the face.
    void enter(std::optional<int> trimIndex, const LocatedNode& node) {
        if (trimIndex && !trims_.emplace(*trimIndex, nCurves_).second) {
            throw node.error(
                fmt::format("the trim_index {} occurs twice in this face", *trimIndex));
        }
        ++nCurves_;
    }

    TrimmingLoop readLoop(const LocatedNode& node) {
        const LoopKind kind = readKind(node);
        std::vector<LoopCurve> given;
        const std::vector<LocatedNode> items = node.required("trimming_curves").items();
        for (const LocatedNode& item : items) {
            given.push_back(readTrim(item, static_cast<int>(trims_.size() + given.size())));
        }
        std::vector<NurbsCurve> curves;
        std::size_t next = 0;
        for (const LoopCurve& snapped : snapper_.snapped(std::move(given))) {
            enter(snapped.trimIndex, snapped.trimIndex ? items[next++] : node);
            curves.push_back(snapped.curve);
        }
        return node.make([&] { return TrimmingLoop(kind, curves); });
    }

    static LoopKind readKind(const LocatedNode& node) {
        if (!node.has("loop_type")) {
            return LoopKind::outer;
        }
        const LocatedNode type = node.required("loop_type");
        if (type.text() != "outer" && type.text() != "inner") {
            throw type.error(
                fmt::format("the loop type \"{}\" must be outer or inner", type.text()));
        }
        return type.text() == "outer" ? LoopKind::outer : LoopKind::inner;
    }

    std::vector<NurbsCurve> readEmbedded() {
        std::vector<LocatedNode> items;
        for (const LocatedNode& loop : node_.itemsOf("embedded_loops")) {
            const std::vector<LocatedNode> curves = loop.required("trimming_curves").items();
            items.insert(items.end(), curves.begin(), curves.end());
        }
        const std::vector<LocatedNode> edges = node_.itemsOf("embedded_edges");
        items.insert(items.end(), edges.begin(), edges.end());
        std::vector<NurbsCurve> embedded;
        for (const LocatedNode& item : items) {
            try {
                const LoopCurve curve = readTrim(item, static_cast<int>(trims_.size()));
                enter(curve.trimIndex, item);
                embedded.push_back(curve.curve);
            } catch (const InputError& error) {
                // Only an error if an edge names it.
                const int index =
                    item.has("trim_index") ? item.required("trim_index").integer() : nCurves_;
                unread_.emplace(index, error.what());
            }
        }
        return embedded;
    }

    const LocatedNode& node_;
    NurbsSurface surface_;
    LoopSnapper snapper_;
    TrimNumbers trims_;
    UnreadCurves unread_;
    int nCurves_ = 0;
};

class ModelReader {
  public:
    explicit ModelReader(std::optional<double> tolerance) : tolerance_(tolerance) {}

    BrepModel read(const LocatedNode& root) {
        readTolerance(root);
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
                remarks_.push_back(brep.error(fmt::format("{} vertices are not used", n)).what());
            }
        }
        for (const UnreadCurves& curves : unread_) {
            for (const auto& [index, reason] : curves) {
                remarks_.push_back("curve not used: " + reason);
            }
        }
        const BrepModel model = root.make([&] { return BrepModel(faces_, edges); });
        followCurves(model, edges);
        return BrepModel(std::move(faces_), std::move(edges), tolerance_.value_or(0),
                         std::move(remarks_));
    }

  private:
    void readTolerance(const LocatedNode& root) {
        if (tolerance_ || !root.has("tolerances") ||
            !root.required("tolerances").has("model_tolerance")) {
            return;
        }
        const LocatedNode node = root.required("tolerances").required("model_tolerance");
        if (node.number() < 0) {
            throw node.error(fmt::format("{} is out of range; allowed: [0, inf)", node.number()));
        }
        if (node.number() > 0) {
            tolerance_ = node.number();
        }
    }

    void readFace(const LocatedNode& node) {
        FaceReader reader(node, tolerance_);
        ReadFace read = reader.read();
        const std::string name = read.face.patch.name();
        if (!numbers_.emplace(name, static_cast<int>(faces_.size())).second) {
            throw node.error(fmt::format("two faces are named \"{}\"", name));
        }
        remark(name, reader.snapped(), read.isSwapped);
        faces_.push_back(std::move(read.face));
        read_.push_back(std::move(read));
        unread_.push_back(reader.unread());
    }

    void remark(const std::string& name, const SnapStatistics& snapped, bool isSwapped) {
        if (snapped.nMoved > 0) {
            remarks_.push_back(fmt::format("face \"{}\": {} corrections of trimming curves, the "
                                           "largest {:.2g}",
                                           name, snapped.nMoved, snapped.largest));
        }
        if (snapped.nSupplied > 0) {
            remarks_.push_back(fmt::format("face \"{}\": {} trimming curves along collapsed sides "
                                           "supplied",
                                           name, snapped.nSupplied));
        }
        if (isSwapped) {
            remarks_.push_back(fmt::format("face \"{}\": swapped_surface_normal, so its xi is "
                                           "reversed",
                                           name));
        }
    }

    BrepEdge readEdge(const LocatedNode& node) {
        BrepEdge edge{nameOf(node), {}};
        if (node.has("3d_curve")) {
            try {
                edge.curve = readCurve(node.required("3d_curve"));
            } catch (const InputError& error) {
                remarks_.push_back(std::string("curve not used: ") + error.what());
            }
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
        const ReadFace& read = read_[face->second];
        const auto curve = read.trims.find(index.integer());
        if (curve == read.trims.end()) {
            const auto unread = unread_[face->second].find(index.integer());
            throw unread != unread_[face->second].end()
                ? InputError(unread->second)
                : index.error(fmt::format("the face \"{}\" has no curve of trim_index {}", name,
                                          index.integer()));
        }
        const bool isForward =
            !node.has("relative_direction") || node.required("relative_direction").boolean();
        const bool isTurned = read.isSwapped && curve->second < read.nLoopCurves;
        return {face->second, curve->second, isForward != isTurned};
    }

    /// Files differ in what a direction is relative to: points decide.
    void followCurves(const BrepModel& model, std::vector<BrepEdge>& edges) {
        for (BrepEdge& edge : edges) {
            bool contradicts = false;
            for (std::size_t i = 1; i < edge.trims.size(); ++i) {
                const bool isAlong =
                    runsAlong(model.curveInSpace(edge.trims[0]), model.curveInSpace(edge.trims[i]));
                const bool isForward = isAlong == edge.trims[0].isForward;
                contradicts = contradicts || isForward != edge.trims[i].isForward;
                edge.trims[i].isForward = isForward;
            }
            if (contradicts) {
                remarks_.push_back(fmt::format("edge \"{}\": relative_direction contradicts the "
                                               "curves, which are followed",
                                               edge.name));
            }
        }
    }

    std::optional<double> tolerance_;
    std::vector<BrepFace> faces_;
    std::map<std::string, int> numbers_;
    std::vector<ReadFace> read_;
    std::vector<UnreadCurves> unread_;
    std::vector<std::string> remarks_;
};

} // namespace

BrepModel readCadJson(const std::string& path, std::optional<double> tolerance) {
    return ModelReader(tolerance).read(LocatedNode::fromJsonFile(path));
}

} // namespace tokay::geometry
