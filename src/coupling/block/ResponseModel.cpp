// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/block/ResponseModel.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::coupling {

using Eigen::VectorXd;

namespace {

/// Factor between the inertia in a step of second-order backward differences and in
/// Euler's, by which a scheme may begin anew.
constexpr double schemeFactor = 2.25;

} // namespace

void ResponseModel::beginTimeStep() {
    rankAtBegin_ = J_.rank();
    atBegin_.reset();
    scaledByAtBegin_ = scaledBy_;
    observed_ = {};
    differences_.clear();
}

/// J as it was then. Only a step that replaces J needs a copy: most append to it.
const LowRankMatrix& ResponseModel::atBegin() {
    if (!atBegin_) {
        atBegin_ = J_;
        atBegin_->truncate(rankAtBegin_);
    }
    return *atBegin_;
}

void ResponseModel::reset() {
    atBegin();
    J_ = {};
    observed_ = {};
    scaledBy_ = 1;
}

void ResponseModel::rejectTimeStep() {
    J_ = atBegin();
    scaledBy_ = scaledByAtBegin_;
}

void ResponseModel::changeTimeStep(double ratio) {
    J_.scale(ratio * ratio);
    scaledBy_ *= ratio * ratio;
}

void ResponseModel::learn(const VectorXd& v, const VectorXd& w, double noise) {
    const Difference difference{v, w, noise};
    if (scaledBy_ == 1) {
        add(difference);
        return;
    }
    differences_.push_back(difference);
    J_ = atBegin();
    J_.scale(bestFactor());
    observed_ = {};
    for (const Difference& each : differences_) {
        add(each);
    }
}

/// The f that minimises the sum of |w - f J v|² / |w|², each difference counting the less
/// the closer it is to its noise, between those of inertia alone and of no inertia.
double ResponseModel::bestFactor() {
    double agreement = 0;
    double size = 0;
    for (const Difference& each : differences_) {
        const VectorXd expected = atBegin().apply(each.v, each.w.size());
        const double signal = each.v.squaredNorm();
        const double scale = each.w.squaredNorm() * (signal + each.noise * each.noise);
        if (scale > 0) {
            agreement += signal / scale * expected.dot(each.w);
            size += signal / scale * expected.squaredNorm();
        }
    }
    const double withoutInertia = 1 / scaledBy_;
    return std::clamp(size > 0 ? agreement / size : 1.0,
                      std::min(1.0, withoutInertia) / schemeFactor,
                      std::max(1.0, withoutInertia) * schemeFactor);
}

void ResponseModel::add(const Difference& difference) {
    const auto& [v, w, noise] = difference;
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
    scaledBy_ = 1;
}

} // namespace tokay::coupling
