// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/ResponseModel.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::coupling {

using Eigen::VectorXd;

void ResponseModel::beginTimeStep() {
    atBegin_ = J_;
    observed_ = {};
}

void ResponseModel::learn(const VectorXd& v, const VectorXd& w, double noise) {
    const VectorXd fresh = v - observed_.apply(v, v.size());
    const double news = std::clamp(v.dot(fresh), 0.0, v.squaredNorm());
    const double leastNoise = std::pow(options_.filterLimit, 2) * (v.squaredNorm() - news);
    const double scale = news + noise * noise + leastNoise;
    if (scale > 0) {
        J_.append(w - J_.apply(v, w.size()), fresh / scale);
        observed_.append(fresh, fresh / scale);
    }
}

void ResponseModel::acceptTimeStep() {
    J_.limitRank(options_);
}

} // namespace tokay::coupling
