// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/mapFiles.hpp"

#include "common/OutputFile.hpp"
#include "common/errors.hpp"
#include "tokayMap/MapReport.hpp"
#include "tokayMap/checkSizes.hpp"
#include "tokayMap/readSide.hpp"

namespace tokay::tool {

namespace {

using Eigen::MatrixXd;

struct Transfer {
    std::unique_ptr<mapper::Mapping> mapping;
    MatrixXd result;
};

Transfer consistent(const Source& from, const Side& to, const OperatorOptions& options) {
    Transfer transfer{makeMapping(*from.side, to, options), {}};
    const MatrixXd mapped = transfer.mapping->apply(from.values);
    transfer.result = givesValues(options.kind) ? to.sampled(mapped) : mapped;
    return transfer;
}

Transfer conservative(const Source& from, const Side& to, const OperatorOptions& options) {
    if (from.side->hasSplines() && !givesValues(options.kind)) {
        throw InputError("forces of control points are moments of a field over "
                         "splines, not forces at points: map them by mortar");
    }
    Transfer transfer{makeMapping(to, *from.side, options), {}};
    transfer.result = transfer.mapping->applyTransposed(from.values);
    return transfer;
}

void writeFiles(const MapOptions& options, const Side& to, const std::string& field,
                const MatrixXd& result, const MapReport& report) {
    if (!options.output.empty() && options.conservative) {
        to.writeForces(options.output, field, result);
    } else if (!options.output.empty()) {
        to.writeSamples(options.output, field, result);
    }
    if (options.report.empty()) {
        return;
    }
    OutputFile file(options.report);
    file.write(report.json());
    file.publish();
}

} // namespace

std::string mapFiles(const MapOptions& options) {
    const Source from = readSource(options);
    const auto to = readSide(options.to, options.sideTo());
    if (!options.scaleFrom && !options.scaleTo) {
        checkSizes(*from.side, *to);
    }
    const Transfer transfer = options.conservative ? conservative(from, *to, options.mapping)
                                                   : consistent(from, *to, options.mapping);
    MapReport report(*from.side, *to, transfer.mapping->report());
    report.addRanges(from, transfer.result);
    if (options.conservative) {
        report.addSums(from, transfer.result);
    } else if (!options.testFunction.empty()) {
        report.addError(transfer.result, to->samplePoints(), testFunctionOf(options),
                        options.testFunction);
    }
    writeFiles(options, *to, from.name, transfer.result, report);
    return report.text();
}

} // namespace tokay::tool
