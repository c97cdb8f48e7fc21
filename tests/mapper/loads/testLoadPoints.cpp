// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/primitives.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "geometry/spline/refinement.hpp"
#include "geometry/trimming/elementQuadrature.hpp"
#include "mapper/interface/SurfaceMesh.hpp"
#include "mapper/loads/FaceSizes.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/sampleInterfaces.hpp"
#include "mapper/sampleMeshes.hpp"
#include "mapper/samplePatches.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>

using namespace tokay;
using namespace tokay::mapper;
using Eigen::VectorXd;

namespace {

FaceMesh edgesAlong(const std::vector<Point>& points) {
    FaceMesh mesh{Points(points.size(), 3), {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        mesh.vertices.row(i) = points[i];
        if (i > 0) {
            mesh.faces.push_back({static_cast<int>(i) - 1, static_cast<int>(i)});
        }
    }
    return mesh;
}

FaceMesh line(int n) {
    std::vector<Point> points;
    for (int i = 0; i <= n; ++i) {
        points.emplace_back(0, static_cast<double>(i) / n, 0);
    }
    return edgesAlong(points);
}

FaceMesh arc(int n, double radius) {
    std::vector<Point> points;
    for (int i = 0; i <= n; ++i) {
        const double angle = 0.5 * M_PI * i / n;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    return edgesAlong(points);
}

FaceMesh facesOf(int nX, int nY, FaceKind kind, int seed = 0) {
    const SurfaceMesh mesh = flatMesh(nX, nY, kind, ValuesAt::vertices, 2, 1, seed);
    FaceMesh faces{mesh.vertices(), {}};
    for (int i = 0; i < mesh.nTriangles(); ++i) {
        if (i == 0 || mesh.faceOf(i) != mesh.faceOf(i - 1)) {
            faces.faces.push_back(mesh.functions(i, geometry::Barycentric::Zero()).values);
        }
    }
    return faces;
}

Points centroids(const FaceMesh& mesh) {
    const bool isPlane = mesh.faces.front().size() == 2;
    if (!isPlane) {
        return SurfaceMesh(mesh.vertices, mesh.faces, ValuesAt::faces).coordinates();
    }
    Points centres(mesh.nFaces(), 3);
    for (int i = 0; i < mesh.nFaces(); ++i) {
        centres.row(i) = mesh.vertices(mesh.faces[i], Eigen::all).colwise().mean();
    }
    return centres;
}

/// Shares sum to 1 and meet at the centroid, to rounding of the mesh's size 2.
void expectForceAndMomentKept(const LoadPoints& loads, const FaceMesh& mesh) {
    const VectorXd sums = loads.shares.transpose() * VectorXd::Ones(loads.points.rows());
    EXPECT_LT((sums.array() - 1).abs().maxCoeff(), 1e-13);
    const Points means = loads.shares.transpose() * loads.points;
    EXPECT_LT((means - centroids(mesh)).cwiseAbs().maxCoeff(), 1e-12);
}

/// Loads on control points of a unit force on each face.
template <class Splines>
VectorXd controlLoads(const Splines& splines, const LoadPoints& loads, const VectorXd& forces) {
    const NearestElementMapping mapping(splines, loads.points, {0.1, true}); // chords
    return mapping.applyTransposed(loads.shares * forces);
}

VectorXd lengths(const FaceMesh& mesh) {
    VectorXd lengths(mesh.nFaces());
    for (int i = 0; i < mesh.nFaces(); ++i) {
        lengths[i] =
            (mesh.vertices.row(mesh.faces[i].back()) - mesh.vertices.row(mesh.faces[i].front()))
                .norm();
    }
    return lengths;
}

VectorXd areas(const FaceMesh& mesh) {
    const SurfaceMesh surface(mesh.vertices, mesh.faces, ValuesAt::faces);
    VectorXd areas = VectorXd::Zero(mesh.nFaces());
    for (int i = 0; i < surface.nTriangles(); ++i) {
        areas[surface.faceOf(i)] += surface.triangle(i).area();
    }
    return areas;
}

/// Integrals of the functions of a curve.
VectorXd integralsAlong(const SplineInterface& splines) {
    VectorXd integrals = VectorXd::Zero(splines.nValues());
    const InterfaceCurve& curve = splines.curve(0);
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(10);
    for (std::size_t e = 0; e + 1 < curve.breakpoints().size(); ++e) {
        const double first = curve.breakpoints()[e];
        const double length = curve.breakpoints()[e + 1] - first;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double xi = first + length * rule.points[q];
            const Functions at = curve.functions(xi);
            const double weight = rule.weights[q] * length * curve.derivatives(xi, 1).row(1).norm();
            for (std::size_t k = 0; k < at.values.size(); ++k) {
                integrals[at.values[k]] += weight * at.weights[k];
            }
        }
    }
    return integrals;
}

VectorXd integralsOver(const SurfaceInterface& splines, int piece) {
    VectorXd integrals = VectorXd::Zero(splines.nValues());
    const geometry::TrimmedPatch& patch = splines.piece(piece).patch;
    for (int element = 0; element < patch.nElements(); ++element) {
        for (const geometry::ParameterPoint& at : geometry::elementQuadrature(patch, element, 8)) {
            const Points d = patch.basis().derivatives(at.xi, at.eta, 1);
            const double weight = at.weight * Point(d.row(1)).cross(Point(d.row(2))).norm();
            const Functions functions = splines.functions(piece, at.xi, at.eta);
            for (std::size_t k = 0; k < functions.values.size(); ++k) {
                integrals[functions.values[k]] += weight * functions.weights[k];
            }
        }
    }
    return integrals;
}

/// Of a triangle on plates of several spans.
void expectEvenLoad(const FaceMesh& mesh, double longestSide) {
    const Eigen::RowVector3d centroid = mesh.vertices.colwise().mean();
    double sides = 0;
    for (int i = 0; i < 3; ++i) {
        sides += (mesh.vertices.row((i + 1) % 3) - mesh.vertices.row(i)).squaredNorm();
    }
    // Shorter sides of spans in each direction
    for (const auto& [nX, nY, span] : {std::tuple{8, 4, 0.25}, {2, 8, 0.125}, {16, 2, 0.125}}) {
        const SurfaceInterface splines = onePatch(geometry::TrimmedPatch(plate(nX, nY)));
        const LoadPoints loads = integratedLoads(splines, mesh, 0.02);
        double spread = 0;
        for (Eigen::Index i = 0; i < loads.points.rows(); ++i) {
            spread += loads.shares.coeff(i, 0) * (loads.points.row(i) - centroid).squaredNorm();
        }
        // Of an even load the mean square of the distance from the centroid is the sum of the
        // squared sides over 36; points at the centroids of n^2 parts miss 1 / n^2 of it.
        const int n = static_cast<int>(std::lround(std::sqrt(loads.points.rows())));
        EXPECT_GE(n, 2 * longestSide / span - 1); // two points a span along the longest side
        EXPECT_LE(n, 2 * longestSide / span + 1);
        EXPECT_NEAR(spread, sides / 36, 1.01 / (n * n) * sides / 36);
    }
}

} // namespace

TEST(LoadPoints, shares_of_vertices_keep_force_and_moment_with_hanging_nodes_too) {
    // Hexagons are quadrilaterals with vertices in the middle of sides.
    for (const FaceKind kind :
         {FaceKind::triangles, FaceKind::quadrilaterals, FaceKind::polygons}) {
        const FaceMesh mesh = facesOf(4, 3, kind);
        expectForceAndMomentKept(loadsAtVertices(mesh), mesh);
    }
    expectForceAndMomentKept(loadsAtVertices(line(7)), line(7));
}

TEST(LoadPoints, integrated_loads_on_curves_keep_force_and_moment) {
    for (const int nFaces : {1, 7, 100}) {
        expectForceAndMomentKept(integratedLoads(verticalSpline(3, 6), line(nFaces)), line(nFaces));
        expectForceAndMomentKept(integratedLoads(quarterCircle(2, 5), arc(nFaces, 1)),
                                 arc(nFaces, 1));
    }
}

TEST(LoadPoints, integrated_loads_on_patches_keep_force_and_moment) {
    const SurfaceInterface holed = onePatch(holedPlate());
    const SurfaceInterface bent = onePatch(geometry::TrimmedPatch(bentParameters(4, 3)));
    const SurfaceInterface two = twoPatches();
    for (const FaceKind kind :
         {FaceKind::triangles, FaceKind::quadrilaterals, FaceKind::polygons}) {
        const FaceMesh mesh = facesOf(5, 3, kind);
        for (const SurfaceInterface* splines : {&holed, &bent, &two}) {
            expectForceAndMomentKept(integratedLoads(*splines, mesh, 0.02), mesh);
        }
    }
}

TEST(LoadPoints, uniform_traction_on_a_line_is_its_consistent_load_at_any_ratio_of_sizes) {
    for (const auto& [nFaces, nSpans] :
         {std::pair{1, 100}, {3, 100}, {10, 40}, {12, 12}, {40, 10}, {100, 3}, {100, 1}}) {
        for (const int degree : {1, 2, 3, 4}) {
            const SplineInterface splines = verticalSpline(degree, nSpans);
            const FaceMesh mesh = line(nFaces);
            const VectorXd loads =
                controlLoads(splines, integratedLoads(splines, mesh), lengths(mesh));
            // Gauss points are exact on a straight line; closest points end at 1e-12.
            EXPECT_LT((loads - integralsAlong(splines)).cwiseAbs().maxCoeff(), 1e-11)
                << nFaces << " faces, " << nSpans << " spans, degree " << degree;
        }
    }
}

TEST(LoadPoints, direction_of_edges_does_not_matter_for_the_consistent_load) {
    FaceMesh mesh = line(3);
    for (std::vector<int>& face : mesh.faces) {
        std::swap(face[0], face[1]);
    }
    const SplineInterface splines = verticalSpline(2, 10);
    const VectorXd loads = controlLoads(splines, integratedLoads(splines, mesh), lengths(mesh));
    // Gauss points are exact on a straight line; closest points end at 1e-12.
    EXPECT_LT((loads - integralsAlong(splines)).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(LoadPoints, face_without_area_is_shared_by_its_vertices) {
    FaceMesh mesh{Points(4, 3), {{0, 1, 2, 3}, {1}, {2, 0}}};
    mesh.vertices << 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3;
    const Eigen::MatrixXd shares = loadsAtVertices(mesh).shares;
    EXPECT_LT((shares.col(0) - VectorXd::Constant(4, 0.25)).norm(), 1e-15);
    EXPECT_LT((shares.col(1) - VectorXd::Unit(4, 1)).norm(), 1e-15);
    EXPECT_LT((shares.col(2) - 0.5 * (VectorXd::Unit(4, 0) + VectorXd::Unit(4, 2))).norm(), 1e-15);
}

TEST(LoadPoints, vertices_of_faces_larger_than_spans_leave_functions_without_load) {
    const SplineInterface splines = verticalSpline(2, 32);
    const VectorXd loads = controlLoads(splines, loadsAtVertices(line(8)), lengths(line(8)));
    EXPECT_EQ(loads.minCoeff(), 0); // what integration is for
    EXPECT_EQ(faceSizes(splines, line(8)).nOverSpan, 8);
}

TEST(LoadPoints, uniform_traction_on_a_plate_is_its_consistent_load_at_any_ratio_of_sizes) {
    for (const auto& [nFaces, nSpans] : {std::pair{1, 100}, {1, 20}, {4, 4}, {3, 5}, {60, 1}}) {
        const SurfaceInterface splines =
            onePatch(geometry::TrimmedPatch(plate(2 * nSpans, nSpans)));
        const FaceMesh mesh = facesOf(2 * nFaces, nFaces, FaceKind::quadrilaterals);
        const VectorXd loads =
            controlLoads(splines, integratedLoads(splines, mesh, 0.02), areas(mesh));
        const VectorXd exact = integralsOver(splines, 0);
        // The pieces are affine: exact but for closest points, and on faces of less than half
        // a span to the third order of their size, (1/60)^3 here.
        const double limit = nSpans < nFaces ? 5e-6 : 1e-9;
        EXPECT_LT((loads - exact).cwiseAbs().maxCoeff(), limit * exact.maxCoeff())
            << nFaces << " faces, " << nSpans << " spans";
    }
}

TEST(LoadPoints, chords_of_a_circle_load_it_at_least_to_second_order_of_the_faces) {
    const SplineInterface splines = quarterCircle(2, 40);
    const VectorXd exact = integralsAlong(splines);
    double before = 0;
    for (const int nFaces : {4, 8, 16}) {
        const FaceMesh mesh = arc(nFaces, 1);
        // The same traction on the chords, which are shorter than the arc.
        const VectorXd forces = VectorXd::Constant(nFaces, 0.5 * M_PI / nFaces);
        const double error = (controlLoads(splines, integratedLoads(splines, mesh), forces) - exact)
                                 .cwiseAbs()
                                 .maxCoeff() /
                             exact.maxCoeff();
        if (before > 0) {
            EXPECT_GT(std::log2(before / error), 1.9);
        }
        before = error;
    }
    EXPECT_LT(before, 5e-3);
}

TEST(LoadPoints, faces_over_a_hole_load_its_rim) {
    // The fluid has no hole where the structure has one: nothing is lost.
    const SurfaceInterface splines = onePatch(holedPlate());
    const FaceMesh mesh = facesOf(8, 4, FaceKind::triangles);
    const LoadPoints loads = integratedLoads(splines, mesh, 0.02);
    const NearestElementMapping mapping(splines, loads.points, {0.3, true});
    const VectorXd onControlPoints = mapping.applyTransposed(loads.shares * areas(mesh));
    EXPECT_NEAR(onControlPoints.sum(), 2, 1e-12); // area of the plate, pressure 1
}

TEST(LoadPoints, traction_beside_a_line_is_its_consistent_load_too) {
    // Edges shorter than their distance from the spline, neither dividing the other's.
    const SplineInterface splines = verticalSpline(2, 7);
    FaceMesh mesh = line(10);
    mesh.vertices.col(0).setConstant(0.3);
    const LoadPoints loads = integratedLoads(splines, mesh);
    const NearestElementMapping mapping(splines, loads.points, {0.5, true});
    const VectorXd onControlPoints = mapping.applyTransposed(loads.shares * lengths(mesh));
    // As on the line: Gauss points are exact, closest points end at 1e-12.
    EXPECT_LT((onControlPoints - integralsAlong(splines)).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(LoadPoints, faces_partly_beyond_a_patch_are_loaded_evenly) {
    // A triangle of which the patch covers less than a half, large beside its spans.
    FaceMesh mesh{Points(3, 3), {{0, 1, 2}}};
    mesh.vertices << 1.5, 0.2, 0, 3.1, 0.4, 0, 1.9, 0.9, 0;
    expectEvenLoad(mesh, 1.62);
    // Another one of which it covers all but a hundredth: a corner of a tenth.
    mesh.vertices << 0.5, 0.2, 0, 2.1, 0.4, 0, 0.9, 0.9, 0;
    expectEvenLoad(mesh, 1.62);
}

TEST(LoadPoints, no_part_of_a_face_over_a_steep_rib_pulls) {
    // A plate with a rib of one span's width; the area of its flanks is many times that of
    // the face over it. Wherever the rib is, shares of a pressure are none of suction.
    constexpr int nX = 40;
    FaceMesh mesh{Points(3, 3), {{0, 1, 2}}};
    mesh.vertices << 0.05, 0.05, 0, 1.95, 0.05, 0, 0.05, 0.95, 0;
    for (int rib = 3; rib < nX - 2; ++rib) {
        const geometry::NurbsSurface flat =
            refine(geometry::rectangle(Point::Zero(), 2, 1), 1, 1, nX, 1);
        Points controlPoints = flat.controlPoints();
        for (const int row : {0, nX + 1}) {
            controlPoints(rib + row, 2) = 3;
        }
        const LoadPoints loads = integratedLoads(
            onePatch(geometry::TrimmedPatch(flat.withControlPoints(controlPoints))), mesh, 0.02);
        EXPECT_GE(Eigen::MatrixXd(loads.shares).minCoeff(), 0) << rib;
        expectForceAndMomentKept(loads, mesh);
    }
}

TEST(LoadPoints, faces_up_to_half_a_span_take_fewer_points_than_larger_ones) {
    const auto nPoints = [](double size) {
        FaceMesh mesh{Points(3, 3), {{0, 1, 2}}};
        // Its root of the area is the size, in a span of 1 x 1.
        const double side = std::sqrt(2.0) * size;
        mesh.vertices << 0.01, 0.01, 0, 0.01 + side, 0.01, 0, 0.01, 0.01 + side, 0;
        const SurfaceInterface splines = onePatch(geometry::TrimmedPatch(plate(2, 1)));
        return integratedLoads(splines, mesh, 0.02).points.rows();
    };
    EXPECT_EQ(nPoints(0.49), 3); // the rule of degree 2
    EXPECT_EQ(nPoints(0.04), 3);
    EXPECT_GT(nPoints(0.51), nPoints(0.49));
}

TEST(FaceSizes, are_in_lengths_whatever_the_parameters_and_tell_smallest_and_largest) {
    // Spans of 1/4 of a quarter circle of radius 1, of which edges are chords.
    FaceMesh mesh = arc(2, 1);
    const FaceMesh fine = arc(8, 1);
    mesh.vertices.conservativeResize(mesh.vertices.rows() + fine.vertices.rows(), 3);
    mesh.vertices.bottomRows(fine.vertices.rows()) = fine.vertices;
    mesh.faces.push_back({3, 4});
    mesh.faces.push_back({0, 1});
    const double span = 0.125 * M_PI;
    const FaceSizes sizes = faceSizes(quarterCircle(2, 4), mesh);
    // A rational circle has its parameter within 10 % of the angle's, so have its spans.
    EXPECT_NEAR(sizes.smallest, 2 * std::sin(M_PI / 32) / span, 0.1 * sizes.smallest);
    EXPECT_NEAR(sizes.largest, 2 * std::sin(M_PI / 8) / span, 0.1 * sizes.largest);
    EXPECT_EQ(sizes.nFaces, 4);
}

TEST(FaceSizes, ratios_are_those_of_lengths_and_of_roots_of_areas) {
    const FaceSizes ofLine = faceSizes(verticalSpline(2, 8), line(4));
    EXPECT_NEAR(ofLine.smallest, 2, 1e-12);
    EXPECT_NEAR(ofLine.largest, 2, 1e-12);
    EXPECT_EQ(faceSizes(verticalSpline(2, 4), line(4)).nOverSpan, 0);
    FaceMesh square{Points(4, 3), {{0, 1, 2, 3}}};
    square.vertices << 0.1, 0.1, 0, 0.6, 0.1, 0, 0.6, 0.6, 0, 0.1, 0.6, 0;
    const FaceSizes ofPlate =
        faceSizes(onePatch(geometry::TrimmedPatch(plate(2, 1))), square); // spans 1 x 1
    EXPECT_NEAR(ofPlate.largest, 0.5, 1e-12);
}

TEST(FaceSizes, faces_as_large_as_spans_to_rounding_are_not_larger) {
    // Neither numbers of the line's direction nor twenty-firsts are exact.
    const Point end(0.3, 0.7, 0.2);
    const geometry::NurbsCurve curve = refine(geometry::line(Point::Zero(), end), 2, 21);
    std::vector<int> numbers(static_cast<std::size_t>(curve.nControlPoints()));
    std::iota(numbers.begin(), numbers.end(), 0);
    const SplineInterface splines({{curve, numbers, "line"}}, curve.nControlPoints());
    const auto nOverSpan = [&](int nFaces) {
        std::vector<Point> points;
        for (int i = 0; i <= nFaces; ++i) {
            points.push_back(i / static_cast<double>(nFaces) * end);
        }
        return faceSizes(splines, edgesAlong(points)).nOverSpan;
    };
    EXPECT_EQ(nOverSpan(21), 0);
    EXPECT_EQ(nOverSpan(20), 20); // by a twentieth
}

TEST(FaceSizes, are_relative_to_the_span_at_the_centre_of_the_face) {
    // Spans of 0.1 and 0.9.
    Points controlPoints(3, 3);
    controlPoints << 0, 0, 0, 0.1, 0, 0, 1, 0, 0;
    const geometry::NurbsCurve curve(geometry::KnotVector(1, {0, 0, 0.1, 1, 1}), controlPoints);
    const SplineInterface splines({{curve, {0, 1, 2}, "line"}}, 3);
    FaceMesh mesh{Points(4, 3), {{0, 1}, {2, 3}}};
    mesh.vertices << 0.02, 0, 0, 0.07, 0, 0, 0.05, 0, 0, 0.95, 0, 0;
    const FaceSizes sizes = faceSizes(splines, mesh);
    EXPECT_NEAR(sizes.smallest, 0.5, 1e-12);
    EXPECT_NEAR(sizes.largest, 1, 1e-12); // its first vertex lies in the short span
}

TEST(FaceSizes, in_space_are_relative_to_the_span_at_the_centre_of_the_face) {
    // x = xi^2 and y = eta: an element of 2 xi of its parameters' area.
    geometry::NurbsSurface surface = refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 1, 1);
    Points controlPoints = surface.controlPoints();
    for (Eigen::Index i = 0; i < controlPoints.rows(); ++i) {
        controlPoints(i, 0) = i % 3 == 2 ? 1 : 0;
    }
    const SurfaceInterface splines =
        onePatch(geometry::TrimmedPatch(surface.withControlPoints(controlPoints)));
    FaceMesh mesh{Points(4, 3), {{0, 1, 2, 3}}};
    mesh.vertices << 0.04, 0.1, 0, 0.28, 0.1, 0, 0.28, 0.3, 0, 0.04, 0.3, 0; // around xi = 0.4
    EXPECT_NEAR(faceSizes(splines, mesh).largest, std::sqrt(0.24 * 0.2 / (2 * 0.4)), 1e-9);
}
