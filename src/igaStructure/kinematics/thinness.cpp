// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/thinness.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tokay::structure {

namespace {

std::vector<double> middles(const geometry::KnotVector& knots) {
    const std::vector<double>& breakpoints = knots.breakpoints();
    std::vector<double> found;
    for (std::size_t k = 0; k + 1 < breakpoints.size(); ++k) {
        found.push_back(0.5 * (breakpoints[k] + breakpoints[k + 1]));
    }
    return found;
}

// Rows of the derivatives: 0, then u, v, then uu, uv, vv.
double largestPrincipalCurvature(const geometry::Points& d) {
    const Eigen::Vector3d normal = d.row(1).cross(d.row(2)).normalized();
    const Eigen::Matrix2d metric = d.middleRows(1, 2) * d.middleRows(1, 2).transpose();
    const Eigen::Vector3d second = d.middleRows(3, 3) * normal;
    Eigen::Matrix2d form;
    form << second[0], second[1], second[1], second[2];
    const Eigen::Matrix2d shape = metric.inverse() * form;
    const double mean = 0.5 * shape.trace();
    return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - shape.determinant()));
}

} // namespace

double largestCurvature(const geometry::NurbsCurve& curve) {
    double largest = 0;
    for (double xi : middles(curve.knotVector())) {
        const geometry::Points d = curve.derivatives(xi, 2);
        const Eigen::Vector3d first = d.row(1);
        const Eigen::Vector3d second = d.row(2);
        largest = std::max(largest, first.cross(second).norm() / std::pow(first.norm(), 3));
    }
    return largest;
}

double largestCurvature(const geometry::NurbsSurface& surface) {
    double largest = 0;
    for (double eta : middles(surface.v())) {
        for (double xi : middles(surface.u())) {
            largest = std::max(largest, largestPrincipalCurvature(surface.derivatives(xi, eta, 2)));
        }
    }
    return largest;
}

double bendingOverestimate(double slenderness, int mode) {
    // L^2 times the integral of the mode's slope squared over that of the mode squared, of
    // which rotary inertia takes r^2 = t^2/12 times, shear E/(k G) r^2 times: the change of
    // curvature over the curvature has the same integrals.
    static constexpr std::array<double, 3> slopes = {4.6478, 32.4173, 77.2990};
    constexpr double shear = 2.6 * 6 / 5;
    const double change = slopes.at(mode - 1) * (1 + shear) / (12 * slenderness * slenderness);
    return std::sqrt(1 + change) - 1;
}

std::string tooThinToBend(double slenderness) {
    constexpr double thinnest = 1e4; // gold leaf of a hand's width is 1e6
    return slenderness < thinnest
               ? ""
               : fmt::format("; its bending stiffness is {:.1g} of that against stretching: check "
                             "the unit of the thickness, or leave bending out (membrane, cable)",
                             1 / (12 * slenderness * slenderness));
}

std::string leftOutBending(double thickness, double stiffness, double prestress) {
    if (!(prestress > 0)) {
        return "";
    }
    return fmt::format("; bending stiffness, which it leaves out, would matter within {:.2g} m of "
                       "its supports",
                       thickness * std::sqrt(stiffness / (12 * prestress)));
}

} // namespace tokay::structure
