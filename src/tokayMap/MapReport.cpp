// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/MapReport.hpp"

#include <fmt/format.h>

namespace tokay::tool {

namespace {

using Eigen::MatrixXd;

JsonObject rangeOf(const MatrixXd& values) {
    JsonObject range;
    range.add("smallest", values.minCoeff());
    range.add("largest", values.maxCoeff());
    return range;
}

std::string sumText(const MatrixXd& values) {
    std::string text;
    for (Eigen::Index i = 0; i < values.cols(); ++i) {
        text += fmt::format(" {:.10g}", values.col(i).sum());
    }
    return text;
}

} // namespace

MapReport::MapReport(const Side& from, const Side& to, const mapper::MappingReport& mapping) {
    text_ = fmt::format("from {}\nto {}\n{}", from.description(), to.description(), mapping.text());
    json_.add("from", from.description());
    json_.add("to", to.description());
    json_.add("mapping", mapping.json());
}

void MapReport::addRanges(const Source& from, const MatrixXd& result) {
    text_ += fmt::format("{}: {:.6g} to {:.6g}, mapped {:.6g} to {:.6g}\n", from.name,
                         from.values.minCoeff(), from.values.maxCoeff(), result.minCoeff(),
                         result.maxCoeff());
    json_.add("values", rangeOf(from.values));
    json_.add("mappedValues", rangeOf(result));
}

void MapReport::addSums(const Source& from, const MatrixXd& result) {
    text_ +=
        fmt::format("sum of {}:{}, mapped:{}\n", from.name, sumText(from.values), sumText(result));
}

void MapReport::addError(const Eigen::VectorXd& samples, const Points& points,
                         const ScalarFunction& function, const std::string& formula) {
    Eigen::ArrayXd exact(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        exact[i] = function(points.row(i));
    }
    const Eigen::ArrayXd error = (samples.array() - exact).abs() / exact.abs().maxCoeff();
    const double rootMeanSquare = std::sqrt(error.square().mean());
    text_ += fmt::format("error against {}, relative to its largest value: root mean square "
                         "{:.3g}, largest {:.3g}\n",
                         formula, rootMeanSquare, error.maxCoeff());
    json_.add("rootMeanSquareError", rootMeanSquare);
    json_.add("largestError", error.maxCoeff());
}

} // namespace tokay::tool
