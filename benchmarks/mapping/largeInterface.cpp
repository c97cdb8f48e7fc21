// SPDX-License-Identifier: GPL-3.0-or-later
// A large fluid interface onto a trimmed patch: what each operator costs, and
// whether mortar keeps its goals. Usage: largeInterface RESULTS.csv [quick]
#include "geometry/primitives/primitives.hpp"
#include "geometry/spline/curveParts.hpp"
#include "geometry/spline/refinement.hpp"
#include "mapper/Stopwatch.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <numeric>

namespace {

using namespace tokay;
using geometry::Point;
using geometry::Points;

const double pi = std::acos(-1.0);

double height(double x, double y) {
    return 0.1 * std::sin(3 * x) * std::cos(2 * y);
}
double smooth(const Point& x) {
    return std::sin(4 * x[0]) * std::cos(3 * x[1]);
}

/// Largest memory of the process so far [GB].
double peakMemory() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1e6;
}

/// Curved unit square of 100 x 100 biquadratic spans with a round hole.
mapper::SurfaceInterface trimmedPatch() {
    geometry::NurbsSurface surface =
        refine(geometry::rectangle(Point::Zero(), 1, 1), 2, 2, 100, 100);
    Points points = surface.controlPoints();
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        points(i, 2) = height(points(i, 0), points(i, 1));
    }
    surface = surface.withControlPoints(points);
    const geometry::NurbsCurve circle = geometry::arc(Point(0.47, 0.52, 0), 0.2, 0.1, 0.1 + 2 * pi);
    geometry::TrimmedPatch patch(
        surface, {geometry::TrimmingLoop::around({{0, 0}, {1, 1}}),
                  geometry::TrimmingLoop(geometry::LoopKind::inner, {reversed(circle)})});
    std::vector<int> numbers(surface.nControlPoints());
    std::iota(numbers.begin(), numbers.end(), 0);
    return mapper::SurfaceInterface({{std::move(patch), numbers, "patch"}},
                                    surface.nControlPoints());
}

/// n x n uneven quadrilaterals on the same surface, one value a face.
mapper::SurfaceMesh fluidMesh(int n) {
    Points vertices((n + 1) * (n + 1), 3);
    mapper::SurfaceMesh::Faces faces;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const int a = i + (n + 1) * j;
            const double x = (i + (i == 0 || i == n ? 0 : 0.2 * std::sin(3.0 * i + j))) / n;
            const double y = (j + (j == 0 || j == n ? 0 : 0.2 * std::cos(2.0 * i - j))) / n;
            vertices.row(a) << x, y, height(x, y);
            if (i < n && j < n) {
                faces.push_back({a, a + 1, a + n + 2, a + n + 1});
            }
        }
    }
    return mapper::SurfaceMesh(vertices, faces, mapper::ValuesAt::faces);
}

Eigen::VectorXd field(const Points& x) {
    Eigen::VectorXd values(x.rows());
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        values[i] = smooth(x.row(i));
    }
    return values;
}

struct Row {
    std::string method;
    int nFaces;
    double buildSeconds, applySeconds, gigabytes, meanError, largestError;
    mapper::MappingReport report;
};

/// Field at the mesh's vertices, from the structure's.
Row nearestElement(const mapper::SurfaceMesh& mesh, const mapper::SurfaceInterface& splines) {
    mapper::GapLimit limit;
    limit.refuse = false; // vertices over the hole
    const mapper::NearestElementMapping mapping(splines, mesh.vertices(), limit);
    // Values of control points at their Greville points: a field close to smooth().
    const Eigen::VectorXd values = field(splines.coordinates());
    const mapper::Stopwatch watch;
    const Eigen::VectorXd mapped = mapping.apply(values);
    const double seconds = watch.seconds();
    double squared = 0, largest = 0;
    int n = 0;
    for (Eigen::Index i = 0; i < mapped.size(); ++i) {
        const Point x = mesh.vertices().row(i);
        if (std::hypot(x[0] - 0.47, x[1] - 0.52) < 0.2) {
            continue;
        }
        const double error = std::abs(mapped[i] - smooth(x));
        squared += error * error;
        largest = std::max(largest, error);
        ++n;
    }
    return {"nearestElement",       mesh.nFaces(), mapping.report().seconds, seconds, peakMemory(),
            std::sqrt(squared / n), largest,       mapping.report()};
}

/// Field of the structure, from the mesh's faces.
Row mortar(const mapper::SurfaceMesh& mesh, const mapper::SurfaceInterface& splines) {
    mapper::MortarOptions options;
    options.singular = mapper::SingularMass::minimumNorm;
    const mapper::MortarMapping mapping(mesh, splines, options);
    const mapper::Stopwatch watch;
    const Eigen::VectorXd mapped = mapping.apply(field(mesh.coordinates()));
    const double seconds = watch.seconds();
    double squared = 0, largest = 0;
    int n = 0;
    const geometry::TrimmedPatch& patch = splines.piece(0).patch;
    for (int element = 0; element < patch.nElements(); ++element) {
        const Eigen::Vector2d centre = patch.elementBox(element).centre();
        if (patch.state(element) != geometry::ElementState::full) {
            continue;
        }
        const mapper::Functions f = splines.functions(0, centre[0], centre[1]);
        const double error = std::abs(f.weights.dot(mapped(f.values)) -
                                      smooth(patch.basis().point(centre[0], centre[1])));
        squared += error * error;
        largest = std::max(largest, error);
        ++n;
    }
    return {"mortar", mesh.nFaces(),   mapping.report().seconds,
            seconds,  peakMemory(),    std::sqrt(squared / n),
            largest,  mapping.report()};
}

/// How the cost of mortar grows and compares.
struct Comparison {
    /// Exponent of the build time against the smallest size; 0 there.
    double growth;
    /// Build time over that of the nearest element mapping.
    double ratio;
};

/// Goals for the full size of a million faces; "" for smaller ones.
std::string verdict(const Row& row, const Comparison& comparison) {
    if (row.nFaces < 1000000) {
        return "";
    }
    const bool good = row.buildSeconds < 60 && row.gigabytes < 3 && comparison.growth <= 1.15 &&
                      comparison.ratio <= 10;
    return good ? "ok" : "MISSED";
}

class Table {
  public:
    explicit Table(const std::string& path) : csv_(path) {
        write("operator,nFaces,build_s,apply_s,peakMemory_GB,meanError,largestError,constantError,"
              "forceSumError,nInverted,rank,growthExponent,ratioToNearestElement,verdict");
    }

    void add(const Row& row) { write(cells(row) + ",,,"); }
    void add(const Row& row, const Comparison& comparison) {
        const std::string judged = verdict(row, comparison);
        isGood_ = isGood_ && judged != "MISSED";
        write(cells(row) +
              fmt::format(",{:.3g},{:.3g},{}", comparison.growth, comparison.ratio, judged));
    }
    bool isGood() const { return isGood_; }

  private:
    static std::string cells(const Row& row) {
        return fmt::format("{},{},{:.4g},{:.4g},{:.3g},{:.3g},{:.3g},{:.2g},{:.2g},{},{}",
                           row.method, row.nFaces, row.buildSeconds, row.applySeconds,
                           row.gigabytes, row.meanError, row.largestError, row.report.rowSumError,
                           row.report.forceSumError, row.report.nInverted, row.report.rank);
    }
    void write(const std::string& line) {
        fmt::print("{}\n", line);
        std::fflush(stdout);
        csv_ << line << '\n';
    }

    std::ofstream csv_;
    bool isGood_ = true;
};

bool measureAll(const std::vector<int>& sizes, Table& table) {
    const mapper::SurfaceInterface splines = trimmedPatch();
    double firstSeconds = 0, firstFaces = 0;
    for (const int n : sizes) {
        const mapper::SurfaceMesh mesh = fluidMesh(n);
        const Row nearest = nearestElement(mesh, splines);
        table.add(nearest);
        const Row row = mortar(mesh, splines);
        if (firstFaces == 0) {
            firstSeconds = row.buildSeconds;
            firstFaces = row.nFaces;
        }
        const double growth = row.nFaces > firstFaces ? std::log(row.buildSeconds / firstSeconds) /
                                                            std::log(row.nFaces / firstFaces)
                                                      : 0;
        table.add(row, {growth, row.buildSeconds / nearest.buildSeconds});
    }
    return table.isGood();
}

} // namespace

int main(int argc, char** argv) {
    try {
        Table table(argc > 1 ? argv[1] : "largeInterface.csv");
        const std::vector<int> sizes =
            argc > 2 ? std::vector<int>{50, 100, 200} : std::vector<int>{100, 316, 1000};
        return measureAll(sizes, table) ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
