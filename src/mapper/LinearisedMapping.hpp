// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/Mapping.hpp"

#include <memory>

namespace tokay::mapper {

/// A nonlinear mapping's derivative in the reference configuration, at every
/// displacement: what a body with linear strains moves by.
class LinearisedMapping : public Mapping {
  public:
    explicit LinearisedMapping(std::unique_ptr<const Mapping> mapping)
        : mapping_(std::move(mapping)) {
        report_ = mapping_->report();
    }

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override {
        return mapping_->apply(values);
    }
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override {
        return mapping_->applyTransposed(forces);
    }

  private:
    std::unique_ptr<const Mapping> mapping_;
};

} // namespace tokay::mapper
