// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Mapping.hpp"
#include "mapper/nearest/SplineSamples.hpp"

#include <memory>

namespace tokay::mapper {

/// A mapping from points, between them and splines: the spline's values at its
/// samples, then from there to the destination.
class SampledMapping : public Mapping {
  public:
    /// @param mapping  from the samples' points
    SampledMapping(SplineSamples samples, std::unique_ptr<const Mapping> mapping)
        : functions_(std::move(samples.functions)), mapping_(std::move(mapping)) {
        report_ = mapping_->report();
        report_.method += " from samples of the spline";
        report_.bytes += bytesOf(functions_);
    }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override {
        return mapping_->apply(functions_ * values);
    }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        return functions_.transpose() * mapping_->applyTransposed(forces);
    }

  private:
    RowSparseMatrix functions_;
    std::unique_ptr<const Mapping> mapping_;
};

} // namespace tokay::mapper
