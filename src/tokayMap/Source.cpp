// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/Source.hpp"

#include "common/Formula.hpp"
#include "common/errors.hpp"
#include "tokayMap/files/readValues.hpp"
#include "tokayMap/readSide.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tokay::tool {

namespace {

/// @param where  beginning of the message, to be followed by the index of the row
void requireFinite(const Eigen::MatrixXd& values, const std::string& where) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        for (Eigen::Index j = 0; j < values.cols(); ++j) {
            if (!std::isfinite(values(i, j))) {
                throw InputError(fmt::format("{} {} (indices start at 0) is {}; allowed: finite "
                                             "numbers",
                                             where, i, values(i, j)));
            }
        }
    }
}

Source sourceOfField(const MapOptions& options) {
    if (isSplineModel(options.from)) {
        throw InputError(fmt::format("{}: a spline model has no fields: give the values of its "
                                     "control points by --values, or a formula by --test-function",
                                     options.from));
    }
    MeshFile mesh = readMesh(options.from);
    const MeshField field = fieldNamed(mesh, options.from, options.field, options.fromAt);
    requireFinite(field.values,
                  fmt::format("{}: field '{}': the value of {}", options.from, field.name,
                              field.at == mapper::ValuesAt::vertices ? "vertex" : "face"));
    return {meshSide(std::move(mesh), options.from, options.sideFrom(field.at)), field.values,
            options.field};
}

void checkValues(const Source& source) {
    const int n = source.side->discretisation().nValues();
    if (source.values.rows() != n) {
        throw InputError(fmt::format("there are {} rows of values, but {} are needed for\n  {}",
                                     source.values.rows(), n, source.side->description()));
    }
}

} // namespace

Source readSource(const MapOptions& options) {
    if (!options.field.empty()) {
        return sourceOfField(options);
    }
    Source source{readSide(options.from,
                           options.sideFrom(options.fromAt.value_or(mapper::ValuesAt::vertices))),
                  {},
                  "values"};
    if (!options.valuesFile.empty()) {
        source.values = readValues(options.valuesFile);
        requireFinite(source.values, options.valuesFile + ": the value in row");
    } else if (!options.testFunction.empty()) {
        source.values = source.side->valuesOf(testFunctionOf(options));
    } else {
        throw InputError("nothing to map: name a field of the file (--field, --list shows them), a "
                         "file of values (--values) or a formula (--test-function)");
    }
    checkValues(source);
    return source;
}

ScalarFunction testFunctionOf(const MapOptions& options) {
    const Formula formula(options.testFunction, "--test-function: ");
    if (formula.dependsOnTime()) {
        throw InputError(fmt::format("--test-function: '{}' has t in it, but a field between two "
                                     "files has no time",
                                     options.testFunction));
    }
    return [formula](const Point& x) { return formula(x, 0); };
}

} // namespace tokay::tool
