// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/Source.hpp"

#include "common/Formula.hpp"
#include "common/errors.hpp"
#include "tokayMap/files/readValues.hpp"
#include "tokayMap/readSide.hpp"

#include <fmt/format.h>

namespace tokay::tool {

namespace {

Source sourceOfField(const MapOptions& options) {
    if (isSplineModel(options.from)) {
        throw InputError(fmt::format("{}: a spline model has no fields: give the values of its "
                                     "control points by --values, or a formula by --test-function",
                                     options.from));
    }
    MeshFile mesh = readMesh(options.from);
    const MeshField field = fieldNamed(mesh, options.from, options.field, options.fromAt);
    return {meshSide(std::move(mesh), options.from, options.sideFrom(field.at)), field.values,
            options.field};
}

void checkValues(const Source& source) {
    const int n = source.side->discretisation().nValues();
    if (source.values.rows() != n) {
        throw InputError(fmt::format("there are {} rows of values, but {} are needed for\n  {}",
                                     source.values.rows(), n, source.side->description()));
    }
    if (!source.values.allFinite()) {
        throw InputError(fmt::format("the field '{}' has values that are not finite", source.name));
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
    } else if (!options.testFunction.empty()) {
        source.values = source.side->valuesOf(testFunctionOf(options));
    } else {
        throw InputError("what is to be mapped? Name a field of the file (--field, "
                         "--list shows them), a file of values (--values) or a "
                         "formula (--test-function)");
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
