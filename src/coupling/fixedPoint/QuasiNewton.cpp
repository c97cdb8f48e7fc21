// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fixedPoint/QuasiNewton.hpp"

namespace tokay::coupling {

const SchemaOf<QuasiNewtonOptions>& QuasiNewtonOptions::schema() {
    using Options = QuasiNewtonOptions;
    static const SchemaOf<Options> guards = {
        {"signalToNoise", &Options::signalToNoise, "[0, inf)", "",
         "A difference is used if its length relative to the displacement exceeds this multiple of "
         "the fluid's residual; 0: always."},
        {"maxStep", &Options::maxStep, "[0, inf)", "",
         "Maximum length of a step in units of the residual; 0: unlimited."},
        {"keepFraction", &Options::keepFraction, "[0, 1)", "",
         "At the end of a time step its differences below this fraction of its largest are "
         "dropped; 0: none."}};
    static const SchemaOf<Options> schema = SchemaOf<Options>()
                                                .with(InitialRelaxation::schema())
                                                .with(FilterOptions::schema())
                                                .with(guards);
    return schema;
}

Eigen::VectorXd QuasiNewton::next(const Eigen::VectorXd& x, const Eigen::VectorXd& xTilde,
                                  double fluidResidual) {
    const Iterate now{x, xTilde};
    if (previous_.x.size() != 0 && isInformative(now, fluidResidual)) {
        const Eigen::VectorXd w = xTilde - previous_.xTilde;
        learn(w - (x - previous_.x), w);
    }
    previous_ = now;
    const Eigen::VectorXd residual = xTilde - x;
    if (isEmpty()) {
        return x + options_.initialRelaxation * residual;
    }
    Eigen::VectorXd move = residual - response(residual);
    limit(move, residual.norm());
    return x + move;
}

/// A move within the fluid's own error is informative of nothing but its drift.
bool QuasiNewton::isInformative(const Iterate& now, double fluidResidual) const {
    const double noise = options_.signalToNoise * fluidResidual * now.xTilde.norm();
    return (now.x - previous_.x).norm() > noise;
}

void QuasiNewton::limit(Eigen::VectorXd& move, double residualNorm) const {
    const double longest = options_.maxStep * residualNorm;
    if (longest > 0 && move.norm() > longest) {
        move *= longest / move.norm();
    }
}

} // namespace tokay::coupling
