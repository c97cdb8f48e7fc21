// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fixedPoint/Aitken.hpp"

#include "common/errors.hpp"
#include "coupling/step/StateReader.hpp"
#include "coupling/step/StateWriter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tokay::coupling {

const SchemaOf<Aitken::Options>& Aitken::Options::schema() {
    static const SchemaOf<Options> schema =
        SchemaOf<Options>()
            .with(InitialRelaxation::schema())
            .with(SchemaOf<Options>{{"minRelaxation", &Options::minRelaxation, "(0, 2]", "",
                                     "Minimum relaxation factor."},
                                    {"maxRelaxation", &Options::maxRelaxation, "(0, inf)", "",
                                     "Maximum relaxation factor."}});
    return schema;
}

Aitken::Aitken(const Options& options) : options_(options), relaxation_(options.initialRelaxation) {
    if (options.minRelaxation > options.maxRelaxation) {
        throw InputError(fmt::format("maxRelaxation: {:g} is below minRelaxation, which is {:g}",
                                     options.maxRelaxation, options.minRelaxation));
    }
}

void Aitken::beginTimeStep() {
    previousResidual_.resize(0);
    previousX_.resize(0);
    // The last factor of the last step, unless it was bolder than the first.
    relaxation_ = std::min(relaxation_, options_.initialRelaxation);
}

Eigen::VectorXd Aitken::next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                             double /*fluidResidual*/) {
    const Eigen::VectorXd residual = xTilde - x;
    if (previousResidual_.size() != 0 && previousX_ != x) {
        updateRelaxation(residual);
    }
    previousResidual_ = residual;
    previousX_ = x;
    return x + relaxation_ * residual;
}

void Aitken::updateRelaxation(const Eigen::VectorXd& residual) {
    const Eigen::VectorXd change = residual - previousResidual_;
    const double squaredChange = change.squaredNorm();
    if (squaredChange == 0) {
        return;
    }
    const double proposed = -relaxation_ * previousResidual_.dot(change) / squaredChange;
    relaxation_ = std::clamp(proposed, options_.minRelaxation, options_.maxRelaxation);
}

void Aitken::rejectTimeStep() {
    relaxation_ = options_.initialRelaxation;
}

void Aitken::save(StateWriter& state) const {
    state.number(relaxation_);
}

void Aitken::restore(StateReader& state) {
    relaxation_ = state.number();
}

} // namespace tokay::coupling
