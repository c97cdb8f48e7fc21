// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/OutputFile.hpp"
#include "geometry/brep/cadJson.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace tokay::geometry {

namespace {

/// Shortest text that reads back to the same bits.
std::string text(const std::vector<double>& values) {
    return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string quoted(const std::string& name) {
    std::string result = "\"";
    for (const char c : name) {
        result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return result + "\"";
}

const char* text(bool value) {
    return value ? "true" : "false";
}

/// Names that are numbers stand as such; others get numbers nobody else has.
class Writer {
  public:
    explicit Writer(const BrepModel& model) : model_(model) {
        for (const BrepFace& face : model.faces()) {
            nextId_ = std::max(nextId_, idOf(face.patch.name()) + 1);
        }
        for (const BrepEdge& edge : model.edges()) {
            nextId_ = std::max(nextId_, idOf(edge.name) + 1);
        }
    }

    std::string write() {
        std::string text = fmt::format("{{\n\"tolerances\": {{\"model_tolerance\": {}}},\n"
                                       "\"version_number\": 1,\n\"breps\": [{{\n\"brep_id\": {},\n"
                                       "\"faces\": [",
                                       model_.tolerance(), nextId_++);
        for (std::size_t i = 0; i < model_.faces().size(); ++i) {
            text += (i > 0 ? ", " : "") + face(static_cast<int>(i));
        }
        text += "],\n\"edges\": [";
        for (std::size_t i = 0; i < model_.edges().size(); ++i) {
            text += (i > 0 ? ", " : "") + edge(model_.edges()[i]);
        }
        return text + "],\n\"vertices\": []\n}]\n}\n";
    }

  private:
    static int idOf(const std::string& name) {
        const bool isNumber =
            !name.empty() && name.size() < 9 &&
            std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
            (name == "0" || name[0] != '0');
        return isNumber ? std::stoi(name) : 0;
    }

    std::string identity(const std::string& name) {
        const int id = idOf(name);
        if (id > 0 || name == "0") {
            return fmt::format("\"brep_id\": {}", id);
        }
        return fmt::format("\"brep_id\": {}, \"brep_name\": {}", nextId_++, quoted(name));
    }

    static std::string reference(const std::string& name) {
        const int id = idOf(name);
        if (id > 0 || name == "0") {
            return fmt::format("\"brep_id\": {}", id);
        }
        return fmt::format("\"brep_name\": {}", quoted(name));
    }

    std::string controlPoints(const Points& points, const Eigen::VectorXd& weights) {
        std::string text = "\"control_points\": [";
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            text += fmt::format("{}[{}, [{}, {}, {}, {}]]", i > 0 ? ",\n" : "\n", nextPoint_++,
                                points(i, 0), points(i, 1), points(i, 2),
                                weights.size() > 0 ? weights[i] : 1.0);
        }
        return text + "]";
    }

    std::string curve(const NurbsCurve& curve) {
        return fmt::format("{{\"is_rational\": {}, \"degree\": {}, \"knot_vector\": {}, "
                           "\"active_range\": [{}, {}], {}}}",
                           text(curve.isRational()), curve.degree(),
                           text(curve.knotVector().knots()), curve.knotVector().first(),
                           curve.knotVector().last(),
                           controlPoints(curve.controlPoints(), curve.weights()));
    }

    std::string trim(const NurbsCurve& parameterCurve, int number) {
        return fmt::format(
            "{{\"trim_index\": {}, \"curve_direction\": true, \"parameter_curve\": {}}}", number,
            curve(parameterCurve));
    }

    std::string face(int number) {
        const BrepFace& face = model_.faces()[number];
        const NurbsSurface& surface = face.patch.surface();
        std::string text = fmt::format(
            "{{\n{}, \"swapped_surface_normal\": false,\n\"surface\": {{\"is_trimmed\": {}, "
            "\"is_rational\": {}, \"degrees\": [{}, {}],\n\"knot_vectors\": [{},\n{}],\n{}}},\n"
            "\"boundary_loops\": [",
            identity(face.patch.name()), geometry::text(face.patch.isTrimmed()),
            geometry::text(surface.isRational()), surface.u().degree(), surface.v().degree(),
            geometry::text(surface.u().knots()), geometry::text(surface.v().knots()),
            controlPoints(surface.controlPoints(), surface.weights()));
        int next = 0;
        for (const TrimmingLoop& loop : face.patch.loops()) {
            text += fmt::format("{}{{\"loop_type\": \"{}\", \"trimming_curves\": [",
                                next > 0 ? ",\n" : "",
                                loop.kind() == LoopKind::outer ? "outer" : "inner");
            for (std::size_t i = 0; i < loop.curves().size(); ++i) {
                text += (i > 0 ? ",\n" : "\n") + trim(loop.curves()[i], next++);
            }
            text += "]}";
        }
        text += "],\n\"embedded_loops\": [], \"embedded_edges\": [";
        for (std::size_t i = 0; i < face.embeddedCurves.size(); ++i) {
            text += (i > 0 ? ",\n" : "\n") + trim(face.embeddedCurves[i], next++);
        }
        return text + "], \"embedded_points\": []\n}";
    }

    std::string edge(const BrepEdge& edge) {
        std::string text = fmt::format("{{\n{},\n", identity(edge.name));
        if (edge.curve) {
            text += fmt::format("\"3d_curve\": {},\n", curve(*edge.curve));
        }
        text += "\"topology\": [";
        for (std::size_t i = 0; i < edge.trims.size(); ++i) {
            text +=
                fmt::format("{}{{{}, \"trim_index\": {}, \"relative_direction\": {}}}",
                            i > 0 ? ", " : "", reference(model_.patch(edge.trims[i].face).name()),
                            edge.trims[i].curve, geometry::text(edge.trims[i].isForward));
        }
        return text + "]\n}";
    }

    const BrepModel& model_;
    int nextId_ = 1;
    int nextPoint_ = 1;
};

} // namespace

void writeCadJson(const BrepModel& model, const std::string& path) {
    OutputFile file(path);
    file.write(Writer(model).write());
    file.publish();
}

} // namespace tokay::geometry
