// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampleGeometry.hpp"

#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"

#include <cmath>

namespace tokay::geometry {

NurbsCurve sampleCurve() {
    Points points(7, 3);
    points << 0, 0, 0, 1, 2, 0.5, 2, 2.5, 0, 3, 1, -0.5, 4, 1, 0, 5, 2, 1, 6, 0, 0;
    Eigen::VectorXd weights(7);
    weights << 1, 0.8, 1.5, 1, 0.6, 1.2, 1;
    return NurbsCurve(KnotVector(3, {0, 0, 0, 0, 0.3, 0.7, 0.7, 1, 1, 1, 1}), points, weights);
}

NurbsCurve curveWithCorner() {
    Points points(5, 3);
    points << 0, 0, 0, 1, 0.5, 0, 2, 0, 0, 2, 1, 0, 2.5, 2, 0;
    return NurbsCurve(KnotVector(2, {0, 0, 0, 0.5, 0.5, 1, 1, 1}), points);
}

NurbsSurface sampleSurface() {
    const KnotVector u(2, {0, 0, 0, 0.4, 1, 1, 1}), v(3, {0, 0, 0, 0, 0.5, 0.8, 1, 1, 1, 1});
    const int nU = u.nBasis(), nV = v.nBasis();
    Points points(nU * nV, 3);
    Eigen::VectorXd weights(nU * nV);
    for (int j = 0; j < nV; ++j) {
        for (int i = 0; i < nU; ++i) {
            points.row(i + nU * j) << i + 0.2 * std::sin(j), j + 0.3 * std::cos(2 * i),
                0.5 * std::sin(1.0 * i) * std::cos(0.7 * j);
            weights[i + nU * j] = 1 + 0.3 * std::sin(1.0 + i + 2 * j);
        }
    }
    return NurbsSurface(u, v, points, weights);
}

NurbsCurve parabola() {
    Points points(3, 3);
    points << -1, 1, 0, 0.5, -2, 0, 2, 4, 0;
    return NurbsCurve(KnotVector(2, {0, 0, 0, 1, 1, 1}), points);
}

NurbsSurface parabolicCylinder() {
    const NurbsCurve curve = parabola();
    Points points(6, 3);
    points << curve.controlPoints(), curve.controlPoints().rowwise() + Eigen::RowVector3d(0, 0, 1);
    return NurbsSurface(curve.knotVector(), KnotVector(1, {0, 0, 1, 1}), points);
}

TrimmedPatch plateBelowParabola() {
    NurbsCurve rim = parabola();
    Points parameters = rim.controlPoints();
    parameters.col(0) = (parameters.col(0).array() + 1) / 3;
    parameters.col(1) = (parameters.col(1).array() + 1) / 5;
    rim = reversed(rim.withControlPoints(parameters));
    const Point start(0, 0.4, 0), corner(0, 0, 0), otherCorner(1, 0, 0), end(1, 1, 0);
    return TrimmedPatch(
        rectangle(Point(-1, -1, 0), 3, 5),
        {TrimmingLoop(LoopKind::outer, {rim, line(start, corner), line(corner, otherCorner),
                                        line(otherCorner, end)})});
}

std::vector<double> sampleParameters(int n) {
    std::vector<double> parameters;
    for (int i = 0; i < n; ++i) {
        parameters.push_back(static_cast<double>(i) / (n - 1));
    }
    return parameters;
}

} // namespace tokay::geometry
