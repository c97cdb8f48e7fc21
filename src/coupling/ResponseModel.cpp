// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/ResponseModel.hpp"

#include "coupling/StateReader.hpp"
#include "coupling/StateWriter.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::coupling {

using Eigen::VectorXd;

void ResponseModel::beginTimeStep() {
    atBegin_ = J_;
    taught_ = {};
}

void ResponseModel::learn(const VectorXd& v, const VectorXd& w, double noise) {
    const VectorXd fresh = v - taught_.apply(v, v.size());
    const double news = std::clamp(v.dot(fresh), 0.0, v.squaredNorm());
    const double leastNoise = std::pow(options_.filterLimit, 2) * (v.squaredNorm() - news);
    const double scale = news + noise * noise + leastNoise;
    if (scale > 0) {
        J_.append(w - J_.apply(v, w.size()), fresh / scale);
        taught_.append(fresh, fresh / scale);
    }
}

void ResponseModel::acceptTimeStep() {
    if (isIgnorant()) {
        return;
    }
    // Twice as many terms as the matrix has rows say nothing more than half do.
    const auto full = static_cast<int>(std::min(J_.A().rows(), J_.B().rows()));
    if (J_.rank() > std::min(options_.largestRank, 2 * full)) {
        J_.compress(options_.largestRank / 2, options_.rankLimit);
    }
}

void ResponseModel::save(StateWriter& state) const {
    state.matrix(J_.A());
    state.matrix(J_.B());
}

void ResponseModel::restore(StateReader& state) {
    const Eigen::MatrixXd A = state.matrix();
    const Eigen::MatrixXd B = state.interfaceMatrix();
    if (A.cols() != B.cols()) {
        throw channel::PeerError("the factors of a Jacobian do not fit each other");
    }
    J_ = {};
    J_.append(A, B);
}

} // namespace tokay::coupling
