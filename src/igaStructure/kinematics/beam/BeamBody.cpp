// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/BeamBody.hpp"

#include "igaStructure/kinematics/beam/planeVectors.hpp"
#include "igaStructure/kinematics/thinness.hpp"
#include "igaStructure/output/curveMesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

// For the end of a sentence on shear deformation; of a body that is not thick.
std::string tooHighFrequencies(double slenderness) {
    const double second = bendingOverestimate(slenderness, 2);
    return fmt::format(", and with rotary inertia it makes the frequencies of the first three "
                       "bending modes about {:.2g}, {:.2g} and {:.2g} % too high{}",
                       100 * bendingOverestimate(slenderness, 1), 100 * second,
                       100 * bendingOverestimate(slenderness, 3),
                       second > 0.01 ? "; where a flow excites more than the first of them, a "
                                       "plane solid is right"
                                     : "");
}

} // namespace

BeamBody::BeamBody(Beam beam) : beam_(std::move(beam)), projector_(beam_.curve()) {
    add(resultant("normalForce", "N", true,
                  [](const BeamState& state, const Location&) { return state.normalForce; }));
    add(resultant("axialStress", "Pa", false, [this](const BeamState& state, const Location& at) {
        return axialStress(state, at);
    }));
    if (beam_.section().bends()) {
        add(resultant("bendingMoment", "N m", true,
                      [](const BeamState& state, const Location&) { return state.bendingMoment; }));
        add(resultant("shearForce", "N", true,
                      [](const BeamState& state, const Location&) { return state.shearForce; }));
    }
}

BodyField
BeamBody::resultant(std::string name, std::string unit, bool isDefault,
                    std::function<double(const BeamState&, const Location&)> value) const {
    return {std::move(name), std::move(unit), 1, isDefault,
            [this, value = std::move(value)](const MotionState& state, const auto& locations) {
                MatrixXd values(1, locations.size());
                for (std::size_t k = 0; k < locations.size(); ++k) {
                    values(0, k) =
                        value(beam_.stateAt(locations[k].xi, state.displacement), locations[k]);
                }
                return values;
            }};
}

std::string BeamBody::description() const {
    const geometry::NurbsCurve& curve = beam_.curve();
    const BeamSection& section = beam_.section();
    std::string text = fmt::format(
        "  {}{}, {} strains, degree {}, {} elements{}\n  axial stiffness {:g} N",
        section.bends() ? "Euler-Bernoulli beam" : "cable", isInPlane() ? "" : " in space",
        beam_.isLinear() ? "linear" : "nonlinear", curve.degree(), curve.knotVector().nSpans(),
        curve.isRational() ? ", rational" : "", section.axialStiffness);
    text += section.bends()
                ? fmt::format(", bending stiffness {:g} N m^2, rotary inertia {:g} kg m",
                              section.bendingStiffness, section.rotaryInertia)
                : fmt::format(", prestress {:g} N", section.prestress);
    return text + fmt::format(", mass {:g} kg/m\n  thickness {:g} m, width {:g} m\n", section.mass,
                              section.thickness, section.width);
}

std::vector<VtuMesh> BeamBody::meshes(const OutputOptions& options) const {
    if (options.cells == CellShape::bezier) {
        return {bezierMesh(beam_.curve())};
    }
    return {isInPlane() ? stripMesh(beam_.curve(), options.subdivision, beam_.section().thickness)
                        : segmentMesh(beam_.curve(), options.subdivision)};
}

BeamField BeamBody::reference(double xi) const {
    const geometry::Points derivatives = beam_.curve().derivatives(xi, 1);
    return {derivatives.row(0).head<2>(), derivatives.row(1).head<2>()};
}

BeamField BeamBody::evaluate(const VectorXd& field, double xi) const {
    const geometry::CurveBasis basis = beam_.curve().basis(xi, 1);
    BeamField result{Vector2d::Zero(), Vector2d::Zero()};
    for (int a = 0; a < basis.N.cols(); ++a) {
        result.value += basis.N(0, a) * field.segment<2>(2 * (basis.first + a));
        result.slope += basis.N(1, a) * field.segment<2>(2 * (basis.first + a));
    }
    return result;
}

MatrixXd BeamBody::axisValues(const VectorXd& ofControlPoints,
                              const std::vector<Location>& locations) const {
    const int d = beam_.dimension();
    MatrixXd values = MatrixXd::Zero(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const geometry::CurveBasis basis = beam_.curve().basis(locations[k].xi, 0);
        for (int a = 0; a < basis.N.cols(); ++a) {
            values.col(k).head(d) +=
                basis.N(0, a) * ofControlPoints.segment(d * (basis.first + a), d);
        }
    }
    return values;
}

MatrixXd BeamBody::positions(const std::vector<Location>& locations) const {
    MatrixXd values = MatrixXd::Zero(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        if (!isInPlane()) {
            values.col(k) = beam_.curve().point(locations[k].xi);
            continue;
        }
        const BeamField axis = reference(locations[k].xi);
        values.col(k).head<2>() = axis.value + locations[k].zeta * turned(axis.slope).normalized();
    }
    return values;
}

MatrixXd BeamBody::displacements(const VectorXd& displacement,
                                 const std::vector<Location>& locations) const {
    const VectorXd all = beam_.controlDisplacements(displacement);
    if (!isInPlane()) {
        return axisValues(all, locations);
    }
    MatrixXd values = MatrixXd::Zero(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const double xi = locations[k].xi;
        values.col(k).head<2>() = sectionDisplacement(reference(xi), evaluate(all, xi),
                                                      locations[k].zeta, beam_.isLinear());
    }
    return values;
}

MatrixXd BeamBody::velocities(const MotionState& state,
                              const std::vector<Location>& locations) const {
    const VectorXd velocity = beam_.controlDisplacements(state.velocity);
    if (!isInPlane()) {
        return axisValues(velocity, locations);
    }
    const VectorXd displacement = beam_.controlDisplacements(state.displacement);
    MatrixXd values = MatrixXd::Zero(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const double xi = locations[k].xi;
        values.col(k).head<2>() =
            sectionVelocity(reference(xi), evaluate(displacement, xi), evaluate(velocity, xi),
                            locations[k].zeta, beam_.isLinear());
    }
    return values;
}

MatrixXd BeamBody::accelerations(const MotionState& state,
                                 const std::vector<Location>& locations) const {
    const VectorXd acceleration = beam_.controlDisplacements(state.acceleration);
    if (!isInPlane()) {
        return axisValues(acceleration, locations);
    }
    const VectorXd displacement = beam_.controlDisplacements(state.displacement);
    const VectorXd velocity = beam_.controlDisplacements(state.velocity);
    MatrixXd values = MatrixXd::Zero(3, locations.size());
    for (std::size_t k = 0; k < locations.size(); ++k) {
        const double xi = locations[k].xi;
        values.col(k).head<2>() =
            sectionAcceleration(reference(xi), evaluate(displacement, xi), evaluate(velocity, xi),
                                evaluate(acceleration, xi), locations[k].zeta, beam_.isLinear());
    }
    return values;
}

double BeamBody::axialStress(const BeamState& state, const Location& location) const {
    const BeamSection& section = beam_.section();
    const double area = section.thickness * section.width;
    const double secondMoment = area * section.thickness * section.thickness / 12;
    // A fibre on the left is compressed if the tangent turns left.
    return state.normalForce / area - location.zeta * state.bendingMoment / secondMoment;
}

Body::Closest BeamBody::closest(const geometry::Point& point) const {
    const geometry::CurveProjection found = projector_.closest(point);
    const double half = 0.5 * beam_.section().thickness;
    if (!isInPlane()) {
        const double distance = (point - beam_.curve().point(found.xi)).norm();
        return {{0, found.xi, 0, 0}, std::max(0.0, distance - half)};
    }
    const BeamField axis = reference(found.xi);
    const Vector2d offset = point.head<2>() - axis.value;
    const Vector2d tangent = axis.slope.normalized();
    const double across = turned(tangent).dot(offset);
    const double zeta = std::clamp(across, -half, half);
    return {{0, found.xi, 0, zeta}, std::hypot(tangent.dot(offset), across - zeta, point[2])};
}

std::vector<std::string> BeamBody::advice() const {
    const BeamSection& section = beam_.section();
    const double share = section.thickness / beam_.length();
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
                    1 / share, 100 * shear,
                    shear > 0.02 ? "; a plane solid models it"
                                 : tooHighFrequencies(1 / share) + tooThinToBend(1 / share))};
    const double bend = section.thickness * largestCurvature(beam_.curve());
    if (bend > 1e-6) {
        lines.push_back(fmt::format("thickness over radius of curvature {:.3g}, terms of which "
                                    "order a beam leaves out{}",
                                    bend, bend > 0.1 ? "; a plane solid models them" : ""));
    }
    return lines;
}

WetSurface BeamBody::wetSurface(const std::vector<std::string>& /*names*/) const {
    assert(isInPlane());
    std::vector<int> controlPoints(beam_.curve().nControlPoints());
    std::iota(controlPoints.begin(), controlPoints.end(), 0);
    return mapper::SplineInterface({{beam_.curve(), controlPoints, "axis"}},
                                   beam_.curve().nControlPoints());
}

} // namespace tokay::structure
