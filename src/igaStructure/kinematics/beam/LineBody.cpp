// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/LineBody.hpp"

#include "igaStructure/kinematics/beam/LineTransfer.hpp"
#include "igaStructure/kinematics/beam/planeVectors.hpp"
#include "igaStructure/kinematics/thinness.hpp"
#include "igaStructure/output/curveMesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

std::string LineBody::description() const {
    const geometry::NurbsCurve& curve = line_.curve();
    const LineSection& section = line_.section();
    std::string text = fmt::format(
        "  {}{}, {} strains, degree {}, {} elements{}\n  axial stiffness {:g} N",
        section.bends() ? "Euler-Bernoulli beam" : "cable", isInPlane() ? "" : " in space",
        line_.isLinear() ? "linear" : "nonlinear", curve.degree(), curve.knotVector().nSpans(),
        curve.isRational() ? ", rational" : "", section.axialStiffness);
    text += section.bends()
                ? fmt::format(", bending stiffness {:g} N m^2, rotary inertia {:g} kg m",
                              section.bendingStiffness, section.rotaryInertia)
                : fmt::format(", prestress {:g} N", section.prestress);
    return text + fmt::format(", mass {:g} kg/m\n  thickness {:g} m, width {:g} m\n", section.mass,
                              section.thickness, section.width);
}

std::vector<VtuMesh> LineBody::meshes(const OutputOptions& options) const {
    if (options.cells == CellShape::bezier) {
        return {bezierMesh(line_.curve())};
    }
    return {isInPlane() ? stripMesh(line_.curve(), options.subdivision, line_.section().thickness)
                        : segmentMesh(line_.curve(), options.subdivision)};
}

std::vector<std::string> LineBody::fieldNames() const {
    std::vector<std::string> names = {"displacement", "velocity", "acceleration", "normalForce",
                                      "axialStress"};
    if (line_.section().bends()) {
        names.insert(names.end(), {"bendingMoment", "shearForce"});
    }
    return names;
}

std::vector<std::string> LineBody::defaultFields() const {
    std::vector<std::string> names = {"displacement", "velocity", "normalForce"};
    if (line_.section().bends()) {
        names.insert(names.end(), {"bendingMoment", "shearForce"});
    }
    return names;
}

LineField LineBody::reference(double xi) const {
    const geometry::Points derivatives = line_.curve().derivatives(xi, 1);
    return {derivatives.row(0).head<2>(), derivatives.row(1).head<2>()};
}

LineField LineBody::evaluate(const VectorXd& field, double xi) const {
    const geometry::CurveBasis basis = line_.curve().basis(xi, 1);
    LineField result{Vector2d::Zero(), Vector2d::Zero()};
    for (int a = 0; a < basis.N.cols(); ++a) {
        result.value += basis.N(0, a) * field.segment<2>(2 * (basis.first + a));
        result.slope += basis.N(1, a) * field.segment<2>(2 * (basis.first + a));
    }
    return result;
}

MatrixXd LineBody::axisValues(const VectorXd& ofControlPoints,
                              const std::vector<Place>& places) const {
    const int d = line_.dimension();
    MatrixXd values = MatrixXd::Zero(3, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const geometry::CurveBasis basis = line_.curve().basis(places[k].xi, 0);
        for (int a = 0; a < basis.N.cols(); ++a) {
            values.col(k).head(d) +=
                basis.N(0, a) * ofControlPoints.segment(d * (basis.first + a), d);
        }
    }
    return values;
}

MatrixXd LineBody::positions(const std::vector<Place>& places) const {
    MatrixXd values = MatrixXd::Zero(3, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (!isInPlane()) {
            values.col(k) = line_.curve().point(places[k].xi);
            continue;
        }
        const LineField axis = reference(places[k].xi);
        values.col(k).head<2>() = axis.value + places[k].zeta * turned(axis.slope).normalized();
    }
    return values;
}

MatrixXd LineBody::displacements(const VectorXd& displacement,
                                 const std::vector<Place>& places) const {
    const VectorXd all = line_.controlDisplacements(displacement);
    if (!isInPlane()) {
        return axisValues(all, places);
    }
    MatrixXd values = MatrixXd::Zero(3, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double xi = places[k].xi;
        values.col(k).head<2>() =
            sectionDisplacement(reference(xi), evaluate(all, xi), places[k].zeta, line_.isLinear());
    }
    return values;
}

MatrixXd LineBody::motion(const std::string& name, const MotionState& state,
                          const std::vector<Place>& places) const {
    const VectorXd displacement = line_.controlDisplacements(state.displacement);
    const VectorXd velocity = line_.controlDisplacements(state.velocity);
    const VectorXd acceleration = line_.controlDisplacements(state.acceleration);
    if (!isInPlane()) {
        return axisValues(name == "velocity" ? velocity : acceleration, places);
    }
    const bool isLinear = line_.isLinear();
    MatrixXd values = MatrixXd::Zero(3, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double xi = places[k].xi;
        const LineField X = reference(xi);
        const LineField u = evaluate(displacement, xi);
        const LineField v = evaluate(velocity, xi);
        values.col(k).head<2>() = name == "velocity"
                                      ? sectionVelocity(X, u, v, places[k].zeta, isLinear)
                                      : sectionAcceleration(X, u, v, evaluate(acceleration, xi),
                                                            places[k].zeta, isLinear);
    }
    return values;
}

double LineBody::resultant(const std::string& name, const VectorXd& displacement,
                           const Place& place) const {
    const LineState state = line_.stateAt(place.xi, displacement);
    if (name == "normalForce") {
        return state.normalForce;
    }
    if (name == "bendingMoment") {
        return state.bendingMoment;
    }
    if (name == "shearForce") {
        return state.shearForce;
    }
    assert(name == "axialStress");
    const LineSection& section = line_.section();
    const double area = section.thickness * section.width;
    const double secondMoment = area * section.thickness * section.thickness / 12;
    // A fibre on the left is compressed if the tangent turns left.
    return state.normalForce / area - place.zeta * state.bendingMoment / secondMoment;
}

MatrixXd LineBody::field(const std::string& name, const MotionState& state,
                         const std::vector<Place>& places) const {
    if (name == "displacement") {
        return displacements(state.displacement, places);
    }
    if (name == "velocity" || name == "acceleration") {
        return motion(name, state, places);
    }
    MatrixXd values(1, places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        values(0, k) = resultant(name, state.displacement, places[k]);
    }
    return values;
}

Body::Closest LineBody::closest(const geometry::Point& point) const {
    const geometry::CurveProjection found = projector_.closest(point);
    const double half = 0.5 * line_.section().thickness;
    if (!isInPlane()) {
        const double distance = (point - line_.curve().point(found.xi)).norm();
        return {{0, found.xi, 0, 0}, std::max(0.0, distance - half)};
    }
    const LineField axis = reference(found.xi);
    const Vector2d offset = point.head<2>() - axis.value;
    const Vector2d tangent = axis.slope.normalized();
    const double across = turned(tangent).dot(offset);
    const double zeta = std::clamp(across, -half, half);
    return {{0, found.xi, 0, zeta}, std::hypot(tangent.dot(offset), across - zeta, point[2])};
}

std::vector<std::string> LineBody::advice() const {
    const LineSection& section = line_.section();
    const double share = section.thickness / line_.length();
    if (!section.bends()) {
        return {fmt::format(
            "slenderness (length over thickness) {:.3g}{}", 1 / share,
            leftOutBending(section.thickness, section.axialStiffness, section.prestress))};
    }
    // Of the deflection of a cantilever under end load: 3 E I / (k G A L^2) with
    // k = 5/6 and Poisson's ratio 0.3.
    const double shear = 0.78 * share * share;
    std::vector<std::string> lines = {
        fmt::format("slenderness (length over thickness) {:.3g}: shear deformation, which a "
                    "beam leaves out, would add about {:.2g} % to a cantilever's deflection{}",
                    1 / share, 100 * shear, shear > 0.02 ? "; a plane solid models it" : "")};
    const double bend = section.thickness * largestCurvature(line_.curve());
    if (bend > 1e-6) {
        lines.push_back(fmt::format("thickness over radius of curvature {:.3g}, terms of which "
                                    "order a beam leaves out{}",
                                    bend, bend > 0.1 ? "; a plane solid models them" : ""));
    }
    return lines;
}

std::unique_ptr<InterfaceTransfer> LineBody::transfer(const Coupling& coupling,
                                                      const geometry::Points& points) const {
    return std::make_unique<LineTransfer>(line_, coupling, points);
}

} // namespace tokay::structure
