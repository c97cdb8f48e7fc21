// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/edges/MultiplierCoupling.hpp"

#include "igaStructure/kinematics/shell/edges/NodeUnion.hpp"

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

namespace {

// An edge's point with the value of a multiplier's function there, times its weight.
struct Sample {
    const EdgePoint* point;
    double factor;
};

struct Multiplier {
    std::vector<Sample> samples;
    double length = 0; ///< integral of the function [m]
};

int lowestDegree(const ShellPatch& patch) {
    return std::min(patch.surface().u().degree(), patch.surface().v().degree());
}

struct MultiplierSpace {
    int degree, nSpans;
};

MultiplierSpace multiplierSpace(const std::vector<EdgePoint>& points) {
    int degree = lowestDegree(*points.front().side.patch);
    double length = 0, span = 0;
    for (const EdgePoint& point : points) {
        length += point.weight;
        span = std::max(span, point.side.elementLength());
        if (point.other) {
            degree = std::min(degree, lowestDegree(*point.other->patch));
            span = std::max(span, point.other->elementLength());
        }
    }
    constexpr double rounding = 1e-6;
    const int nSpans = std::max(1, static_cast<int>(std::floor(length / span + rounding)));
    return {std::max(degree - 2, 0), nSpans};
}

// Visits the functions that are not zero at a parameter from 0 to 1.
template <class Visit>
void forEachFunction(const MultiplierSpace& space, double parameter, Visit visit) {
    if (space.degree == 0) {
        visit(std::min(static_cast<int>(parameter * space.nSpans), space.nSpans - 1), 1.0);
        return;
    }
    const geometry::KnotVector knots = geometry::KnotVector::uniform(space.degree, space.nSpans);
    const int span = knots.findSpan(parameter);
    const MatrixXd values = knots.basisDerivatives(span, parameter, 0);
    for (int k = 0; k <= space.degree; ++k) {
        visit(span - space.degree + k, values(0, k));
    }
}

std::vector<Multiplier> multipliers(const std::vector<EdgePoint>& points) {
    const MultiplierSpace space = multiplierSpace(points);
    std::vector<Multiplier> all(space.nSpans + space.degree);
    for (const EdgePoint& point : points) {
        forEachFunction(space, point.parameter, [&](int number, double value) {
            all[number].samples.push_back({&point, value * point.weight});
            all[number].length += value * point.weight;
        });
    }
    return all;
}

std::unique_ptr<EdgeCoupling> displacementMoment(const Multiplier& multiplier,
                                                 const std::array<bool, 3>& components,
                                                 const PenaltyStiffness& stiffness) {
    NodeUnion nodes;
    std::vector<std::pair<Eigen::Index, double>> terms;
    std::vector<WeightedPlace> sum;
    const auto collect = [&](const PatchLocation& place, double factor) {
        const std::vector<Eigen::Index> places = nodes.add(place.nodes);
        for (std::size_t k = 0; k < places.size(); ++k) {
            terms.emplace_back(places[k], factor * place.N(0, static_cast<Eigen::Index>(k)));
        }
    };
    for (const Sample& sample : multiplier.samples) {
        collect(sample.point->side, sample.factor);
        sum.push_back({sample.point->side.position, sample.factor});
        if (sample.point->other) {
            collect(*sample.point->other, -sample.factor);
        }
    }
    RowVectorXd row = RowVectorXd::Zero(nodes.size());
    for (const auto& [place, value] : terms) {
        row[place] += value;
    }
    Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
    double mass = 0;
    for (const Sample& sample : multiplier.samples) {
        mean += sample.factor * stiffness.ofDisplacement(*sample.point);
        mass += sample.factor * stiffness.massOfDisplacement(*sample.point);
    }
    const double square = std::pow(multiplier.length, 2);
    return std::make_unique<DisplacementPenalty>(nodes.nodes(), std::move(row), components,
                                                 mean / square, mass / square, std::move(sum));
}

// Moment of the rotation, with the measures of a RotationPenalty at each sample.
class RotationMoment : public EdgeCoupling {
  public:
    RotationMoment(const Multiplier& multiplier, const PenaltyStiffness& stiffness)
        : EdgeCoupling(std::vector<int>()) {
        NodeUnion nodes;
        for (const Sample& sample : multiplier.samples) {
            const double weight = sample.factor / std::pow(multiplier.length, 2);
            stiffness_ += weight * stiffness.ofRotation(*sample.point);
            const PatchLocation* other = sample.point->other ? &*sample.point->other : nullptr;
            RotationPenalty measure(sample.point->side, other, 1);
            std::vector<Eigen::Index> places = nodes.add(measure.nodes());
            terms_.push_back({std::move(measure), std::move(places), sample.factor});
        }
        nodes_ = nodes.nodes();
    }

    Answer answer(const VectorXd& displacement, Strains strains, bool withTangent) const override {
        const Moments moments = momentsAt(displacement, strains);
        Answer answer;
        answer.force = stiffness_ * moments.rows.transpose() * moments.values;
        answer.energy = 0.5 * stiffness_ * moments.values.squaredNorm();
        if (withTangent) {
            answer.tangent = stiffness_ * moments.rows.transpose() * moments.rows;
        }
        if (withTangent && strains == Strains::nonlinear) {
            addCurvature(displacement, moments.values, answer.tangent);
        }
        return answer;
    }

    MatrixXd restRows() const override {
        return momentsAt(VectorXd::Zero(3 * (1 + *std::max_element(nodes_.begin(), nodes_.end()))),
                         Strains::linear)
            .rows;
    }

  private:
    struct Term {
        RotationPenalty measure;
        std::vector<Eigen::Index> places;
        double factor;
    };
    struct Moments {
        VectorXd values;
        MatrixXd rows;
    };

    Moments momentsAt(const VectorXd& displacement, Strains strains) const {
        Moments moments;
        for (const Term& term : terms_) {
            const auto changes = term.measure.changes(displacement, strains, false);
            const auto n = static_cast<Eigen::Index>(changes.size());
            if (moments.values.size() == 0) {
                moments = {VectorXd::Zero(n), MatrixXd::Zero(n, 3 * nodes_.size())};
            }
            MatrixXd rows(n, term.measure.baseVectorRows().cols());
            for (Eigen::Index k = 0; k < n; ++k) {
                moments.values[k] += term.factor * changes[k].value;
                rows.row(k) = changes[k].gradient.transpose() * term.measure.baseVectorRows();
            }
            addColumns(rows, term.places, term.factor, moments.rows);
        }
        return moments;
    }

    // The second derivatives of the moments times their forces.
    void addCurvature(const VectorXd& displacement, const VectorXd& values,
                      MatrixXd& tangent) const {
        for (const Term& term : terms_) {
            const auto changes = term.measure.changes(displacement, Strains::nonlinear, true);
            const MatrixXd& rows = term.measure.baseVectorRows();
            MatrixXd hessian = MatrixXd::Zero(rows.rows(), rows.rows());
            for (std::size_t k = 0; k < changes.size(); ++k) {
                hessian += stiffness_ * term.factor * values[static_cast<Eigen::Index>(k)] *
                           changes[k].hessian;
            }
            const MatrixXd own = rows.transpose() * hessian * rows;
            for (std::size_t l = 0; l < term.places.size(); ++l) {
                for (std::size_t k = 0; k < term.places.size(); ++k) {
                    tangent.block<3, 3>(3 * term.places[k], 3 * term.places[l]) += own.block<3, 3>(
                        3 * static_cast<Eigen::Index>(k), 3 * static_cast<Eigen::Index>(l));
                }
            }
        }
    }

    std::vector<Term> terms_;
    double stiffness_ = 0;
};

} // namespace

std::vector<std::unique_ptr<EdgeCoupling>>
multiplierCouplings(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
                    bool rotation, const PenaltyStiffness& stiffness) {
    std::vector<std::unique_ptr<EdgeCoupling>> couplings;
    if (points.empty()) {
        return couplings;
    }
    for (const Multiplier& multiplier : multipliers(points)) {
        if (multiplier.samples.empty()) {
            continue;
        }
        if (components != std::array<bool, 3>{}) {
            couplings.push_back(displacementMoment(multiplier, components, stiffness));
        }
        if (rotation) {
            couplings.push_back(std::make_unique<RotationMoment>(multiplier, stiffness));
        }
    }
    return couplings;
}

} // namespace tokay::structure
