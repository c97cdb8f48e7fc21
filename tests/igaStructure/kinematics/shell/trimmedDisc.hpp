// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/primitives/primitives.hpp"
#include "igaStructure/kinematics/shell/Shell.hpp"

#include <cmath>
#include <vector>

namespace tokay::structure {

/// A problem with a known solution: a disc of radius 1, cut out of square patches,
/// clamped weakly on its rim. With s = 1 - x^2 - y^2 it bends by w = s^2 exp(k x) and
/// strains in its plane by u = s sin(k x), v = 0.
struct TrimmedDisc {
    static constexpr double k = 1.5;
    static constexpr double youngsModulus = 1e6;
    static constexpr double poissonsRatio = 0.3;
    double thickness = 0.05;

    double membraneStiffness() const {
        return youngsModulus * thickness / (1 - poissonsRatio * poissonsRatio);
    }

    static Eigen::Vector3d displacement(double x, double y) {
        const double s = 1 - x * x - y * y;
        return {s * std::sin(k * x), 0, s * s * std::exp(k * x)};
    }
    /// (u,x  u,y)
    static Eigen::Vector2d gradient(double x, double y) {
        const double s = 1 - x * x - y * y;
        return {s * k * std::cos(k * x) - 2 * x * std::sin(k * x), -2 * y * std::sin(k * x)};
    }
    /// (w,xx  w,xy  w,yy)
    static Eigen::Vector3d bending(double x, double y) {
        const double s = 1 - x * x - y * y;
        return std::exp(k * x) * Eigen::Vector3d(8 * x * x - 4 * s - 8 * k * x * s + k * k * s * s,
                                                 8 * x * y - 4 * k * y * s, 8 * y * y - 4 * s);
    }
    /// Force per area that the solution needs: -div n in the plane, D times the
    /// biharmonic of w across it.
    Eigen::Vector3d traction(double x, double y) const {
        const double r2 = x * x + y * y;
        const double s = 1 - r2;
        const double C = membraneStiffness();
        const double D = C * thickness * thickness / 12;
        const double g = std::sin(k * x), g1 = k * std::cos(k * x), g2 = -k * k * g;
        const double once = 8 * r2 - 8 * s - 8 * k * x * s + k * k * s * s;
        const double laplacian = 64 + 64 * k * x + k * k * (8 * r2 - 8 * s);
        const double slope = 32 * x - 8 * k * (s - 2 * x * x) - 4 * k * k * x * s;
        return {-C * (s * g2 - 4 * x * g1 - 2 * g - (1 - poissonsRatio) * g),
                C * (1 + poissonsRatio) * y * g1,
                D * std::exp(k * x) * (laplacian + 2 * k * slope + k * k * once)};
    }
};

/// A part of the disc between two angles and their chord, or all of it.
inline geometry::BrepFace discFace(const char* name, double lower, double size, double from,
                                   double to, int degree, int n) {
    const auto parameter = [&](double x) { return (x - lower) / size; };
    const geometry::Point centre(parameter(0), parameter(0), 0);
    std::vector<geometry::NurbsCurve> curves = {geometry::arc(centre, 1 / size, from, to)};
    if (to - from < 2 * M_PI - 1e-6) {
        const auto at = [&](double angle) -> geometry::Point {
            return centre + geometry::Point(std::cos(angle), std::sin(angle), 0) / size;
        };
        curves.push_back(geometry::line(at(to), at(from)));
    }
    const geometry::TrimmedPatch patch(
        geometry::rectangle({lower, lower, 0}, size, size),
        {geometry::TrimmingLoop(geometry::LoopKind::outer, std::move(curves))}, name);
    return {patch.refined(degree, degree, n, n)};
}

/// @param nParts  1, or 2 whose meshes do not match and that meet along a slanted chord
inline ShellDescription discShell(const TrimmedDisc& disc, int degree, int n, int nParts) {
    constexpr double first = -70 * M_PI / 180, second = 100 * M_PI / 180;
    std::vector<geometry::BrepFace> faces;
    std::vector<geometry::BrepEdge> edges;
    if (nParts == 1) {
        faces.push_back(discFace("disc", -1.13, 2.3, 0, 2 * M_PI, degree, n));
    } else {
        faces.push_back(discFace("right", -1.13, 2.3, first, second, degree, n));
        faces.push_back(
            discFace("left", -1.21, 2.37, second, first + 2 * M_PI, degree, n + n / 3 + 1));
        edges.push_back({"chord", {{0, 1}, {1, 1, false}}});
    }
    ShellDescription shell{geometry::BrepModel(faces, edges),
                           std::vector<double>(nParts, disc.thickness),
                           {TrimmedDisc::youngsModulus, TrimmedDisc::poissonsRatio, 1}};
    shell.strains = Strains::linear;
    for (int face = 0; face < nParts; ++face) {
        shell.edgeSupports.push_back({{{face, 0}}, {true, true, true}, true});
        shell.loads.tractions.push_back(
            {face,
             {[disc](const geometry::Point& x, double) { return disc.traction(x[0], x[1]); },
              false}});
    }
    return shell;
}

/// Norms over the disc, relative to the solution's: of w, of its second derivatives,
/// of u, of its gradient.
struct DiscError {
    double deflection, bending, displacement, strain;
};

inline DiscError discError(const Shell& shell, const Eigen::VectorXd& d) {
    Eigen::Array4d error = Eigen::Array4d::Zero(), size = Eigen::Array4d::Zero();
    ShellElement element;
    ShellElement::Coefficients local;
    const Eigen::Vector3d counts(1, 2, 1);
    for (const auto& patch : shell.patches()) {
        for (int number = 0; number < patch->patch().nElements(); ++number) {
            element.moveTo(*patch, number % patch->u().nSpans(), number / patch->u().nSpans());
            element.gather(d, local);
            for (int point = 0; point < element.nPoints(); ++point) {
                element.moveToPoint(point);
                const Eigen::Vector3d x = element.position();
                const double a = element.reference().derivatives.col(0).norm();
                const SurfaceDerivatives change = element.functions().derivatives(local);
                const Eigen::Vector3d u = element.functions().value(local);
                const Eigen::Vector3d exact = TrimmedDisc::displacement(x[0], x[1]);
                const Eigen::Vector2d slope = TrimmedDisc::gradient(x[0], x[1]);
                const Eigen::Vector3d bent = TrimmedDisc::bending(x[0], x[1]);
                const Eigen::Vector2d du(change(0, 0) / a, change(0, 1) / a);
                const Eigen::Vector3d ddw =
                    Eigen::Vector3d(change(2, 2), change(2, 3), change(2, 4)) / (a * a);
                const auto square = [&](const Eigen::Vector3d& v) {
                    return v.cwiseAbs2().dot(counts);
                };
                error += element.area() * Eigen::Array4d(std::pow(u[2] - exact[2], 2),
                                                         square(ddw - bent),
                                                         (u - exact).head<2>().squaredNorm(),
                                                         (du - slope).squaredNorm());
                size += element.area() * Eigen::Array4d(exact[2] * exact[2], square(bent),
                                                        exact.head<2>().squaredNorm(),
                                                        slope.squaredNorm());
            }
        }
    }
    const Eigen::Array4d relative = (error / size).sqrt();
    return {relative[0], relative[1], relative[2], relative[3]};
}

} // namespace tokay::structure
