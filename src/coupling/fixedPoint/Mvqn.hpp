// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/fixedPoint/MultiVectorModel.hpp"

namespace tokay::coupling {

/// Multi-vector quasi-Newton (IMVJ): the inverse Jacobian is carried from step
/// to step, differences never mix across steps. @see MultiVectorModel
class Mvqn : public QuasiNewton {
  public:
    using Options = MultiVectorOptions;

    explicit Mvqn(const Options& options) : QuasiNewton(options), model_(options) {}

    void acceptTimeStep() override { model_.acceptTimeStep(); }
    void rejectTimeStep() override { model_.rejectTimeStep(); }
    void save(StateWriter& state) const override { model_.save(state); }
    void restore(StateReader& state) override { model_.restore(state); }
    int nColumns() const override { return model_.rank(); }

  protected:
    void learn(const Eigen::VectorXd& v, const Eigen::VectorXd& w) override { model_.learn(v, w); }
    bool isEmpty() const override { return model_.isEmpty(); }
    Eigen::VectorXd response(const Eigen::VectorXd& residual) const override {
        return model_.apply(residual, residual.size());
    }

  private:
    MultiVectorModel model_;
};

} // namespace tokay::coupling
