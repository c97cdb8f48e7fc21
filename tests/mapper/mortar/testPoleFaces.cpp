// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/mappingProperties.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/samplePatches.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace tokay::mapper {

namespace {

const double pi = std::acos(-1.0);

/// Unit sphere as a cube blown up, n x n faces of equal angles on each side,
/// then turned: unturned, each pole is the centre of a face if n is odd.
SurfaceMesh cubedSphere(int n, const Eigen::Matrix3d& turn) {
    std::map<std::array<int, 3>, int> numbers;
    std::vector<Point> points;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [known, isNew] = numbers.insert({at, static_cast<int>(points.size())});
        if (isNew) {
            Point x;
            for (int axis = 0; axis < 3; ++axis) {
                x[axis] = std::tan(pi / 4 * at[axis] / n);
            }
            points.push_back(turn * x.normalized());
        }
        return known->second;
    };
    SurfaceMesh::Faces faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-n, n}) {
            for (int j = -n; j < n; j += 2) {
                for (int i = -n; i < n; i += 2) {
                    std::vector<int> face;
                    for (const auto& [di, dj] : {std::pair(0, 0), {2, 0}, {2, 2}, {0, 2}}) {
                        std::array<int, 3> at;
                        at[axis] = side;
                        at[(axis + 1) % 3] = i + di;
                        at[(axis + 2) % 3] = j + dj;
                        face.push_back(vertex(at));
                    }
                    if (side < 0) {
                        std::swap(face[1], face[3]);
                    }
                    faces.push_back(face);
                }
            }
        }
    }
    Points vertices(points.size(), 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
        vertices.row(i) = points[i];
    }
    return SurfaceMesh(vertices, faces, ValuesAt::vertices);
}

SurfaceInterface sphere() {
    return onePatch(geometry::TrimmedPatch(refine(geometry::sphere(Point::Zero(), 1), 2, 2, 2, 2)));
}

/// The sphere with its directions exchanged: poles along xi, closed along eta. Its normal
/// points inwards.
SurfaceInterface exchangedSphere() {
    const geometry::NurbsSurface sphere = refine(geometry::sphere(Point::Zero(), 1), 2, 2, 2, 2);
    const int nU = sphere.u().nBasis(), nV = sphere.v().nBasis();
    Points controlPoints(nU * nV, 3);
    Eigen::VectorXd weights(nU * nV);
    for (int j = 0; j < nV; ++j) {
        for (int i = 0; i < nU; ++i) {
            controlPoints.row(j + nV * i) = sphere.controlPoints().row(i + nU * j);
            weights[j + nV * i] = sphere.weights()[i + nU * j];
        }
    }
    return onePatch(geometry::TrimmedPatch(
        geometry::NurbsSurface(sphere.v(), sphere.u(), controlPoints, weights)));
}

Eigen::Matrix3d turned(double angle, const Point& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// Largest error of the mapped linear field on the patch, at heights near a pole.
double errorNear(double eta, const SurfaceInterface& splines, const Points& mapped) {
    double largest = 0;
    for (int i = 0; i < 40; ++i) {
        const double xi = (i + 0.3) / 40;
        const Functions at = splines.functions(0, xi, eta);
        Points exact(1, 3);
        exact.row(0) = splines.piece(0).patch.basis().point(xi, eta);
        const Eigen::RowVector3d value = at.weights.transpose() * mapped(at.values, Eigen::all);
        largest = std::max(largest, (value - linearField(exact)).norm());
    }
    return largest;
}

} // namespace

TEST(PoleFaces, a_pole_inside_on_a_side_or_at_a_corner_of_a_face_is_covered_once) {
    const double halfFace = pi / 4 / 5; // of 5 faces a quarter turn
    const SurfaceInterface splines = sphere();
    for (const Eigen::Matrix3d& turn :
         {turned(0, Point::UnitX()), turned(0.03, Point(1, 0.3, 0)), turned(0.1, Point(-0.4, 1, 0)),
          turned(halfFace, Point::UnitX()), turned(0.9, Point(0.3, -0.7, 0.6))}) {
        const SurfaceMesh mesh = cubedSphere(5, turn);
        const MortarMapping mapping(mesh, splines);
        // Pieces fill the parameters; the rest is the rule's error on the rational Jacobian.
        EXPECT_NEAR(mapping.massMatrix().sum(), 4 * pi, 1e-4);
        EXPECT_NEAR(mapping.report().coverage, 1, 1e-5);
        EXPECT_LT(mapping.report().rowSumError, 1e-12);
        EXPECT_LT(mapping.report().forceSumError, 1e-12);
        expectTransposesEqual(mapping, mesh.nValues(), splines.nValues());
        const MortarMapping back(splines, mesh);
        EXPECT_NEAR(back.massMatrix().sum(), 4 * pi, 1e-4);
        EXPECT_EQ(back.report().nUncovered, 0);
        EXPECT_LT(back.report().rowSumError, 1e-12);
    }
}

TEST(PoleFaces, the_field_around_a_pole_inside_a_face_is_as_good_as_elsewhere) {
    const SurfaceInterface splines = sphere();
    const SurfaceMesh mesh = cubedSphere(15, turned(0.03, Point(1, 0.3, 0)));
    const Points mapped = MortarMapping(mesh, splines).apply(linearField(mesh.coordinates()));
    const double elsewhere = errorNear(0.5, splines, mapped);
    // Faces of 6 degrees: sagitta 1.4e-3 times the field's slope of 2.5.
    EXPECT_LT(elsewhere, 5e-3);
    for (const double eta : {0.01, 0.99, 0.05}) {
        EXPECT_LT(errorNear(eta, splines, mapped), 3 * elsewhere) << eta;
    }
}

TEST(PoleFaces, directions_of_the_parameters_do_not_matter) {
    const SurfaceInterface splines = exchangedSphere();
    EXPECT_EQ(splines.isClosed(0), (std::array<bool, 2>{false, true}));
    for (const double angle : {0.0, 0.03, 0.9}) {
        const SurfaceMesh mesh = cubedSphere(5, turned(angle, Point(1, 0.3, 0)));
        const MortarMapping mapping(mesh, splines);
        // Pieces fill the parameters; the rest is the rule's error on the rational Jacobian.
        EXPECT_NEAR(mapping.massMatrix().sum(), 4 * pi, 1e-6);
        EXPECT_NEAR(mapping.report().coverage, 1, 1e-5);
        EXPECT_LT(mapping.report().rowSumError, 1e-12);
        const MortarMapping back(splines, mesh);
        EXPECT_NEAR(back.massMatrix().sum(), 4 * pi, 1e-6);
        EXPECT_EQ(back.report().nUncovered, 0);
    }
}

} // namespace tokay::mapper
