#include "mapper/MortarMapping.hpp"

#include "geometry/curveParts.hpp"
#include "geometry/expectInputError.hpp"
#include "geometry/primitives.hpp"
#include "geometry/refinement.hpp"
#include "mapper/NearestElementMapping.hpp"
#include "mapper/conservation.hpp"
#include "mappingProperties.hpp"
#include "sampleMeshes.hpp"
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace tokay::mapper {

namespace {

const double pi = std::acos(-1.0);
using geometry::LoopKind;
using geometry::NurbsSurface;
using geometry::TrimmedPatch;
using geometry::TrimmingLoop;

SurfaceInterface onePatch(TrimmedPatch patch) {
    const int n = patch.basis().nControlPoints();
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return SurfaceInterface({{std::move(patch), numbers, "patch"}}, n);
}

/// [0, 2] x [0, 1], biquadratic.
NurbsSurface plate(int nX, int nY) {
    return refine(geometry::rectangle(Point::Zero(), 2, 1), 2, 2, nX, nY);
}

/// The same plate with lines of the parameters that are neither straight nor even.
NurbsSurface bentParameters(int nX, int nY) {
    NurbsSurface surface = refine(geometry::rectangle(Point::Zero(), 2, 1), 2, 2, 2, 2);
    Points points = surface.controlPoints();
    for (int j = 1; j < 3; ++j)
        for (int i = 1; i < 3; ++i)
            points.row(i + 4 * j) += Eigen::RowVector3d(0.2 * j - 0.3, 0.1 * i - 0.2, 0);
    return refine(surface.withControlPoints(points), 2, 2, nX / 2, nY / 2);
}

/// The plate with a round hole.
TrimmedPatch holedPlate() {
    return TrimmedPatch(
        plate(5, 4),
        {TrimmingLoop::around({{0, 0}, {1, 1}}),
         TrimmingLoop(LoopKind::inner,
                      {reversed(geometry::arc(Point(0.45, 0.55, 0), 0.23, 0, 2 * pi))})});
}

/// Two patches that share the control points at x = 1.
SurfaceInterface twoPatches() {
    const NurbsSurface left = refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 2, 3);
    const NurbsSurface right = refine(geometry::rectangle(Point(1, 0, 0), 1, 1), 2, 2, 3, 3);
    const int nLeft = left.nControlPoints(), nU = left.u().nBasis();
    std::vector<int> leftNumbers(nLeft), rightNumbers(right.nControlPoints());
    std::iota(leftNumbers.begin(), leftNumbers.end(), 0);
    int next = nLeft;
    for (int j = 0; j < right.v().nBasis(); ++j)
        for (int i = 0; i < right.u().nBasis(); ++i)
            rightNumbers[i + right.u().nBasis() * j] = i == 0 ? nU - 1 + nU * j : next++;
    return SurfaceInterface(
        {{TrimmedPatch(left), leftNumbers, "left"}, {TrimmedPatch(right), rightNumbers, "right"}},
        next);
}

template <class From, class To>
void expectPatchTest(const From& from, const To& to, MortarOptions options = {}) {
    const MortarMapping mapping(from, to, options);
    const Points expected = linearField(to.coordinates());
    const Points mapped = mapping.apply(linearField(from.coordinates()));
    const auto field = [&](const Points& values) { return (mapping.massMatrix() * values).norm(); };
    EXPECT_LT(field(mapped - expected), 1e-12 * field(expected));
    EXPECT_LT(mapping.report().rowSumError, 1e-12);
    expectForceAndMomentConserved(mapping, mapping.massMatrix() * testForces(to.nValues()),
                                  from.coordinates(), to.coordinates());
    expectTransposesEqual(mapping, from.nValues(), to.nValues());
}

} // namespace

TEST(PatchMortar, passesThePatchTestBetweenMeshesAndAPatchBothWays) {
    for (const FaceKind kind :
         {FaceKind::triangles, FaceKind::quadrilaterals, FaceKind::polygons}) {
        const SurfaceMesh mesh = flatMesh(9, 7, kind, ValuesAt::vertices);
        expectPatchTest(mesh, onePatch(TrimmedPatch(plate(5, 4))));
        expectPatchTest(onePatch(TrimmedPatch(plate(5, 4))), mesh);
    }
}

TEST(PatchMortar, coversAFlatInterfaceCompletely) {
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::quadrilaterals, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(plate(5, 4)));
    EXPECT_NEAR(MortarMapping(mesh, splines).report().coverage, 1, 1e-12);
    EXPECT_NEAR(MortarMapping(splines, mesh).report().coverage, 1, 1e-12);
    EXPECT_EQ(MortarMapping(splines, mesh).report().nUncovered, 0);
    // The integral of all functions of the patch is its area.
    const MortarMapping mapping(mesh, splines);
    EXPECT_NEAR(mapping.massMatrix().sum(), 2, 1e-13);
    EXPECT_NEAR(mapping.crossMatrix().sum(), 2, 1e-13);
}

TEST(PatchMortar, passesThePatchTestWithParametersThatAreNeitherStraightNorEven) {
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(bentParameters(6, 4)));
    expectPatchTest(mesh, splines);
    expectPatchTest(splines, mesh);
}

TEST(PatchMortar, passesThePatchTestOnATrimmedPatch) {
    MortarOptions options;
    options.singular = SingularMass::minimumNorm;
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices);
    expectPatchTest(mesh, onePatch(holedPlate()), options);
    expectPatchTest(onePatch(holedPlate()), mesh, options);
    const MortarMapping mapping(mesh, onePatch(holedPlate()), options);
    // In space the hole is an ellipse of semi-axes 2 * 0.23 and 0.23.
    EXPECT_NEAR(mapping.massMatrix().sum(), 2 - pi * 2 * 0.23 * 0.23, 1e-4);
}

TEST(PatchMortar, passesThePatchTestAcrossPatches) {
    const SurfaceMesh mesh = flatMesh(8, 5, FaceKind::quadrilaterals, ValuesAt::vertices);
    expectPatchTest(mesh, twoPatches());
    expectPatchTest(twoPatches(), mesh);
    EXPECT_NEAR(MortarMapping(twoPatches(), mesh).report().coverage, 1, 1e-12);
}

TEST(PatchMortar, facesPartlyOutsideAreCutAtTheEdgeOfThePatch) {
    // The mesh reaches from x = 0 to 2, the patch only to 1.
    const NurbsSurface half = refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 3, 3);
    const SurfaceMesh mesh = flatMesh(9, 7, FaceKind::triangles, ValuesAt::vertices);
    const SurfaceInterface splines = onePatch(TrimmedPatch(half));
    expectPatchTest(mesh, splines);
    EXPECT_NEAR(MortarMapping(mesh, splines).massMatrix().sum(), 1, 1e-13);
    const MortarMapping back(splines, mesh);
    EXPECT_NEAR(back.massMatrix().sum(), 1, 1e-13);
    EXPECT_NEAR(back.report().coverage, 0.5, 1e-12);
    EXPECT_GT(back.report().nUncovered, 0);
}

TEST(PatchMortar, facesOverTheSeamOfACylinderAreMappedOnce) {
    // Facets turned against the seam, so that a row of them lies over it.
    const NurbsSurface cylinder =
        refine(geometry::cylinderPatch(Point::Zero(), 1, 1, 0, 2 * pi), 2, 2, 2, 2);
    for (const int nAround : {24, 48}) {
        Points vertices(2 * nAround, 3);
        SurfaceMesh::Faces faces;
        for (int i = 0; i < nAround; ++i) {
            const double angle = 2 * pi * (i + 0.4) / nAround;
            vertices.row(i) << std::cos(angle), std::sin(angle), 0;
            vertices.row(nAround + i) << std::cos(angle), std::sin(angle), 1;
            const int next = (i + 1) % nAround;
            faces.push_back({i, next, nAround + next, nAround + i});
        }
        const SurfaceMesh mesh(vertices, faces, ValuesAt::vertices);
        const MortarMapping mapping(mesh, onePatch(TrimmedPatch(cylinder)));
        // Pieces are of polygons in parameter space that together fill it: only
        // the rule of degree 4 on the rational Jacobian is left.
        EXPECT_NEAR(mapping.massMatrix().sum(), 2 * pi, 1e-6);
        EXPECT_NEAR(mapping.report().coverage, 1, 1e-6);
        EXPECT_LT(mapping.report().rowSumError, 1e-12);
        EXPECT_LT(mapping.report().forceSumError, 1e-12);
    }
}

TEST(PatchMortar, theDualBasisIsRefused) {
    MortarOptions options;
    options.basis = MortarBasis::dual;
    const SurfaceMesh mesh = flatMesh(3, 3, FaceKind::triangles, ValuesAt::vertices);
    expectInputError([&] { MortarMapping(mesh, onePatch(TrimmedPatch(plate(2, 2))), options); },
                     {"dual basis"});
}

TEST(SurfaceInterface, nearestElementEvaluatesTheSplinesExactly) {
    for (const SurfaceInterface& splines :
         {onePatch(TrimmedPatch(bentParameters(6, 4))), twoPatches()}) {
        const Points to = flatMesh(8, 6, FaceKind::triangles, ValuesAt::vertices).coordinates();
        const NearestElementMapping mapping(splines, to);
        EXPECT_LT((mapping.apply(linearField(splines.coordinates())) - linearField(to)).norm(),
                  1e-12);
        expectForceAndMomentConserved(mapping, testForces(to.rows()), splines.coordinates(), to);
    }
}

TEST(SurfaceInterface, aPointOverAHoleGetsTheRimOfTheHole) {
    const SurfaceInterface splines = onePatch(holedPlate());
    // Along y the rim is an arc of radius 0.23 around (0.9, 0.55).
    const Location rim = splines.locate(Point(0.9, 0.60, 0));
    EXPECT_TRUE(rim.converged);
    EXPECT_NEAR(rim.gap, 0.18, 1e-12);
    EXPECT_NEAR(splines.locate(Point(0.9, 0.9, 0)).gap, 0, 1e-14);
}

TEST(SurfaceInterface, refusesPatchesThatDoNotFitTheStructure) {
    const TrimmedPatch patch(geometry::rectangle(Point::Zero(), 1, 1));
    expectInputError([&] { SurfaceInterface({}, 4); }, {"no patch"});
    expectInputError(
        [&] {
            SurfaceInterface({{patch, {0, 1, 2}, "roof"}}, 4);
        },
        {"roof", "3", "4"});
    expectInputError(
        [&] {
            SurfaceInterface({{patch, {0, 1, 2, 7}, "roof"}}, 4);
        },
        {"roof", "control point 7", "has 4"});
}

} // namespace tokay::mapper
