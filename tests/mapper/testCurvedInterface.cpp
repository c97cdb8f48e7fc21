// SPDX-License-Identifier: GPL-3.0-or-later
// What a transfer loses between a curved structure and the facets of a fluid
// mesh: the two sides differ by a sagitta, so no map keeps everything.
#include "mapper/mortar/MortarMapping.hpp"
#include "sampleInterfaces.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace tokay::mapper {

namespace {

/// Quarter of the unit circle in n straight faces, a value on each.
CurveInterface facets(int n) {
    Points vertices(n + 1, 3);
    std::vector<std::array<int, 2>> elements;
    for (int i = 0; i <= n; ++i) {
        const double angle = std::acos(0.0) * i / n;
        vertices.row(i) << std::cos(angle), std::sin(angle), 0;
        if (i > 0) {
            elements.push_back({i - 1, i});
        }
    }
    return lineMesh(vertices, elements, ValuesAt::faces);
}

/// Lengths of the faces.
Eigen::VectorXd lengths(int n) {
    return Eigen::VectorXd::Constant(n, 2 * std::sin(std::acos(0.0) / n / 2));
}

/// Unit tractions along the faces.
Points tangents(const Points& centres) {
    Points t(centres.rows(), 3);
    for (Eigen::Index i = 0; i < t.rows(); ++i) {
        t.row(i) = Point(0, 0, 1).cross(Point(centres.row(i))).normalized();
    }
    return t;
}

double moment(const Points& positions, const Points& forces) {
    double sum = 0;
    for (Eigen::Index i = 0; i < positions.rows(); ++i) {
        sum += Point(positions.row(i)).cross(Point(forces.row(i)))[2];
    }
    return sum;
}

struct Loss {
    double force, moment; ///< relative
    double traction;      ///< largest error of a uniform pressure
};

/// Forces of the faces to the control points, by the transpose.
Loss ofConservative(int n) {
    const SplineInterface circle = quarterCircle(2, 6);
    const CurveInterface faces = facets(n);
    const MortarMapping mapping(circle, faces);
    const Points forces = lengths(n).asDiagonal() * tangents(faces.coordinates());
    const Points mapped = mapping.applyTransposed(forces);
    const double total = lengths(n).sum();
    // The traction whose consistent forces on the circle these are.
    const Eigen::MatrixXd mass = MortarMapping(faces, circle).massMatrix();
    const Eigen::VectorXd pressure = mass.ldlt().solve(mapping.applyTransposed(lengths(n)));
    return {(forces.colwise().sum() - mapped.colwise().sum()).norm() / total,
            std::abs(moment(faces.coordinates(), forces) - moment(circle.coordinates(), mapped)) /
                total,
            (pressure.array() - 1).abs().maxCoeff()};
}

/// Tractions of the faces to the circle, then integrated there.
Loss ofConsistent(int n) {
    const SplineInterface circle = quarterCircle(2, 6);
    const CurveInterface faces = facets(n);
    const MortarMapping mapping(faces, circle);
    const Eigen::VectorXd pressure = mapping.apply(Eigen::VectorXd::Ones(n));
    const Points forces = lengths(n).asDiagonal() * tangents(faces.coordinates());
    const Points mapped =
        mapping.massMatrix() * Points(mapping.apply(tangents(faces.coordinates())));
    const double total = lengths(n).sum();
    return {std::abs((mapping.massMatrix() * pressure).sum() - total) / total,
            std::abs(moment(faces.coordinates(), forces) - moment(circle.coordinates(), mapped)) /
                total,
            (pressure.array() - 1).abs().maxCoeff()};
}

double order(double coarse, double fine) {
    return std::log2(coarse / fine);
}

} // namespace

TEST(CurvedInterface,
     the_conservative_map_keeps_the_force_and_loses_moment_and_uniformity_by_sagittas) {
    const Loss coarse = ofConservative(24), fine = ofConservative(48);
    EXPECT_LT(fine.force, 1e-13);
    // Forces move from the chord onto the circle: by a mean of 2/3 of the sagitta h^2 / 8.
    const double h = std::acos(0.0) / 48;
    EXPECT_NEAR(fine.moment, h * h / 12, 0.1 * h * h / 12);
    EXPECT_NEAR(order(coarse.moment, fine.moment), 2, 0.1);
    EXPECT_GT(fine.traction, 1e-6);
    EXPECT_GT(order(coarse.traction, fine.traction), 1.7);
}

TEST(CurvedInterface,
     the_consistent_map_keeps_uniform_traction_and_loses_force_by_the_missing_area) {
    const Loss coarse = ofConsistent(24), fine = ofConsistent(48);
    EXPECT_LT(fine.traction, 1e-12);
    // The arc over its chord: h^2 / 24.
    const double h = std::acos(0.0) / 48;
    EXPECT_NEAR(fine.force, h * h / 24, 0.01 * h * h / 24);
    EXPECT_NEAR(order(coarse.force, fine.force), 2, 0.05);
    EXPECT_NEAR(order(coarse.moment, fine.moment), 2, 0.3);
}

} // namespace tokay::mapper
