// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/GradientTerm.hpp"

#include "common/dense/SingularValues.hpp"
#include "common/errors.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "igaStructure/kinematics/shell/edges/NodeUnion.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Singular values below this part of the largest one are zero: samples that do not tell
// two monomials apart.
constexpr double rounding = 1e-13;

// Derivatives of the functions at a place along a direction of space.
RowVectorXd derivativeAlong(const PatchLocation& at, const Vector3d& direction) {
    const Eigen::Matrix2d metric = at.baseVectors.transpose() * at.baseVectors;
    const Vector2d parameters = metric.inverse() * (at.baseVectors.transpose() * direction);
    return parameters.transpose() * at.N.bottomRows<2>();
}

int nMonomials(int degree) {
    return (degree + 1) * (degree + 2) / 2;
}

RowVectorXd monomials(const Vector2d& x, int degree) {
    RowVectorXd values(nMonomials(degree));
    Index k = 0;
    for (int n = 0; n <= degree; ++n) {
        for (int l = 0; l <= n; ++l) {
            values[k++] = std::pow(x[0], n - l) * std::pow(x[1], l);
        }
    }
    return values;
}

} // namespace

GradientTerm::GradientTerm(const ShellPatch& patch, int face, const ExtendedElements& elements)
    : patch_(patch), face_(face), elements_(elements),
      degree_(std::max(patch.surface().u().degree(), patch.surface().v().degree())) {}

void GradientTerm::add(ExtensionFunctional& functional) {
    for (const auto& [element, direction] : directions()) {
        addElement(element, direction, functional);
    }
}

// Mean conormals of the curves in the elements that they cut.
std::map<int, Vector3d> GradientTerm::directions() const {
    std::map<int, Vector3d> sums;
    for (const TracePoint& point : elements_.trace()) {
        if (point.support->trim.face == face_) {
            const PatchLocation& at = point.on.side;
            sums.try_emplace(point.element, Vector3d::Zero()).first->second +=
                point.on.weight * (at.baseVectors * at.conormal());
        }
    }
    for (auto& [element, sum] : sums) {
        sum.normalize();
    }
    return sums;
}

Vector2d GradientTerm::inElements(const geometry::Parameters& at, int element) const {
    const geometry::ParameterBox box = patch_.patch().elementBox(element);
    return (at - box.centre()).cwiseQuotient(box.size());
}

// As many Gauss points a direction as the degree: there derivatives are one order better.
const std::vector<GradientTerm::Sample>& GradientTerm::samplesIn(int element) {
    const auto [found, isNew] = samples_.try_emplace(element);
    if (isNew) {
        const geometry::ParameterBox box = patch_.patch().elementBox(element);
        const int nU = patch_.patch().nElementsU();
        const auto& rule = geometry::gaussLegendre(degree_);
        for (const double eta : rule.points) {
            for (const double xi : rule.points) {
                const geometry::Parameters at =
                    box.lower + box.size().cwiseProduct(Vector2d(xi, eta));
                found->second.push_back(
                    {{patch_, element % nU, element / nU, at, Vector2d::Zero()}, at});
            }
        }
    }
    return found->second;
}

// Of uncut elements in a square around an element, as small as suffices.
std::vector<const GradientTerm::Sample*> GradientTerm::samplesNear(int element) {
    const geometry::TrimmedPatch& patch = patch_.patch();
    const int i = element % patch.nElementsU();
    const int j = element / patch.nElementsU();
    constexpr int nearest = 3, farthest = 8; // fewer diverge at degree 2
    for (int reach = nearest; reach <= farthest; ++reach) {
        std::vector<const Sample*> samples;
        for (int l = std::max(j - reach, 0); l <= std::min(j + reach, patch.nElementsV() - 1);
             ++l) {
            for (int k = std::max(i - reach, 0); k <= std::min(i + reach, patch.nElementsU() - 1);
                 ++k) {
                const int other = patch.elementNumber(k, l);
                const auto& cut = elements_.cut(face_, other);
                if (patch.state(other) != geometry::ElementState::full || cut[0] || cut[1] ||
                    cut[2]) {
                    continue;
                }
                for (const Sample& sample : samplesIn(other)) {
                    samples.push_back(&sample);
                }
            }
        }
        if (static_cast<int>(samples.size()) >= 2 * nMonomials(degree_)) {
            return samples;
        }
    }
    throw InputError(fmt::format("supports: edgeMethod egm finds too few uncut elements of patch "
                                 "\"{}\" to continue a gradient from: refine "
                                 "discretisation.elements",
                                 patch.name()));
}

void GradientTerm::addElement(int element, const Vector3d& direction,
                              ExtensionFunctional& functional) {
    const std::vector<const Sample*> samples = samplesNear(element);
    NodeUnion nodes;
    std::vector<RowVectorXd> derivatives;
    std::vector<std::vector<Index>> places;
    VectorXd distances(samples.size());
    MatrixXd monomialRows(samples.size(), nMonomials(degree_));
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const Vector2d x = inElements(samples[s]->place, element);
        places.push_back(nodes.add(samples[s]->at.nodes));
        derivatives.push_back(derivativeAlong(samples[s]->at, direction));
        monomialRows.row(static_cast<Index>(s)) = monomials(x, degree_);
        distances[static_cast<Index>(s)] = x.norm();
    }
    MatrixXd rows = MatrixXd::Zero(static_cast<Index>(samples.size()), nodes.size());
    for (std::size_t s = 0; s < samples.size(); ++s) {
        rows.row(static_cast<Index>(s))(places[s]) += derivatives[s];
    }

    const geometry::ParameterBox box = patch_.patch().elementBox(element);
    const int nU = patch_.patch().nElementsU();
    const auto& rule = geometry::gaussLegendre(degree_ + 1);
    for (std::size_t b = 0; b < rule.points.size(); ++b) {
        for (std::size_t a = 0; a < rule.points.size(); ++a) {
            const geometry::Parameters at =
                box.lower + box.size().cwiseProduct(Vector2d(rule.points[a], rule.points[b]));
            const PatchLocation here(patch_, element % nU, element / nU, at, Vector2d::Zero());
            const Vector2d x = inElements(at, element);
            VectorXd roots(samples.size()); // of the weights
            for (std::size_t s = 0; s < samples.size(); ++s) {
                const double distance = (inElements(samples[s]->place, element) - x).norm();
                constexpr double width = 2; // elements
                roots[static_cast<Index>(s)] = std::exp(-0.5 * std::pow(distance / width, 2));
            }
            // Value at x of the weighted fit, as weights of the samples.
            const SingularValues fit(roots.asDiagonal() * monomialRows);
            const Index rank = fit.rank(rounding);
            const VectorXd weights =
                roots.asDiagonal() *
                (fit.U.leftCols(rank) *
                 (fit.values.head(rank).cwiseInverse().asDiagonal() *
                  (fit.V.leftCols(rank).transpose() * monomials(x, degree_).transpose())));
            const double area =
                box.area() * here.baseVectors.col(0).cross(here.baseVectors.col(1)).norm();
            functional.addLagged(here.nodes, elements_.cut(face_, element),
                                 derivativeAlong(here, direction), nodes.nodes(),
                                 weights.transpose() * rows,
                                 std::sqrt(area) * area * rule.weights[a] * rule.weights[b]);
        }
    }
}

} // namespace tokay::structure
