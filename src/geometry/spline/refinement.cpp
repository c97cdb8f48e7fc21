// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/refinement.hpp"

#include "common/errors.hpp"
#include "geometry/spline/SplineCoefficients.hpp"
#include "geometry/spline/rational.hpp"

#include <fmt/format.h>

#include <functional>

namespace tokay::geometry {

namespace {

using Refinement = std::function<SplineCoefficients(const SplineCoefficients&)>;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

NurbsCurve refined(const NurbsCurve& curve, const Refinement& refinement) {
    const SplineCoefficients fine =
        refinement({curve.knotVector(), homogeneous(curve.controlPoints(), curve.weights())});
    auto [points, weights] = dehomogenised(fine.rows);
    return NurbsCurve(fine.knots, std::move(points), std::move(weights));
}

/// The net of control points with its two blocks of directions exchanged.
RowMatrix turned(const RowMatrix& net, int nLines, int nColumns) {
    const int nComponents = static_cast<int>(net.size()) / (nLines * nColumns);
    RowMatrix result(nColumns, nLines * nComponents);
    for (int j = 0; j < nLines; ++j) {
        for (int i = 0; i < nColumns; ++i) {
            result.row(i).segment(j * nComponents, nComponents) =
                net.row(j).segment(i * nComponents, nComponents);
        }
    }
    return result;
}

struct RefinedNet {
    std::vector<KnotVector> directions;
    Points points;
    Eigen::VectorXd weights;
};

/// A tensor product is a spline in its last direction, whose rows are whole
/// surfaces or lines of control points; turned, it is one in the last but one.
RefinedNet refined(std::vector<KnotVector> directions, const Points& controlPoints,
                   const Eigen::VectorXd& weights, const std::vector<Refinement>& refinements) {
    RowMatrix net = homogeneous(controlPoints, weights);
    const auto nComponents = static_cast<int>(net.cols());
    auto nPoints = static_cast<int>(net.rows());
    for (std::size_t d = directions.size(); d-- > 0;) {
        const int nLines = directions[d].nBasis(), nColumns = nPoints / nLines;
        const RowMatrix lines =
            Eigen::Map<const RowMatrix>(net.data(), nLines, nColumns * nComponents);
        SplineCoefficients fine = refinements[d]({directions[d], lines});
        directions[d] = std::move(fine.knots);
        net = turned(fine.rows, directions[d].nBasis(), nColumns);
        nPoints = directions[d].nBasis() * nColumns;
    }
    auto [points, fineWeights] =
        dehomogenised(Eigen::Map<const RowMatrix>(net.data(), nPoints, nComponents));
    return {std::move(directions), std::move(points), std::move(fineWeights)};
}

NurbsSurface refined(const NurbsSurface& surface, const Refinement& refinementU,
                     const Refinement& refinementV) {
    RefinedNet fine = refined({surface.u(), surface.v()}, surface.controlPoints(),
                              surface.weights(), {refinementU, refinementV});
    return NurbsSurface(fine.directions[0], fine.directions[1], std::move(fine.points),
                        std::move(fine.weights));
}

NurbsVolume refined(const NurbsVolume& volume, const std::vector<Refinement>& refinements) {
    RefinedNet fine = refined({volume.u(), volume.v(), volume.w()}, volume.controlPoints(),
                              volume.weights(), refinements);
    return NurbsVolume(fine.directions[0], fine.directions[1], fine.directions[2],
                       std::move(fine.points), std::move(fine.weights));
}

Refinement insertion(const std::vector<double>& knots) {
    return [knots](const SplineCoefficients& spline) { return insertKnots(spline, knots); };
}

Refinement removal(const std::vector<double>& knots, double tolerance) {
    return [=](const SplineCoefficients& spline) { return removeKnots(spline, knots, tolerance); };
}

Refinement elevation(int by) {
    if (by < 0) {
        throw InputError(fmt::format("the degree cannot be raised by {}", by));
    }
    return [by](SplineCoefficients spline) {
        for (int i = 0; i < by; ++i) {
            spline = elevateDegree(spline);
        }
        return spline;
    };
}

std::vector<double> divisionKnots(const KnotVector& knots, int nDivisions) {
    const std::vector<double>& breakpoints = knots.breakpoints();
    std::vector<double> added;
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        for (int j = 1; j < nDivisions; ++j) {
            added.push_back(breakpoints[i] +
                            (breakpoints[i + 1] - breakpoints[i]) * j / nDivisions);
        }
    }
    return added;
}

Refinement kRefinement(const KnotVector& knots, int degree, int nDivisions) {
    if (degree < knots.degree()) {
        throw InputError(fmt::format("the degree {} is below the geometry's own, {}: refinement "
                                     "only raises it",
                                     degree, knots.degree()));
    }
    if (nDivisions < 1) {
        throw InputError(fmt::format("a knot span cannot be cut into {} parts", nDivisions));
    }
    const Refinement elevate = elevation(degree - knots.degree());
    return [=](const SplineCoefficients& spline) {
        return insertKnots(elevate(spline), divisionKnots(knots, nDivisions));
    };
}

} // namespace

NurbsCurve insertKnots(const NurbsCurve& curve, const std::vector<double>& knots) {
    return refined(curve, insertion(knots));
}

NurbsCurve removeKnots(const NurbsCurve& curve, const std::vector<double>& knots,
                       double tolerance) {
    return refined(curve, removal(knots, tolerance));
}

NurbsCurve elevateDegree(const NurbsCurve& curve, int by) {
    return refined(curve, elevation(by));
}

NurbsCurve refine(const NurbsCurve& curve, int degree, int nDivisions) {
    return refined(curve, kRefinement(curve.knotVector(), degree, nDivisions));
}

NurbsSurface insertKnots(const NurbsSurface& surface, const std::vector<double>& knotsU,
                         const std::vector<double>& knotsV) {
    return refined(surface, insertion(knotsU), insertion(knotsV));
}

NurbsSurface removeKnots(const NurbsSurface& surface, const std::vector<double>& knotsU,
                         const std::vector<double>& knotsV, double tolerance) {
    return refined(surface, removal(knotsU, tolerance), removal(knotsV, tolerance));
}

NurbsSurface elevateDegree(const NurbsSurface& surface, int byU, int byV) {
    return refined(surface, elevation(byU), elevation(byV));
}

NurbsSurface refine(const NurbsSurface& surface, int degreeU, int degreeV, int nDivisionsU,
                    int nDivisionsV) {
    return refined(surface, kRefinement(surface.u(), degreeU, nDivisionsU),
                   kRefinement(surface.v(), degreeV, nDivisionsV));
}

NurbsVolume insertKnots(const NurbsVolume& volume,
                        const std::array<std::vector<double>, 3>& knots) {
    return refined(volume, {insertion(knots[0]), insertion(knots[1]), insertion(knots[2])});
}

NurbsVolume elevateDegree(const NurbsVolume& volume, const std::array<int, 3>& by) {
    return refined(volume, {elevation(by[0]), elevation(by[1]), elevation(by[2])});
}

NurbsVolume refine(const NurbsVolume& volume, const std::array<int, 3>& degrees,
                   const std::array<int, 3>& nDivisions) {
    std::vector<Refinement> refinements;
    for (int axis = 0; axis < 3; ++axis) {
        refinements.push_back(kRefinement(volume.direction(axis), degrees[axis], nDivisions[axis]));
    }
    return refined(volume, refinements);
}

} // namespace tokay::geometry
