// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature/gaussLegendre.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "sampleInterfaces.hpp"
#include "sampleMeshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tokay::mapper {

namespace {

double smooth(const Point& x) {
    return std::sin(5 * x[1] + 0.3) * std::cos(2 * x[0]);
}

Eigen::VectorXd smooth(const Points& x) {
    Eigen::VectorXd values(x.rows());
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        values[i] = smooth(Point(x.row(i)));
    }
    return values;
}

double errorAtPoints(const Eigen::VectorXd& mapped, const Points& x) {
    return (mapped - smooth(x)).norm() / std::sqrt(static_cast<double>(x.rows()));
}

/// L2 error of the field that the values stand for.
double fieldError(const CurveInterface& interface, const Eigen::VectorXd& values) {
    const geometry::QuadratureRule& rule = geometry::gaussLegendre(8);
    double sum = 0;
    for (int i = 0; i < interface.nCurves(); ++i) {
        const InterfaceCurve& curve = interface.curve(i);
        const std::vector<double>& ends = curve.breakpoints();
        for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
            for (int k = 0; k < 8; ++k) {
                const double xi = ends[e] + (ends[e + 1] - ends[e]) * rule.points[k];
                const Points d = curve.derivatives(xi, 1);
                const Functions f = curve.functions(xi);
                const double error = f.weights.dot(values(f.values)) - smooth(Point(d.row(0)));
                sum += rule.weights[k] * (ends[e + 1] - ends[e]) * d.row(1).norm() * error * error;
            }
        }
    }
    return std::sqrt(sum);
}

/// Slope of the error between the two finest of four meshes.
void expectOrder(double expected, const std::function<double(int)>& errorOfMesh) {
    double coarser = 0, order = 0;
    for (const int n : {8, 16, 32, 64}) {
        const double error = errorOfMesh(n);
        order = std::log2(coarser / error);
        coarser = error;
    }
    EXPECT_NEAR(order, expected, 0.25); // meshes are uneven and meet by chance
}

Points flatPoints(int n, int seed) {
    return flatMesh(n, n, FaceKind::triangles, ValuesAt::vertices, 1, 1, seed).coordinates();
}

} // namespace

TEST(ConvergenceOrders, nearest_neighbour_is_of_order_one) {
    const Points to = flatPoints(90, 3);
    expectOrder(1, [&](int n) {
        const PointCloud from(flatPoints(n, 0));
        const Eigen::VectorXd values = smooth(from.coordinates());
        return errorAtPoints(NearestElementMapping(from, to, {0.5}).apply(values), to);
    });
}

TEST(ConvergenceOrders, nearest_element_is_of_order_two) {
    const Points to = flatPoints(90, 3);
    expectOrder(2, [&](int n) {
        const SurfaceMesh from = flatMesh(n, n, FaceKind::quadrilaterals, ValuesAt::vertices, 1, 1);
        return errorAtPoints(NearestElementMapping(from, to).apply(smooth(from.coordinates())), to);
    });
}

TEST(ConvergenceOrders, mortar_between_linear_meshes_is_of_order_two) {
    for (const MortarBasis basis : {MortarBasis::standard, MortarBasis::dual}) {
        MortarOptions options;
        options.basis = basis;
        expectOrder(2, [&](int n) {
            const CurveInterface from = verticalMesh(n), to = verticalMesh(2 * n / 3);
            return fieldError(to,
                              MortarMapping(from, to, options).apply(smooth(from.coordinates())));
        });
        expectOrder(2, [&](int n) {
            const SurfaceMesh from = flatMesh(n, n, FaceKind::triangles, ValuesAt::vertices, 1, 1);
            const SurfaceMesh to =
                flatMesh(2 * n / 3, n, FaceKind::triangles, ValuesAt::vertices, 1, 1, 2);
            const MortarMapping mapping(from, to, options);
            return errorAtPoints(mapping.apply(smooth(from.coordinates())), to.coordinates());
        });
    }
}

TEST(ConvergenceOrders, mortar_onto_splines_is_of_the_degree_plus_one) {
    // The source's own error, 6e-8, stays below what is measured.
    const CurveInterface from = verticalMesh(6000);
    const Eigen::VectorXd values = smooth(from.coordinates());
    for (int degree = 1; degree <= 3; ++degree) {
        expectOrder(degree + 1, [&](int n) {
            const SplineInterface to = verticalSpline(degree, n / 4);
            return fieldError(to, MortarMapping(from, to).apply(values));
        });
    }
}

} // namespace tokay::mapper
