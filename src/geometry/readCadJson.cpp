#include "geometry/cadJson.hpp"

#include "geometry/CadJsonNode.hpp"
#include "geometry/curveParts.hpp"
#include "geometry/openSpline.hpp"
#include "geometry/rational.hpp"
#include <fmt/format.h>
#include <map>

namespace tokay::geometry {

namespace {

std::string nameOf(const CadJsonNode& node) {
    if (node.has("brep_name"))
        return node.child("brep_name").text();
    return std::to_string(node.child("brep_id").integer());
}

/// Rows (x, y, z, w) of points [id, [x, y, z, w]] or [[x, y, z, w]].
Eigen::MatrixXd readControlPoints(const CadJsonNode& owner) {
    const CadJsonNode node = owner.child("control_points");
    const bool mayBeRational = !owner.has("is_rational") || owner.child("is_rational").boolean();
    const std::vector<CadJsonNode> items = node.items();
    Eigen::MatrixXd rows(items.size(), 4);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::vector<CadJsonNode> parts = items[i].items();
        if (parts.empty() || parts.size() > 2)
            throw items[i].error("a control point is given as [number, [x, y, z, weight]].");
        const std::vector<double> values = parts.back().numbers(4);
        if (!(values[3] > 0))
            throw parts.back().error(
                fmt::format("the weight is {}, but must be positive.", values[3]));
        rows.row(i) = Eigen::RowVector4d::Map(values.data());
        if (!mayBeRational && values[3] != rows(0, 3))
            throw parts.back().error(fmt::format("the weight is {}, the first one {}, but "
                                                 "\"is_rational\" is false: correct one of them.",
                                                 values[3], rows(0, 3)));
    }
    return rows;
}

Eigen::MatrixXd homogeneousRows(const Eigen::MatrixXd& rows) {
    Eigen::MatrixXd result = rows;
    result.leftCols(3) = rows.col(3).asDiagonal() * rows.leftCols(3);
    return result;
}

/// Points and weights of homogeneous rows; as they were given to the bit if
/// those are still the same.
std::pair<Points, Eigen::VectorXd> pointsAndWeights(const Eigen::MatrixXd& rows,
                                                    const Eigen::MatrixXd& given) {
    const bool isSame = rows.rows() == given.rows() && rows == homogeneousRows(given);
    if (isSame)
        return {given.leftCols(3), given.col(3)};
    return dehomogenised(rows);
}

NurbsCurve readCurve(const CadJsonNode& node) {
    const int degree = node.child("degree").integer();
    const CadJsonNode knots = node.child("knot_vector");
    const Eigen::MatrixXd rows = readControlPoints(node);
    const NurbsCurve curve = knots.make([&] {
        const SplineCoefficients spline =
            openSpline(degree, knots.numbers(), homogeneousRows(rows));
        auto [points, weights] = pointsAndWeights(spline.rows, rows);
        return NurbsCurve(spline.knots, std::move(points), std::move(weights));
    });
    if (!node.has("active_range"))
        return curve;
    const CadJsonNode active = node.child("active_range");
    const std::vector<double> range = active.numbers(2);
    if (range[0] == curve.knotVector().first() && range[1] == curve.knotVector().last())
        return curve;
    return active.make([&] { return partOf(curve, range[0], range[1]); });
}

/// Opens the knot vector of a net's direction whose index runs fastest, and
/// turns the net, so that a second call does the other direction.
SplineCoefficients openDirection(int degree, const std::vector<double>& knots,
                                 const Eigen::MatrixXd& net, Eigen::Index n) {
    const Eigen::Index other = net.rows() / n;
    Eigen::MatrixXd lines(n, 4 * other);
    for (Eigen::Index j = 0; j < other; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
            lines.block<1, 4>(i, 4 * j) = net.row(i + n * j);
    SplineCoefficients opened = openSpline(degree, knots, lines);
    Eigen::MatrixXd turned(opened.rows.rows() * other, 4);
    for (Eigen::Index i = 0; i < opened.rows.rows(); ++i)
        for (Eigen::Index j = 0; j < other; ++j)
            turned.row(j + other * i) = opened.rows.block<1, 4>(i, 4 * j);
    return {std::move(opened.knots), std::move(turned)};
}

/// Number of control points in a direction, from its knots: n + degree + 1 or
/// n + degree - 1 of them, whichever fits the other direction and the total.
std::array<Eigen::Index, 2> netSize(const CadJsonNode& surface, const std::vector<int>& degrees,
                                    const std::array<std::vector<double>, 2>& knots,
                                    Eigen::Index total) {
    for (const int more : {1, -1}) {
        const auto nU = static_cast<Eigen::Index>(knots[0].size()) - degrees[0] - more;
        const auto nV = static_cast<Eigen::Index>(knots[1].size()) - degrees[1] - more;
        if (nU > 0 && nV > 0 && nU * nV == total)
            return {nU, nV};
    }
    throw surface.error(
        fmt::format("there are {} control points, but degrees {} and {} with {} "
                    "and {} knots need {}.",
                    total, degrees[0], degrees[1], knots[0].size(), knots[1].size(),
                    (knots[0].size() - degrees[0] - 1) * (knots[1].size() - degrees[1] - 1)));
}

NurbsSurface readSurface(const CadJsonNode& node) {
    std::vector<int> degrees;
    for (const CadJsonNode& degree : node.child("degrees").items())
        degrees.push_back(degree.integer());
    const CadJsonNode knotVectors = node.child("knot_vectors");
    const std::vector<CadJsonNode> both = knotVectors.items();
    if (degrees.size() != 2)
        throw node.child("degrees").error("a surface has two degrees.");
    if (both.size() != 2)
        throw knotVectors.error("a surface has two knot vectors.");
    const std::array<std::vector<double>, 2> knots = {both[0].numbers(), both[1].numbers()};
    const Eigen::MatrixXd given = readControlPoints(node), net = homogeneousRows(given);
    const auto [nU, nV] = netSize(node, degrees, knots, net.rows());
    const SplineCoefficients u =
        both[0].make([&, n = nU] { return openDirection(degrees[0], knots[0], net, n); });
    const SplineCoefficients v =
        both[1].make([&, n = nV] { return openDirection(degrees[1], knots[1], u.rows, n); });
    return node.make([&] {
        auto [points, weights] = pointsAndWeights(v.rows, given);
        return NurbsSurface(u.knots, v.knots, std::move(points), std::move(weights));
    });
}

/// Curve of a face by the number that edges call it by.
struct NumberedCurve {
    int trimIndex;
    NurbsCurve curve;
};

NumberedCurve readTrim(const CadJsonNode& node, int otherwise) {
    const int index = node.has("trim_index") ? node.child("trim_index").integer() : otherwise;
    const NurbsCurve curve = readCurve(node.child("parameter_curve"));
    const bool isForward = !node.has("curve_direction") || node.child("curve_direction").boolean();
    return {index, isForward ? curve : reversed(curve)};
}

/// Curve numbers in the face by "trim_index".
using TrimNumbers = std::map<int, int>;

class FaceReader {
  public:
    explicit FaceReader(const CadJsonNode& node) : node_(node) {}

    BrepFace read() {
        const std::string name = nameOf(node_);
        const NurbsSurface surface = readSurface(node_.child("surface"));
        std::vector<TrimmingLoop> loops;
        for (const CadJsonNode& loop : node_.itemsOf("boundary_loops"))
            loops.push_back(readLoop(loop));
        std::vector<NurbsCurve> embedded;
        for (const CadJsonNode& loop : node_.itemsOf("embedded_loops"))
            for (const CadJsonNode& curve : loop.child("trimming_curves").items())
                embedded.push_back(readCounted(curve));
        for (const CadJsonNode& curve : node_.itemsOf("embedded_edges"))
            embedded.push_back(readCounted(curve));
        const bool isSwapped =
            node_.has("swapped_surface_normal") && node_.child("swapped_surface_normal").boolean();
        return node_.make([&] {
            return BrepFace{loops.empty() ? TrimmedPatch(surface, name)
                                          : TrimmedPatch(surface, loops, name),
                            isSwapped, embedded};
        });
    }

    const TrimNumbers& trims() const { return trims_; }

  private:
    NurbsCurve readCounted(const CadJsonNode& node) {
        const int number = static_cast<int>(trims_.size());
        NumberedCurve trim = readTrim(node, number);
        if (!trims_.emplace(trim.trimIndex, number).second)
            throw node.error(
                fmt::format("the trim_index {} occurs twice in this face.", trim.trimIndex));
        return std::move(trim.curve);
    }

    TrimmingLoop readLoop(const CadJsonNode& node) {
        LoopKind kind = LoopKind::outer;
        if (node.has("loop_type")) {
            const CadJsonNode type = node.child("loop_type");
            if (type.text() != "outer" && type.text() != "inner")
                throw type.error(
                    fmt::format("the loop type \"{}\" must be outer or inner.", type.text()));
            kind = type.text() == "outer" ? LoopKind::outer : LoopKind::inner;
        }
        std::vector<NurbsCurve> curves;
        for (const CadJsonNode& curve : node.child("trimming_curves").items())
            curves.push_back(readCounted(curve));
        return node.make([&] { return TrimmingLoop(kind, curves); });
    }

    const CadJsonNode& node_;
    TrimNumbers trims_;
};

class ModelReader {
  public:
    CadJson read(const CadJsonNode& root) {
        const std::vector<CadJsonNode> breps = root.child("breps").items();
        for (const CadJsonNode& brep : breps)
            for (const CadJsonNode& face : brep.itemsOf("faces"))
                readFace(face);
        if (faces_.empty())
            throw root.child("breps").error("there is no face in any brep.");
        std::vector<BrepEdge> edges;
        for (const CadJsonNode& brep : breps) {
            for (const CadJsonNode& edge : brep.itemsOf("edges"))
                edges.push_back(readEdge(edge));
            if (const std::size_t n = brep.itemsOf("vertices").size())
                notes_.push_back(brep.error(fmt::format("{} vertices are not used.", n)).what());
        }
        double tolerance = 0;
        if (root.has("tolerances") && root.child("tolerances").has("model_tolerance"))
            tolerance = root.child("tolerances").child("model_tolerance").number();
        BrepModel model =
            root.make([&] { return BrepModel(std::move(faces_), std::move(edges), tolerance); });
        checkDirections(model);
        return {std::move(model), std::move(notes_)};
    }

  private:
    void readFace(const CadJsonNode& node) {
        FaceReader reader(node);
        BrepFace face = reader.read();
        if (!numbers_.emplace(face.patch.name(), static_cast<int>(faces_.size())).second)
            throw node.error(fmt::format("two faces are named \"{}\".", face.patch.name()));
        trims_.push_back(reader.trims());
        faces_.push_back(std::move(face));
    }

    BrepEdge readEdge(const CadJsonNode& node) {
        BrepEdge edge{nameOf(node), {}};
        if (node.has("3d_curve"))
            edge.curve = readCurve(node.child("3d_curve"));
        for (const CadJsonNode& trim : node.itemsOf("topology"))
            edge.trims.push_back(readTopology(trim));
        return edge;
    }

    BrepTrim readTopology(const CadJsonNode& node) const {
        const std::string name = nameOf(node);
        const auto face = numbers_.find(name);
        if (face == numbers_.end())
            throw node.error(fmt::format("there is no face \"{}\".", name));
        const CadJsonNode index = node.child("trim_index");
        const auto curve = trims_[face->second].find(index.integer());
        if (curve == trims_[face->second].end())
            throw index.error(fmt::format("the face \"{}\" has no curve of trim_index {}.", name,
                                          index.integer()));
        const bool isForward =
            !node.has("relative_direction") || node.child("relative_direction").boolean();
        return {face->second, curve->second, isForward};
    }

    /// Files differ in what a direction is relative to: points decide.
    void checkDirections(BrepModel& model) {
        std::vector<BrepEdge> edges = model.edges();
        bool changed = false;
        for (BrepEdge& edge : edges)
            for (std::size_t i = 1; i < edge.trims.size(); ++i) {
                const bool isAlong =
                    runsAlong(model.curveInSpace(edge.trims[0]), model.curveInSpace(edge.trims[i]));
                const bool isForward = isAlong == edge.trims[0].isForward;
                if (isForward == edge.trims[i].isForward)
                    continue;
                notes_.push_back(fmt::format("Edge \"{}\": relative_direction contradicts the "
                                             "curves, which are followed.",
                                             edge.name));
                edge.trims[i].isForward = isForward;
                changed = true;
            }
        if (changed)
            model = BrepModel(model.faces(), std::move(edges), model.tolerance());
    }

    std::vector<BrepFace> faces_;
    std::map<std::string, int> numbers_;
    std::vector<TrimNumbers> trims_;
    std::vector<std::string> notes_;
};

} // namespace

CadJson readCadJson(const std::string& path) {
    return ModelReader().read(CadJsonNode::load(path));
}

} // namespace tokay::geometry
