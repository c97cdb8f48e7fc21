// SPDX-License-Identifier: GPL-3.0-or-later
// A cylinder and a fluid mesh of flat faces on it: what consistent and what
// conservative mapping of a pressure lose. Usage: curvedInterface RESULTS.csv
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numeric>

namespace {

using namespace tokay;
using Eigen::VectorXd;
using geometry::Point;
using geometry::Points;

const double quarterTurn = std::acos(0.0);

/// A quarter of a cylinder of radius and height 1, biquadratic, n x n spans.
mapper::SurfaceInterface structure(int n) {
    const geometry::NurbsSurface surface =
        refine(geometry::cylinderPatch(Point::Zero(), 1, 1, 0, quarterTurn), 2, 2, n, n);
    std::vector<int> numbers(surface.nControlPoints());
    std::iota(numbers.begin(), numbers.end(), 0);
    return mapper::SurfaceInterface({{geometry::TrimmedPatch(surface), numbers, "cylinder"}},
                                    surface.nControlPoints());
}

/// n x n flat faces with their vertices on the cylinder.
mapper::SurfaceMesh fluid(int n) {
    Points vertices((n + 1) * (n + 1), 3);
    mapper::SurfaceMesh::Faces faces;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const int a = i + (n + 1) * j;
            const double angle = quarterTurn * i / n;
            vertices.row(a) << std::cos(angle), std::sin(angle), static_cast<double>(j) / n;
            if (i < n && j < n) {
                faces.push_back({a, a + 1, a + n + 2, a + n + 1});
            }
        }
    }
    return mapper::SurfaceMesh(vertices, faces, mapper::ValuesAt::faces);
}

VectorXd areas(const mapper::SurfaceMesh& mesh) {
    VectorXd areas = VectorXd::Zero(mesh.nFaces());
    for (int i = 0; i < mesh.nTriangles(); ++i) {
        areas[mesh.faceOf(i)] += mesh.triangle(i).area();
    }
    return areas;
}

/// Root mean square of a pressure's deviation from 1 over the structure.
double deviation(const VectorXd& pressure, const mapper::RowSparseMatrix& mass) {
    const VectorXd error = pressure - VectorXd::Ones(pressure.size());
    const VectorXd ones = VectorXd::Ones(pressure.size());
    return std::sqrt(error.dot(mass * error) / ones.dot(mass * ones));
}

struct Losses {
    /// Of the normal force between fluid and structure, relative.
    double force;
    /// Of the pressure 1 on the structure.
    double pressure;
};

Losses consistent(const mapper::MortarMapping& mortar, const mapper::SurfaceMesh& mesh) {
    const VectorXd pressure = mortar.apply(VectorXd::Ones(mesh.nFaces()));
    const double force = VectorXd::Ones(pressure.size()).dot(mortar.massMatrix() * pressure);
    return {std::abs(force / areas(mesh).sum() - 1), deviation(pressure, mortar.massMatrix())};
}

/// Forces pressure x area of the faces go to the structure by a transpose; the
/// pressure there is that which has these forces.
/// @param back  from the structure to the faces
Losses conservative(const mapper::Mapping& back, const mapper::MortarMapping& mortar,
                    const mapper::SurfaceMesh& mesh) {
    const VectorXd forces = back.applyTransposed(areas(mesh));
    const mapper::MassInverse inverse(mortar.massMatrix(), mapper::SingularMass::refuse);
    return {std::abs(forces.sum() / areas(mesh).sum() - 1),
            deviation(inverse.solve(forces), mortar.massMatrix())};
}

class Lines {
  public:
    explicit Lines(const std::string& path) : csv_(path) {
        csv_ << "nFaces,nSpans,transfer,forceLoss,pressureError\n";
        fmt::print("{:>7} {:>7} {:<28} {:>10} {:>14}\n", "nFaces", "nSpans", "transfer",
                   "forceLoss", "pressureError");
    }
    void add(int n, int nSpans, const char* transfer, const Losses& losses) {
        csv_ << fmt::format("{},{},{},{:.2e},{:.2e}\n", n * n, nSpans * nSpans, transfer,
                            losses.force, losses.pressure);
        fmt::print("{:>7} {:>7} {:<28} {:>10.2e} {:>14.2e}\n", n * n, nSpans * nSpans, transfer,
                   losses.force, losses.pressure);
    }

  private:
    std::ofstream csv_;
};

void measure(int n, int nSpans, Lines& lines) {
    const mapper::SurfaceMesh mesh = fluid(n);
    const mapper::SurfaceInterface splines = structure(nSpans);
    mapper::MortarOptions options;
    options.gapLimit.relative = 0.1; // coarse facets
    const mapper::MortarMapping mortar(mesh, splines, options);
    lines.add(n, nSpans, "consistent mortar", consistent(mortar, mesh));
    lines.add(
        n, nSpans, "conservative nearestElement",
        conservative(mapper::NearestElementMapping(splines, mesh.coordinates(), options.gapLimit),
                     mortar, mesh));
    lines.add(n, nSpans, "conservative mortar",
              conservative(mapper::MortarMapping(splines, mesh, options), mortar, mesh));
}

} // namespace

int main(int argc, char** argv) {
    try {
        Lines lines(argc > 1 ? argv[1] : "curvedInterface.csv");
        for (const int n : {7, 14, 28, 56}) {
            measure(n, 4, lines);
            measure(n, 10, lines);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
