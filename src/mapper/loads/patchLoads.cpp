// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/interface/SurfaceMesh.hpp"
#include "mapper/intersection/patchIntersection.hpp"
#include "mapper/loads/FaceSizes.hpp"
#include "mapper/loads/LoadPointList.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace tokay::mapper {

using geometry::Barycentric;
using geometry::Triangle;

namespace {

struct WeightedPlace {
    Barycentric at;
    double weight;
};

// Weights times the linear function that makes their sum 1 and their mean the
// centroid; false if that function is not positive at all places.
bool restoreArea(std::vector<WeightedPlace>& places) {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const WeightedPlace& place : places) {
        moments += place.weight * place.at * place.at.transpose();
    }
    const Eigen::LDLT<Eigen::Matrix3d> factors(moments);
    if (factors.info() != Eigen::Success || !(factors.rcond() > 1e-6)) {
        return false;
    }
    const Eigen::Vector3d factor = factors.solve(Barycentric::Constant(1.0 / 3));
    return std::all_of(places.begin(), places.end(), [&](WeightedPlace& place) {
        const double correction = factor.dot(place.at);
        place.weight *= correction;
        return correction > 0;
    });
}

// Smaller side of the knot span that is closest to a point.
double spanSize(const SurfaceInterface& splines, const Point& point) {
    const SurfaceInterface::Projection found = splines.closest(point);
    const geometry::TrimmedPatch& patch = splines.piece(found.piece).patch;
    const double xi = found.onSurface.xi, eta = found.onSurface.eta;
    const Eigen::Vector2d span = patch.elementBox(patch.elementAt({xi, eta})).size();
    const Points d = patch.basis().derivatives(xi, eta, 1);
    return std::min(span[0] * d.row(1).norm(), span[1] * d.row(2).norm());
}

double longestSide(const Triangle& triangle) {
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
        longest = std::max(longest, (triangle.corner(i) - triangle.corner((i + 1) % 3)).norm());
    }
    return longest;
}

// Centroids of the n x n equal triangles into which a triangle is divided.
std::vector<WeightedPlace> evenlyDivided(int n) {
    std::vector<WeightedPlace> places;
    const auto addTriangle = [&](double i, double j) {
        const double a = i / n, b = j / n;
        places.push_back({{a, b, 1 - a - b}, 1.0 / (n * n)});
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
            addTriangle(i + 1.0 / 3, j + 1.0 / 3);
            if (i + j + 1 < n) {
                addTriangle(i + 2.0 / 3, j + 2.0 / 3);
            }
        }
    }
    return places;
}

int nDivisions(const SurfaceInterface& splines, const Triangle& triangle) {
    constexpr int most = 32;
    const Point centroid = triangle.at(Barycentric::Constant(1.0 / 3));
    const double spans = longestSide(triangle) / spanSize(splines, centroid);
    return std::isfinite(spans)
               ? static_cast<int>(std::clamp(std::ceil(2 * spans), 2.0, 1.0 * most))
               : most;
}

// Exact for the product of the functions of both directions on a piece that is affine;
// on faces well inside a knot span, where functions are nearly quadratic, fewer points do.
int degreeOf(const SurfaceInterface& splines, const FaceMesh& faces) {
    constexpr double small = 0.5; // of a span
    int degree = 2;
    if (faceSizes(splines, faces).largest <= small) {
        return degree;
    }
    for (int i = 0; i < splines.nPieces(); ++i) {
        const geometry::NurbsSurface& basis = splines.piece(i).patch.basis();
        degree = std::max(degree, basis.u().degree() + basis.v().degree());
    }
    return degree;
}

SurfaceMesh surfaceMesh(const FaceMesh& mesh) {
    return SurfaceMesh(mesh.vertices, mesh.faces, ValuesAt::faces);
}

Eigen::VectorXd faceAreas(const SurfaceMesh& mesh) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.nFaces());
    for (int i = 0; i < mesh.nTriangles(); ++i) {
        areas[mesh.faceOf(i)] += mesh.triangle(i).area();
    }
    return areas;
}

} // namespace

LoadPoints integratedLoads(const SurfaceInterface& splines, const FaceMesh& faces, double reach) {
    constexpr double whole = 1 - 1e-6;
    const SurfaceMesh mesh = surfaceMesh(faces);
    const Eigen::VectorXd areas = faceAreas(mesh);
    LoadPointList list;
    std::vector<WeightedPlace> places;
    IntersectionVisitor visitor;
    visitor.point = [&](const IntersectionPoint& point) {
        places.push_back({point.inTriangle, point.weight});
    };
    visitor.endTriangle = [&](int number, double coveredShare) {
        const Triangle triangle = mesh.triangle(number);
        if (coveredShare < whole || !restoreArea(places)) {
            places = evenlyDivided(nDivisions(splines, triangle));
        }
        const int face = mesh.faceOf(number);
        for (const WeightedPlace& place : places) {
            list.add(triangle.at(place.at), face, place.weight * triangle.area() / areas[face]);
        }
        places.clear();
    };
    intersect(mesh, splines, reach, degreeOf(splines, faces), visitor);
    return list.finish(mesh.nFaces());
}

} // namespace tokay::mapper
