// SPDX-License-Identifier: GPL-3.0-or-later
#include "expectPatchTest.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/rbf/RbfMapping.hpp"
#include "sampleInterfaces.hpp"
#include "sampleMeshes.hpp"
#include "samplePatches.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace tokay::mapper {

namespace {

using geometry::LoopKind;
using geometry::NurbsSurface;
using geometry::TrimmedPatch;
using geometry::TrimmingLoop;

MortarOptions minimumNorm() {
    MortarOptions options;
    options.singular = SingularMass::minimumNorm;
    return options;
}

SurfaceMesh mesh(int nX, int nY, int seed = 0) {
    return flatMesh(nX, nY, FaceKind::triangles, ValuesAt::vertices, 2, 1, seed);
}

SurfaceInterface wholePlate(int nX, int nY) {
    return onePatch(TrimmedPatch(plate(nX, nY)));
}

/// [0, 1] x [0, 1e-3].
SurfaceInterface stripe(int nX, int nY) {
    return onePatch(
        TrimmedPatch(refine(geometry::rectangle(Point::Zero(), 1, 1e-3), 2, 2, nX, nY)));
}

/// A rotation, a scale and a way that is 1e6 times the interface or none.
struct Placement {
    double scale, way;

    Points operator()(const Points& x) const {
        const Eigen::Matrix3d rotation =
            Eigen::AngleAxisd(1.1, Point(1, 2, -1).normalized()).toRotationMatrix();
        return (scale * x * rotation.transpose()).rowwise() +
               scale * way * Eigen::RowVector3d(1, -0.3, 0.2);
    }
    SurfaceInterface operator()(const TrimmedPatch& patch) const {
        const NurbsSurface& surface = patch.basis();
        return onePatch(TrimmedPatch(surface.withControlPoints((*this)(surface.controlPoints())),
                                     patch.loops()));
    }
    /// Quadrilaterals in rows, as vertices of a shaken grid.
    SurfaceMesh operator()(int n, int seed) const {
        SurfaceMesh::Faces faces;
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const int a = i + (n + 1) * j;
                faces.push_back({a, a + 1, a + n + 2, a + n + 1});
            }
        }
        return SurfaceMesh((*this)(mesh(n, n, seed).vertices()), faces, ValuesAt::vertices);
    }
    /// Coordinates of size 1e6 carry 1e-10 of the interface's size, which the inverse of the
    /// mass matrix and the slopes of the functions enlarge.
    double tolerance() const { return way > 0 ? 1e-7 : 1e-11; }
};

const Placement placements[] = {{1e-6, 0}, {1, 0}, {1e6, 0}, {1e-6, 1e6}, {1, 1e6}, {1e6, 1e6}};

template <class Map>
void expectPlaceDoesNotMatter(const Map& map) {
    const Points reference = map(Placement{1, 0});
    ASSERT_TRUE(reference.allFinite());
    for (const Placement& placement : placements) {
        EXPECT_LT((map(placement) - reference).cwiseAbs().maxCoeff(),
                  placement.tolerance() * reference.cwiseAbs().maxCoeff())
            << placement.scale << ", " << placement.way;
    }
}

/// Faces of a grid of n x n quadrilaterals; every third one is turned over.
SurfaceMesh::Faces someInverted(int n) {
    SurfaceMesh::Faces faces;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = i + (n + 1) * j;
            faces.push_back({a, a + 1, a + n + 2, a + n + 1});
            if (faces.size() % 3 == 0) {
                std::reverse(faces.back().begin(), faces.back().end());
            }
        }
    }
    return faces;
}

} // namespace

TEST(Extremes, a_hundred_faces_on_a_side_of_a_knot_span_and_the_other_way_round) {
    for (const auto& [splines, faces] :
         {std::pair(wholePlate(1, 1), mesh(100, 100)), {wholePlate(100, 50), mesh(1, 1)}}) {
        expectPatchTest(faces, splines, minimumNorm());
        expectPatchTest(splines, faces);
    }
    expectPatchTest(wholePlate(1, 1), wholePlate(60, 100));
    expectPatchTest(wholePlate(60, 100), wholePlate(1, 1));
    expectPatchTest(verticalMesh(2), verticalSpline(3, 200));
    expectPatchTest(verticalMesh(200), verticalSpline(3, 2));
}

TEST(Extremes, clouds_of_a_hundred_times_other_spacing) {
    const Points coarse = mesh(3, 3).coordinates(), fine = mesh(300, 30).coordinates();
    for (const auto& [from, to] : {std::pair(coarse, fine), {fine, coarse}}) {
        RbfOptions options;
        options.gapLimit.relative = 0.5; // a fine point is far from all coarse ones
        const RbfMapping mapping(from, to, options);
        EXPECT_LT((mapping.apply(linearField(from)) - linearField(to)).cwiseAbs().maxCoeff(),
                  1e-10); // the kernels' condition
        EXPECT_LT(mapping.report().momentError, 1e-10);
    }
}

TEST(Extremes, anisotropy_of_a_thousand) {
    const SurfaceMesh faces = flatMesh(9, 7, FaceKind::quadrilaterals, ValuesAt::vertices, 1, 1e-3);
    expectPatchTest(faces, stripe(5, 4));
    expectPatchTest(stripe(5, 4), faces);
    expectPatchTest(stripe(5, 4), stripe(3, 7));
    const Points to =
        flatMesh(6, 5, FaceKind::triangles, ValuesAt::vertices, 1, 1e-3, 3).coordinates();
    const NearestElementMapping nearest(stripe(5, 4), to);
    EXPECT_LT((nearest.apply(linearField(stripe(5, 4).coordinates())) - linearField(to)).norm(),
              1e-12);
    for (const RbfSolution solution : {RbfSolution::global, RbfSolution::partitionOfUnity}) {
        RbfOptions options;
        options.solution = solution;
        const RbfMapping mapping(faces.coordinates(), to, options);
        EXPECT_LT((mapping.apply(linearField(faces.coordinates())) - linearField(to)).norm(),
                  1e-10); // the kernels' condition
    }
}

TEST(Extremes, scale_place_and_direction_do_not_matter_for_mortar_onto_and_from_patches) {
    expectPlaceDoesNotMatter([](const Placement& placed) -> Points {
        const SurfaceMesh faces = placed(7, 0);
        return MortarMapping(faces, placed(TrimmedPatch(plate(5, 4))))
            .apply(probeForces(faces.nValues()));
    });
    expectPlaceDoesNotMatter([](const Placement& placed) -> Points {
        // Slivers around the hole have values that rounding moves, but not their field.
        const SurfaceMesh faces = placed(7, 0);
        const MortarMapping mapping(faces, placed(holedPlate()), minimumNorm());
        return mapping.massMatrix() * mapping.apply(probeForces(faces.nValues())) /
               (placed.scale * placed.scale);
    });
    expectPlaceDoesNotMatter([](const Placement& placed) -> Points {
        const SurfaceInterface splines = placed(holedPlate());
        return MortarMapping(splines, placed(7, 0)).apply(probeForces(splines.nValues()));
    });
}

TEST(Extremes, scale_place_and_direction_do_not_matter_for_mortar_between_patches) {
    expectPlaceDoesNotMatter([](const Placement& placed) -> Points {
        const SurfaceInterface from = placed(TrimmedPatch(bentParameters(4, 4)));
        return MortarMapping(from, placed(TrimmedPatch(plate(5, 3))))
            .apply(probeForces(from.nValues()));
    });
}

TEST(Extremes, scale_place_and_direction_do_not_matter_for_trimmed_edges) {
    const NurbsSurface surface = refine(geometry::rectangle(Point(-0.6, 0, 0), 2, 1), 2, 2, 2, 2);
    for (const SingularMass singular : {SingularMass::minimumNorm, SingularMass::gradientTerm}) {
        expectPlaceDoesNotMatter([&](const Placement& placed) -> Points {
            const NurbsSurface moved = surface.withControlPoints(placed(surface.controlPoints()));
            std::vector<int> numbers(moved.nControlPoints());
            std::iota(numbers.begin(), numbers.end(), 0);
            std::vector<std::unique_ptr<InterfaceCurve>> curves;
            curves.push_back(interfaceCurve(
                geometry::CurveOnSurface(geometry::line(Point(0.3, 0, 0), Point(0.3, 1, 0)), moved),
                numbers));
            const CurveInterface to(std::move(curves), moved.controlPoints());
            std::vector<std::array<int, 2>> elements;
            for (int i = 0; i < 7; ++i) {
                elements.push_back({i, i + 1});
            }
            const CurveInterface from = lineMesh(placed(verticalMesh(7).coordinates()), elements);
            MortarOptions options;
            options.singular = singular;
            return MortarMapping(from, to, options).apply(probeForces(from.nValues()));
        });
    }
}

TEST(Extremes, scale_place_and_direction_do_not_matter_for_nearest_element_of_patches) {
    const Points to = mesh(9, 6, 2).vertices().rowwise() + Eigen::RowVector3d(0.01, 0, 0.002);
    expectPlaceDoesNotMatter([&](const Placement& placed) -> Points {
        const SurfaceInterface splines = placed(holedPlate());
        return NearestElementMapping(splines, placed(to), {0.2})
            .apply(probeForces(splines.nValues()));
    });
}

TEST(Extremes, scale_place_and_direction_do_not_matter_for_the_partition_of_unity) {
    expectPlaceDoesNotMatter([](const Placement& placed) -> Points {
        RbfOptions options;
        options.solution = RbfSolution::partitionOfUnity;
        const Points from = placed(mesh(20, 20).vertices());
        return RbfMapping(from, placed(mesh(17, 13, 2).vertices()), options)
            .apply(probeForces(from.rows()).array().sin());
    });
}

TEST(Extremes, gaps_and_overlaps_of_half_an_element_keep_constants_forces_and_the_planes_field) {
    MortarOptions options;
    options.gapLimit.relative = 0.1;
    const SurfaceMesh flat = mesh(8, 8);
    const double half = 0.5 * 2 / 8;
    for (const double gap : {-half, -1e-3, 1e-3, half}) {
        const Points raised = flat.vertices().rowwise() + Eigen::RowVector3d(0, 0, gap);
        SurfaceMesh::Faces faces;
        for (int face = 0; face < flat.nFaces(); ++face) {
            const std::array<int, 3> corners = flat.cornerNumbers(face);
            faces.push_back({corners[0], corners[1], corners[2]});
        }
        const SurfaceMesh above(raised, faces, ValuesAt::vertices);
        const auto check = [&](const MortarMapping& mapping, const Discretisation& from,
                               const Discretisation& to) {
            EXPECT_LT(mapping.report().rowSumError, 1e-12);
            EXPECT_LT(mapping.report().forceSumError, 1e-12);
            EXPECT_NEAR(mapping.report().coverage, 1, 1e-9);
            EXPECT_NEAR(mapping.report().largestGap, std::abs(gap), 1e-12);
            const Eigen::VectorXd inPlane =
                from.coordinates().col(0) - 2 * from.coordinates().col(1);
            const Eigen::VectorXd expected = to.coordinates().col(0) - 2 * to.coordinates().col(1);
            EXPECT_LT((mapping.apply(inPlane) - expected).cwiseAbs().maxCoeff(), 1e-11);
        };
        const SurfaceInterface splines = wholePlate(5, 4);
        check(MortarMapping(above, splines, options), above, splines);
        check(MortarMapping(splines, above, options), splines, above);
        check(MortarMapping(above, flat, options), above, flat);
    }
}

TEST(Extremes, a_trim_line_on_a_knot_line_and_next_to_it) {
    const SurfaceMesh faces = mesh(9, 7);
    for (const double beside : {0.0, 1e-12, -1e-12, 1e-8, -1e-8, 1e-4, -1e-4}) {
        const double trim = 0.5 + beside / 4; // of one of 4 elements
        const SurfaceInterface splines =
            onePatch(TrimmedPatch(plate(4, 4), {TrimmingLoop::around({{0, 0}, {trim, 1}})}));
        expectPatchTest(faces, splines, minimumNorm());
        expectPatchTest(splines, faces, minimumNorm());
        expectPatchTest(wholePlate(5, 3), splines, minimumNorm());
        EXPECT_NEAR(MortarMapping(faces, splines, minimumNorm()).massMatrix().sum(), 2 * trim,
                    1e-10);
    }
}

TEST(Extremes, a_hole_smaller_than_an_element) {
    const double radius = 0.02, pi = std::acos(-1.0);
    const TrimmedPatch patch(
        plate(5, 4),
        {TrimmingLoop::around({{0, 0}, {1, 1}}),
         TrimmingLoop(LoopKind::inner,
                      {reversed(geometry::arc(Point(0.5, 0.62, 0), radius, 0, 2 * pi))})});
    const SurfaceMesh faces = mesh(9, 7);
    expectPatchTest(faces, onePatch(patch));
    expectPatchTest(onePatch(patch), faces);
    expectPatchTest(onePatch(patch), wholePlate(4, 3));
    const double area = 2 - 2 * pi * radius * radius;
    // Chords of 1e-4 of an element around the hole.
    EXPECT_NEAR(MortarMapping(faces, onePatch(patch)).massMatrix().sum(), area, 1e-5);
}

TEST(Extremes, inverted_faces_map_as_the_others) {
    const SurfaceMesh plain = flatMesh(6, 6, FaceKind::quadrilaterals, ValuesAt::vertices);
    const SurfaceMesh inverted(plain.vertices(), someInverted(6), ValuesAt::vertices);
    const SurfaceInterface splines = wholePlate(4, 3);
    const Points values = probeForces(plain.nValues());
    const Points reference = MortarMapping(plain, splines).apply(values);
    EXPECT_LT((MortarMapping(inverted, splines).apply(values) - reference).norm(), 1e-11);
    expectPatchTest(splines, inverted);
    expectPatchTest(mesh(5, 4, 2), inverted);
    expectPatchTest(inverted, mesh(5, 4, 2));
}

TEST(Extremes, vertices_that_faces_do_not_share_map_as_merged_ones) {
    // Every face with vertices of its own: coincident points all over.
    const SurfaceMesh merged = mesh(6, 5);
    Points vertices(3 * merged.nFaces(), 3);
    SurfaceMesh::Faces faces;
    for (int face = 0; face < merged.nFaces(); ++face) {
        for (int i = 0; i < 3; ++i) {
            vertices.row(3 * face + i) = merged.triangle(face).corner(i);
        }
        faces.push_back({3 * face, 3 * face + 1, 3 * face + 2});
    }
    const SurfaceMesh apart(vertices, faces, ValuesAt::vertices);
    expectPatchTest(apart, wholePlate(4, 3));
    expectPatchTest(wholePlate(4, 3), apart);
    expectPatchTest(apart, mesh(4, 4, 1));
    const NearestElementMapping nearest(PointCloud(vertices), merged.coordinates());
    EXPECT_TRUE(nearest.apply(linearField(vertices)).allFinite());
    EXPECT_EQ(nearest.report().rowSumError, 0);
    expectInputError([&] { RbfMapping(vertices, merged.coordinates()); }, {"coincides", "merge"});
}

TEST(Extremes, a_line_element_without_length_is_refused) {
    Points vertices(3, 3);
    vertices << 0, 0, 0, 1, 0, 0, 1, 0, 0;
    for (const ValuesAt valuesAt : {ValuesAt::vertices, ValuesAt::faces}) {
        expectInputError(
            [&] {
                lineMesh(vertices, {{0, 1}, {1, 2}}, valuesAt);
            },
            {"element 1", "no length"});
    }
}

} // namespace tokay::mapper
