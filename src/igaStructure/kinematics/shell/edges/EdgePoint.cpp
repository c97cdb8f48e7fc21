// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/EdgePoint.hpp"

#include "common/errors.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/trimming/CurveOnSurface.hpp"
#include "igaStructure/kinematics/shell/element/ShellElement.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>

namespace tokay::structure {

namespace {

// How far a direction of the parameters can be followed across an element.
double acrossElement(const geometry::ParameterBox& box, const Eigen::Vector2d& direction) {
    return 1 / (direction.cwiseAbs().cwiseQuotient(box.size())).maxCoeff();
}

struct CurveLocation {
    geometry::Parameters at, derivative;
};

CurveLocation locationOn(const geometry::NurbsCurve& curve, double t) {
    const geometry::Points d = curve.derivatives(t, 1);
    return {d.row(0).head<2>().transpose(), d.row(1).head<2>().transpose()};
}

int largestDegree(const ShellPatch& patch) {
    return std::max(patch.surface().u().degree(), patch.surface().v().degree());
}

// A pole: the edge is one point.
bool isPoint(const geometry::CurveOnSurface& curve) {
    const geometry::Box whole = geometry::Box::around(curve.surface().controlPoints());
    return curve.box().diagonal() <= 1e-10 * whole.diagonal();
}

// The other curve's breakpoints as parameters of the first one, and its own.
std::vector<double> commonBreakpoints(const geometry::CurveOnSurface& curve,
                                      const geometry::CurveOnSurface& other) {
    std::vector<double> all = curve.breakpoints();
    for (const double t : other.breakpoints()) {
        all.push_back(curve.closest(other.derivatives(t, 0).row(0)).xi);
    }
    std::sort(all.begin(), all.end());
    const double least = 1e-9 * (all.back() - all.front());
    std::vector<double> distinct = {all.front()};
    for (const double t : all) {
        if (t > distinct.back() + least) {
            distinct.push_back(t);
        }
    }
    return distinct;
}

double fraction(const std::vector<double>& breakpoints, double t) {
    return (t - breakpoints.front()) / (breakpoints.back() - breakpoints.front());
}

template <class Visit>
void forEachGaussPoint(const std::vector<double>& breakpoints, int nPoints, Visit visit) {
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(nPoints);
    for (std::size_t k = 0; k + 1 < breakpoints.size(); ++k) {
        const double length = breakpoints[k + 1] - breakpoints[k];
        for (std::size_t g = 0; g < rule.points.size(); ++g) {
            visit(breakpoints[k] + length * rule.points[g], length * rule.weights[g]);
        }
    }
}

} // namespace

PatchLocation::PatchLocation(const ShellPatch& thePatch, const geometry::Parameters& at,
                             const Eigen::Vector2d& parameterTangent)
    : PatchLocation(thePatch, thePatch.patch().elementAt(at) % thePatch.patch().nElementsU(),
                    thePatch.patch().elementAt(at) / thePatch.patch().nElementsU(), at,
                    parameterTangent) {}

PatchLocation::PatchLocation(const ShellPatch& thePatch, int i, int j,
                             const geometry::Parameters& at,
                             const Eigen::Vector2d& parameterTangent)
    : patch(&thePatch), parameters(at), element(thePatch.patch().elementNumber(i, j)),
      tangent(parameterTangent), size(0) {
    ShellElement here;
    here.moveTo(thePatch, i, j);
    here.moveToPlace(at);
    nodes = here.nodes();
    N.resize(3, here.nFunctions());
    for (int row = 0; row < 3; ++row) {
        N.row(row) = Eigen::Map<const Eigen::RowVectorXd>(here.functions().row(row), N.cols());
    }
    position = here.position();
    baseVectors = here.reference().derivatives.leftCols<2>();
    if (!tangent.isZero(0)) {
        tangent /= (baseVectors * tangent).norm();
        size = acrossElement(thePatch.patch().elementBox(element), conormal());
    }
}

Eigen::Vector3d PatchLocation::normal() const {
    return baseVectors.col(0).cross(baseVectors.col(1)).normalized();
}

double PatchLocation::elementLength() const {
    return acrossElement(patch->patch().elementBox(element), tangent);
}

Eigen::Vector2d PatchLocation::conormal() const {
    const Eigen::Vector3d across = (baseVectors * tangent).cross(normal());
    const Eigen::Matrix2d metric = baseVectors.transpose() * baseVectors;
    return metric.inverse() * (baseVectors.transpose() * across);
}

std::vector<EdgePoint> edgePoints(const ShellPatch& patch, const geometry::NurbsCurve& curve) {
    const geometry::CurveOnSurface inSpace(curve, patch.surface());
    std::vector<EdgePoint> points;
    if (isPoint(inSpace)) {
        return points;
    }
    forEachGaussPoint(inSpace.breakpoints(), largestDegree(patch) + 1,
                      [&](double t, double weight) {
                          const CurveLocation place = locationOn(curve, t);
                          const double speed = inSpace.derivatives(t, 1).row(1).norm();
                          points.push_back({weight * speed,
                                            PatchLocation(patch, place.at, place.derivative),
                                            {},
                                            fraction(inSpace.breakpoints(), t)});
                      });
    return points;
}

std::vector<EdgePoint> edgePoints(const ShellPatch& patch, const geometry::NurbsCurve& curve,
                                  const ShellPatch& otherPatch,
                                  const geometry::NurbsCurve& otherCurve, double largestGap) {
    const geometry::CurveOnSurface first(curve, patch.surface());
    const geometry::CurveOnSurface second(otherCurve, otherPatch.surface());
    const int nPoints = std::max(largestDegree(patch), largestDegree(otherPatch)) + 1;
    std::vector<EdgePoint> points;
    if (isPoint(first) || isPoint(second)) {
        return points;
    }
    forEachGaussPoint(commonBreakpoints(first, second), nPoints, [&](double t, double weight) {
        const geometry::Points d = first.derivatives(t, 1);
        const geometry::CurveProjection found = second.closest(d.row(0));
        if (found.distance > largestGap) {
            throw InputError(fmt::format(
                "the patches \"{}\" and \"{}\" are {:.3g} m apart at their edge near ({:.6g}, "
                "{:.6g}, {:.6g}); at most {:.3g} m is allowed: correct the trimming curves",
                patch.patch().name(), otherPatch.patch().name(), found.distance, d(0, 0), d(0, 1),
                d(0, 2), largestGap));
        }
        const CurveLocation here = locationOn(curve, t);
        const CurveLocation there = locationOn(otherCurve, found.xi);
        points.push_back({weight * d.row(1).norm(), PatchLocation(patch, here.at, here.derivative),
                          PatchLocation(otherPatch, there.at, there.derivative),
                          fraction(first.breakpoints(), t)});
    });
    return points;
}

namespace {

// Points between elements k - 1 and k along an axis.
void addCrease(const ShellPatch& patch, int axis, int k, std::vector<EdgePoint>& points) {
    const geometry::KnotVector& across = axis == 0 ? patch.surface().u() : patch.surface().v();
    const geometry::KnotVector& along = axis == 0 ? patch.surface().v() : patch.surface().u();
    const Eigen::Vector2d tangent = (axis == 0 ? 1 : -1) * Eigen::Vector2d::Unit(1 - axis);
    const double knot = across.breakpoints()[k];
    for (int e = 0; e < along.nSpans(); ++e) {
        const std::vector<double> range = {along.breakpoints()[e], along.breakpoints()[e + 1]};
        forEachGaussPoint(range, along.degree() + 1, [&](double t, double weight) {
            const geometry::Parameters at =
                axis == 0 ? geometry::Parameters(knot, t) : geometry::Parameters(t, knot);
            if (!patch.patch().contains(at)) {
                return;
            }
            const PatchLocation before = axis == 0 ? PatchLocation(patch, k - 1, e, at, tangent)
                                                   : PatchLocation(patch, e, k - 1, at, tangent);
            const PatchLocation after = axis == 0 ? PatchLocation(patch, k, e, at, -tangent)
                                                  : PatchLocation(patch, e, k, at, -tangent);
            points.push_back({weight * before.baseVectors.col(1 - axis).norm(), before, after});
        });
    }
}

} // namespace

std::vector<EdgePoint> creasePoints(const ShellPatch& patch) {
    std::vector<EdgePoint> points;
    for (int axis = 0; axis < 2; ++axis) {
        const geometry::KnotVector& knots = axis == 0 ? patch.surface().u() : patch.surface().v();
        for (int k = 1; k < knots.nSpans(); ++k) {
            if (knots.multiplicity(knots.breakpoints()[k]) >= knots.degree()) {
                addCrease(patch, axis, k, points);
            }
        }
    }
    return points;
}

std::optional<geometry::Edge> rimOf(const geometry::NurbsCurve& curve,
                                    const geometry::NurbsSurface& surface) {
    const geometry::KnotVector* ranges[2] = {&surface.u(), &surface.v()};
    const geometry::Points& points = curve.controlPoints();
    const auto near = [&](int axis, double value, double wanted) {
        return std::abs(value - wanted) <= 1e-9 * (ranges[axis]->last() - ranges[axis]->first());
    };
    constexpr geometry::Edge edges[2][2] = {{geometry::Edge::left, geometry::Edge::right},
                                            {geometry::Edge::bottom, geometry::Edge::top}};
    for (int axis = 0; axis < 2; ++axis) {
        const int along = 1 - axis;
        const double from = points.col(along).minCoeff();
        const double to = points.col(along).maxCoeff();
        if (!near(along, from, ranges[along]->first()) || !near(along, to, ranges[along]->last())) {
            continue;
        }
        for (int end = 0; end < 2; ++end) {
            const double wanted = end == 0 ? ranges[axis]->first() : ranges[axis]->last();
            if (near(axis, points.col(axis).minCoeff(), wanted) &&
                near(axis, points.col(axis).maxCoeff(), wanted)) {
                return edges[axis][end];
            }
        }
    }
    return std::nullopt;
}

} // namespace tokay::structure
