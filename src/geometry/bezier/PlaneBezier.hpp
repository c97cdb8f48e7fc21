// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "geometry/spline/Points.hpp"

#include <array>

namespace tokay::geometry {

/// Rational Bezier curve in parameter space over t in [0, 1]: a piece of a
/// trimming curve. Evaluation needs no heap; neighbours share ends to the bit.
class PlaneBezier {
  public:
    static constexpr int maxDegree = KnotVector::maxDegree;
    using Controls = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, maxDegree + 1>;

    /// @param controls  3 x (degree + 1), columns (w xi, w eta, w)
    explicit PlaneBezier(Controls controls);

    /// The Bezier pieces of a curve with control points (xi, eta, any).
    /// @throws InputError if the degree exceeds maxDegree.
    static std::vector<PlaneBezier> piecesOf(const NurbsCurve& curve);

    int degree() const { return static_cast<int>(controls_.cols()) - 1; }
    Parameters controlPoint(int i) const { return controls_.col(i).head<2>() / controls_(2, i); }
    double weight(int i) const { return controls_(2, i); }
    const Parameters& start() const { return start_; }
    const Parameters& end() const { return end_; }

    Parameters point(double t) const;
    struct Tangent {
        Parameters point, derivative;
    };
    Tangent tangent(double t) const;

    std::array<PlaneBezier, 2> split(double t) const;

    /// Copy with other ends, next to its own.
    PlaneBezier withEnds(const Parameters& start, const Parameters& end) const;

    /// Reversed curve.
    PlaneBezier reversed() const;

    /// The curve in coordinates (point - origin) * scale, for each direction.
    PlaneBezier scaled(const Parameters& origin, const Parameters& scale) const;

    /// Box of the control points, which contains the curve.
    ParameterBox box() const;

    /// Appends the start and points after it, the end left out, such that chords
    /// leave the curve by no more than the tolerance (for each direction).
    void appendChords(const Parameters& tolerance, std::vector<Parameters>& points) const;

    /// Where the coordinate turns, ascending, inside (0, 1).
    std::vector<double> extrema(int axis) const;

    /// Where a coordinate has a value, on a piece monotone in that coordinate;
    /// beyond the ends' values the nearer end.
    double parameterAt(int axis, double value) const;

  private:
    Controls controls_;
    Parameters start_, end_;
};

} // namespace tokay::geometry
