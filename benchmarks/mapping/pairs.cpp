// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs.hpp"

#include "geometry/trimming/elementQuadrature.hpp"
#include "interfaces.hpp"
#include "tokayMap/splineProjection.hpp"

#include <cmath>

namespace tokay::benchmark {

namespace {

using Eigen::VectorXd;
using mapper::CurveInterface;
using mapper::Functions;
using mapper::SplineInterface;
using mapper::SurfaceInterface;
using mapper::SurfaceMesh;
using mapper::ValuesAt;

VectorXd atPoints(Field field, const Eigen::MatrixX3d& points) {
    VectorXd values(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        values[i] = valueOf(field, points.row(i));
    }
    return values;
}

VectorXd valuesOf(const mapper::Discretisation& mesh, Field field) {
    return atPoints(field, mesh.coordinates());
}
VectorXd valuesOf(const SplineInterface& curve, Field field) {
    const CurveInterface fine = lines(20000, 5);
    return mapper::MortarMapping(fine, curve).apply(valuesOf(fine, field));
}
VectorXd valuesOf(const SurfaceInterface& splines, Field field) {
    return tool::splineProjection(splines, [&](const Point& x) { return valueOf(field, x); });
}

struct Samples {
    std::vector<Point> points;
    std::vector<Functions> functions;

    void enter(Setup& setup) const {
        setup.samples.resize(static_cast<Eigen::Index>(points.size()), 3);
        for (std::size_t i = 0; i < points.size(); ++i) {
            setup.samples.row(static_cast<Eigen::Index>(i)) = points[i];
        }
        setup.sampled = [functions = functions](const VectorXd& values) {
            VectorXd samples(functions.size());
            for (std::size_t i = 0; i < functions.size(); ++i) {
                samples[static_cast<Eigen::Index>(i)] =
                    functions[i].weights.dot(values(functions[i].values));
            }
            return samples;
        };
    }
};

void enterSamples(const mapper::Discretisation& mesh, Setup& setup) {
    setup.samples = mesh.coordinates();
    setup.sampled = [](const VectorXd& values) { return values; };
}
void enterSamples(const SplineInterface& interface, Setup& setup) {
    Samples samples;
    const mapper::InterfaceCurve& curve = interface.curve(0);
    for (std::size_t e = 0; e + 1 < curve.breakpoints().size(); ++e) {
        for (const double t : {0.05, 0.3, 0.5, 0.7, 0.95}) {
            const double first = curve.breakpoints()[e], last = curve.breakpoints()[e + 1];
            const double xi = first + t * (last - first);
            samples.points.push_back(curve.derivatives(xi, 0).row(0));
            samples.functions.push_back(curve.functions(xi));
        }
    }
    samples.enter(setup);
}
void enterSamples(const SurfaceInterface& splines, Setup& setup) {
    Samples samples;
    const geometry::TrimmedPatch& patch = splines.piece(0).patch;
    for (int element = 0; element < patch.nElements(); ++element) {
        for (const auto& at : elementQuadrature(patch, element, 4)) {
            samples.points.push_back(patch.basis().point(at.xi, at.eta));
            samples.functions.push_back(splines.functions(0, at.xi, at.eta));
        }
    }
    samples.enter(setup);
}

template <class From, class To>
Setup setup(From from, To to) {
    Setup made;
    const auto source = std::make_shared<From>(std::move(from));
    const auto destination = std::make_shared<To>(std::move(to));
    for (const Field field : {smooth, shock}) {
        made.values[field] = valuesOf(*source, field);
    }
    made.hasSplinesFrom =
        std::is_same_v<From, SplineInterface> || std::is_same_v<From, SurfaceInterface>;
    made.from = source;
    made.nTo = destination->nValues();
    enterSamples(*destination, made);
    made.mortar = [=](const mapper::MortarOptions& options) {
        return std::make_unique<mapper::MortarMapping>(*source, *destination, options);
    };
    return made;
}

const std::map<std::string, double> linearOrders = {
    {"nearestNeighbour", 1}, {"nearestElement", 2}, {"mortar", 2}, {"mortarDual", 2}};

std::vector<Pair> curvePairs() {
    const std::vector<int> sizes = {32, 64, 128, 256, 512, 1024}, quick = {32, 64, 128};
    return {{"1D FE-FE", sizes, quick,
             [](int n) { return setup(lines(n, 0), lines(2 * n / 3, 1)); }, true, false,
             linearOrders},
            {"1D FV-FE",
             sizes,
             quick,
             [](int n) { return setup(lines(n, 0, ValuesAt::faces), lines(2 * n / 3, 1)); },
             true,
             false,
             {{"nearestNeighbour", 1}}},
            {"1D IBRA-FE", sizes, quick,
             [](int n) { return setup(curve(2, n / 4), lines(2 * n / 3, 1)); }, true},
            {"1D FE-IBRA", sizes, quick, [](int n) { return setup(lines(n, 0), curve(2, n / 4)); }},
            // So fine a source that only the destination's error is left.
            {"1D fine FE-IBRA, degree 2",
             {8, 16, 32},
             {8, 16, 32},
             [](int n) { return setup(lines(20000, 0), curve(2, n)); },
             false,
             true,
             {{"mortar", 3}}},
            {"1D fine FE-IBRA, degree 3",
             {8, 16, 32},
             {8, 16, 32},
             [](int n) { return setup(lines(20000, 0), curve(3, n)); },
             false,
             true,
             {{"mortar", 4}}}};
}

std::vector<Pair> surfacePairs() {
    const std::vector<int> sizes = {16, 32, 64, 128}, quick = {16, 32};
    const auto fluid = [](int n) { return quadrilaterals(n, 0, ValuesAt::vertices); };
    const auto spline = [](int n, Trimmed trimmed) {
        return patch(2, std::max(2, n / 4), trimmed);
    };
    return {{"2D FE-FE", sizes, quick,
             [=](int n) { return setup(fluid(n), triangles(2 * n / 3, 1, ValuesAt::vertices)); },
             true, false, linearOrders},
            {"2D FV-FE",
             sizes,
             quick,
             [=](int n) {
                 return setup(quadrilaterals(n, 0, ValuesAt::faces),
                              triangles(2 * n / 3, 1, ValuesAt::vertices));
             },
             true,
             false,
             {{"nearestNeighbour", 1}}},
            {"2D FE-IBRA", sizes, quick,
             [=](int n) { return setup(fluid(n), spline(n, Trimmed::no)); }},
            {"2D FE-IBRA trimmed", sizes, quick,
             [=](int n) { return setup(fluid(n), spline(n, Trimmed::hole)); }},
            {"2D IBRA-FE", sizes, quick,
             [=](int n) { return setup(spline(n, Trimmed::no), fluid(n)); }},
            {"2D IBRA-FE trimmed", sizes, quick,
             [=](int n) { return setup(spline(n, Trimmed::hole), fluid(n)); }},
            {"2D fine FE-IBRA, degree 2",
             {2, 4, 8},
             {2, 4, 8},
             [=](int n) { return setup(fluid(200), patch(2, n, Trimmed::no)); },
             false,
             true,
             {{"mortar", 3}}}};
}

} // namespace

double valueOf(Field field, const Point& x) {
    if (field == smooth) {
        return std::sin(4 * x[0]) * std::cos(3 * x[1]);
    }
    return x[0] + 0.3 * x[1] > 0.61 ? 1 : 0;
}

std::vector<Pair> pairs() {
    std::vector<Pair> all = curvePairs();
    for (Pair& pair : surfacePairs()) {
        all.push_back(std::move(pair));
    }
    return all;
}

} // namespace tokay::benchmark
