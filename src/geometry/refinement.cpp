#include "geometry/refinement.hpp"

#include "common/errors.hpp"
#include "geometry/SplineCoefficients.hpp"
#include "geometry/rational.hpp"
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

/// A surface is a spline in eta whose rows are whole lines of control points,
/// and a spline in xi once those lines are turned.
RowMatrix turned(const RowMatrix& net, int nLines, int nColumns) {
    const int nComponents = static_cast<int>(net.size()) / (nLines * nColumns);
    RowMatrix result(nColumns, nLines * nComponents);
    for (int j = 0; j < nLines; ++j)
        for (int i = 0; i < nColumns; ++i)
            result.row(i).segment(j * nComponents, nComponents) =
                net.row(j).segment(i * nComponents, nComponents);
    return result;
}

NurbsSurface refined(const NurbsSurface& surface, const Refinement& refinementU,
                     const Refinement& refinementV) {
    const RowMatrix points = homogeneous(surface.controlPoints(), surface.weights());
    const int nComponents = static_cast<int>(points.cols());
    const int nU = surface.u().nBasis(), nV = surface.v().nBasis();
    const RowMatrix net = Eigen::Map<const RowMatrix>(points.data(), nV, nU * nComponents);

    const SplineCoefficients fineV = refinementV({surface.v(), net});
    const int nFineV = fineV.knots.nBasis();
    const SplineCoefficients fineU = refinementU({surface.u(), turned(fineV.rows, nFineV, nU)});
    const int nFineU = fineU.knots.nBasis();
    const RowMatrix fineNet = turned(fineU.rows, nFineU, nFineV);
    const RowMatrix rows =
        Eigen::Map<const RowMatrix>(fineNet.data(), nFineU * nFineV, nComponents);
    auto [finePoints, fineWeights] = dehomogenised(rows);
    return NurbsSurface(fineU.knots, fineV.knots, std::move(finePoints), std::move(fineWeights));
}

Refinement insertion(const std::vector<double>& knots) {
    return [knots](const SplineCoefficients& spline) { return insertKnots(spline, knots); };
}

Refinement removal(const std::vector<double>& knots, double tolerance) {
    return [=](const SplineCoefficients& spline) { return removeKnots(spline, knots, tolerance); };
}

Refinement elevation(int by) {
    if (by < 0)
        throw InputError(fmt::format("The degree cannot be raised by {}.", by));
    return [by](SplineCoefficients spline) {
        for (int i = 0; i < by; ++i)
            spline = elevateDegree(spline);
        return spline;
    };
}

std::vector<double> divisionKnots(const KnotVector& knots, int nDivisions) {
    const std::vector<double>& breakpoints = knots.breakpoints();
    std::vector<double> added;
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i)
        for (int j = 1; j < nDivisions; ++j)
            added.push_back(breakpoints[i] +
                            (breakpoints[i + 1] - breakpoints[i]) * j / nDivisions);
    return added;
}

Refinement kRefinement(const KnotVector& knots, int degree, int nDivisions) {
    if (degree < knots.degree())
        throw InputError(fmt::format("The degree {} is below the geometry's own, {}: refinement "
                                     "only raises it.",
                                     degree, knots.degree()));
    if (nDivisions < 1)
        throw InputError(fmt::format("A knot span cannot be cut into {} parts.", nDivisions));
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

} // namespace tokay::geometry
