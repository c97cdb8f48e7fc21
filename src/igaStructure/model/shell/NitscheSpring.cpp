#include "igaStructure/model/shell/NitscheSpring.hpp"

#include "igaStructure/model/shell/CutFractions.hpp"
#include "igaStructure/model/shell/EdgeTraction.hpp"
#include "igaStructure/model/shell/NodeUnion.hpp"
#include "igaStructure/model/shell/ShellElement.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tokay::structure {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

NitscheSpring::NitscheSpring(std::vector<int> nodes, MatrixXd held, MatrixXd traction,
                             MatrixXd stabilisation)
    : EdgeSpring(std::move(nodes)), held_(std::move(held)), traction_(std::move(traction)),
      stabilisation_(std::move(stabilisation)) {}

EdgeSpring::Answer NitscheSpring::answer(const VectorXd& displacement, Strains,
                                         bool withTangent) const {
    const VectorXd u = gathered(displacement);
    const VectorXd held = held_ * u;
    const VectorXd traction = traction_ * u;
    const VectorXd spring = stabilisation_ * held - traction;
    Answer answer{held_.transpose() * spring - traction_.transpose() * held,
                  {},
                  0.5 * held.dot(spring - traction)};
    if (withTangent) {
        // held^T (stabilisation / 2 held - traction), made symmetric.
        const MatrixXd half = held_.transpose() * (0.5 * stabilisation_ * held_ - traction_);
        answer.tangent = half + half.transpose();
    }
    return answer;
}

namespace {

// Largest square of a polynomial, or of its slope, at a distance from an interval of
// length 1 (0: at its end) over the integral of its square: sums over Legendre's
// polynomials.
struct InverseConstants {
    double value = 0, slope = 0;

    InverseConstants(int degree, double distance) {
        const double x = 1 + 2 * distance;
        double before = 0, now = 1, slopeBefore = 0, slopeNow = 0;
        for (int k = 0; k <= degree; ++k) {
            value += (2 * k + 1) * now * now;
            slope += (2 * k + 1) * 4 * slopeNow * slopeNow;
            const double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
            const double slopeNext = slopeBefore + (2 * k + 1) * now;
            before = now;
            now = next;
            slopeBefore = slopeNow;
            slopeNow = slopeNext;
        }
    }
};

// Bounds of the square of a traction on the edge over the energy of the elements it is
// taken from: of membrane forces, of shear forces, of moments.
struct Bounds {
    double membrane = 0, shear = 0, moment = 0;

    void enlarge(const Bounds& other) {
        membrane = std::max(membrane, other.membrane);
        shear = std::max(shear, other.shear);
        moment = std::max(moment, other.moment);
    }
};

// One side of an edge: the elements whose tractions are taken.
class Side {
  public:
    Side(const ShellPatch& patch, const SideStiffness& stiffness)
        : patch_(patch), stiffness_(stiffness), fractions_(patch) {}

    void add(const PatchPlace& place, double weight) {
        Source& source = sources_[fractions_.standIn(place.element)];
        source.length += weight;
        source.size = place.size;
        const geometry::ParameterBox box =
            patch_.patch().elementBox(fractions_.standIn(place.element));
        const Eigen::Vector2d outside = (place.parameters - box.upper)
                                            .cwiseMax(box.lower - place.parameters)
                                            .cwiseQuotient(box.size());
        source.distance = std::max(source.distance, outside.maxCoeff());
    }

    void findBounds() {
        for (auto& [element, source] : sources_) {
            source.bounds = boundsOf(element, source);
            largest_.enlarge(source.bounds);
        }
    }

    EdgeTraction traction(const PatchPlace& place) const {
        return {place, fractions_.standIn(place.element), stiffness_.bending > 0};
    }
    const Bounds& bounds(const PatchPlace& place) const {
        return sources_.at(fractions_.standIn(place.element)).bounds;
    }
    const Bounds& largest() const { return largest_; }

  private:
    struct Source {
        double length = 0, size = 0, distance = 0;
        Bounds bounds;
    };

    double area(int number) const {
        ShellElement element;
        element.moveTo(patch_, number % patch_.u().nSpans(), number / patch_.u().nSpans());
        double sum = 0;
        for (int point = 0; point < element.nPoints(); ++point) {
            element.moveToPoint(point);
            sum += element.area();
        }
        return sum;
    }

    Bounds boundsOf(int element, const Source& source) const {
        const int degree = std::max(patch_.surface().u().degree(), patch_.surface().v().degree());
        const InverseConstants constants(degree, source.distance);
        const double width = std::min(area(element) / source.length, source.size);
        // Of C, divided by the stiffness, the largest eigenvalue is 1 + nu.
        constexpr double most = 1.5;
        return {most * stiffness_.membrane * constants.value / width,
                most * stiffness_.bending * constants.slope / std::pow(width, 3),
                most * stiffness_.bending * constants.value / width};
    }

    const ShellPatch& patch_;
    SideStiffness stiffness_;
    CutFractions fractions_;
    std::map<int, Source> sources_;
    Bounds largest_;
};

// Displacement, its derivative along the edge and the rotation at a place.
MatrixXd motionRows(const PatchPlace& place) {
    const RowVectorXd along = place.tangent.transpose() * place.N.bottomRows<2>();
    const RowVectorXd across = place.conormal().transpose() * place.N.bottomRows<2>();
    MatrixXd rows = MatrixXd::Zero(7, 3 * place.N.cols());
    for (Eigen::Index k = 0; k < place.N.cols(); ++k) {
        rows.block<3, 3>(0, 3 * k).diagonal().setConstant(place.N(0, k));
        rows.block<3, 3>(3, 3 * k).diagonal().setConstant(along[k]);
        rows.block<1, 3>(6, 3 * k) = across[k] * place.normal().transpose();
    }
    return rows;
}

MatrixXd tractionRows(const EdgeTraction& traction) {
    MatrixXd rows(7, traction.force.cols());
    rows << traction.force, traction.twist, -traction.moment;
    return rows;
}

// The share of the energy that each of the terms may take is a quarter.
MatrixXd stabilisation(const Bounds& bounds, const Vector3d& normal, bool bending) {
    constexpr double shares = 4;
    const Matrix3d across = normal * normal.transpose();
    MatrixXd matrix = MatrixXd::Zero(7, 7);
    matrix.topLeftCorner<3, 3>() = bounds.membrane * Matrix3d::Identity();
    if (bending) {
        matrix.topLeftCorner<3, 3>() += (bounds.shear - bounds.membrane) * across;
    }
    matrix.block<3, 3>(3, 3) = bounds.moment * across;
    matrix(6, 6) = bounds.moment;
    return shares * matrix;
}

class Builder {
  public:
    Builder(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
            bool rotation, const std::array<SideStiffness, 2>& stiffness, double factor)
        : factor_(factor), bending_(stiffness[0].bending > 0) {
        for (int c = 0; c < 3; ++c) {
            held_[c] = held_[3 + c] = components[c] ? 1 : 0;
        }
        held_[6] = rotation ? 1 : 0;
        sides_.emplace_back(*points.front().side.patch, stiffness[0]);
        if (points.front().other) {
            sides_.emplace_back(*points.front().other->patch, stiffness[1]);
        }
        for (const EdgePoint& point : points) {
            sides_[0].add(point.side, point.weight);
            if (point.other) {
                sides_[1].add(*point.other, point.weight);
            }
        }
        for (Side& side : sides_) {
            side.findBounds();
        }
        if (sides_.size() > 1) {
            const auto decisive = [&](const Side& side) {
                return bending_ ? side.largest().shear : side.largest().membrane;
            };
            const double first = decisive(sides_[0]), second = decisive(sides_[1]);
            weights_ = {second / (first + second), first / (first + second)};
        }
    }

    std::unique_ptr<EdgeSpring> spring(const EdgePoint& point) const {
        const PatchPlace* places[2] = {&point.side, point.other ? &*point.other : nullptr};
        NodeUnion nodes;
        std::vector<MatrixXd> motions, tractions;
        std::vector<std::vector<Eigen::Index>> motionColumns, tractionColumns;
        MatrixXd stiffness = MatrixXd::Zero(7, 7);
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            const EdgeTraction traction = sides_[s].traction(*places[s]);
            motions.push_back(motionRows(*places[s]));
            tractions.push_back(tractionRows(traction));
            motionColumns.push_back(nodes.add(places[s]->nodes));
            tractionColumns.push_back(nodes.add(traction.nodes));
            stiffness += weights_[s] * weights_[s] *
                         stabilisation(sides_[s].bounds(*places[s]), places[s]->normal(), bending_);
        }
        const auto n = 3 * nodes.size();
        MatrixXd held = MatrixXd::Zero(7, n), traction = MatrixXd::Zero(7, n);
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            const VectorXd signs = s == 0 ? VectorXd::Ones(7) : otherSigns(point);
            addColumns(held_.cwiseProduct(signs).asDiagonal() * motions[s], motionColumns[s], 1,
                       held);
            addColumns(signs.asDiagonal() * tractions[s], tractionColumns[s], weights_[s],
                       traction);
        }
        return std::make_unique<NitscheSpring>(nodes.nodes(), std::move(held),
                                               point.weight * traction,
                                               factor_ * point.weight * stiffness);
    }

  private:
    // Jumps are the first side's minus the other's, whose edge may run the other way.
    static VectorXd otherSigns(const EdgePoint& point) {
        const Vector3d first = point.side.baseVectors * point.side.tangent;
        const Vector3d second = point.other->baseVectors * point.other->tangent;
        const double way = first.dot(second) > 0 ? 1 : -1;
        VectorXd signs(7);
        signs << -1, -1, -1, -way, -way, -way, -way;
        return signs;
    }

    double factor_;
    bool bending_;
    Eigen::Matrix<double, 7, 1> held_;
    std::vector<Side> sides_;
    std::array<double, 2> weights_ = {1, 0};
};

} // namespace

std::vector<std::unique_ptr<EdgeSpring>>
nitscheSprings(const std::vector<EdgePoint>& points, const std::array<bool, 3>& components,
               bool rotation, const std::array<SideStiffness, 2>& sides, double factor) {
    std::vector<std::unique_ptr<EdgeSpring>> springs;
    if (points.empty()) {
        return springs;
    }
    const Builder builder(points, components, rotation, sides, factor);
    for (const EdgePoint& point : points) {
        springs.push_back(builder.spring(point));
    }
    return springs;
}

} // namespace tokay::structure
