// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/projection/VolumeProjector.hpp"

#include "geometry/projection/BoxTree.hpp"
#include "geometry/projection/closestParameter.hpp"

#include <limits>

namespace tokay::geometry {

namespace {

std::vector<double> centres(const KnotVector& knots) {
    std::vector<double> result;
    for (int i = 0; i < knots.nSpans(); ++i) {
        result.push_back(0.5 * (knots.breakpoints()[i] + knots.breakpoints()[i + 1]));
    }
    return result;
}

/// Sides are numbered as Side is.
Eigen::Vector3d parametersOnSide(const NurbsVolume& volume, int side,
                                 const SurfaceProjection& place) {
    const int axis = side / 2;
    Eigen::Vector3d parameters;
    parameters[axis] =
        side % 2 == 1 ? volume.direction(axis).last() : volume.direction(axis).first();
    parameters[axis == 0 ? 1 : 0] = place.xi;
    parameters[axis == 2 ? 1 : 2] = place.eta;
    return parameters;
}

} // namespace

VolumeProjector::VolumeProjector(NurbsVolume volume)
    : volume_(std::move(volume)), size_(Box::around(volume_.controlPoints()).diagonal()) {
    for (int side = 0; side < 6; ++side) {
        sides_.emplace_back(volume_.boundarySurface(static_cast<Side>(side)).surface);
    }
    for (const double zeta : centres(volume_.w())) {
        for (const double eta : centres(volume_.v())) {
            for (const double xi : centres(volume_.u())) {
                samples_.emplace_back(xi, eta, zeta);
            }
        }
    }
    samplePoints_.resize(static_cast<Eigen::Index>(samples_.size()), 3);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        samplePoints_.row(static_cast<Eigen::Index>(i)) = volume_.point(samples_[i]).transpose();
    }
}

VolumeProjection VolumeProjector::closestOnSides(const Point& point) const {
    VolumeProjection best{Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
    for (int side = 0; side < 6; ++side) {
        const SurfaceProjection found = sides_[side].closest(point);
        if (found.distance < best.distance) {
            best = {parametersOnSide(volume_, side, found), found.distance};
        }
    }
    return best;
}

/// Newton's iteration from the nearest element's centre.
VolumeProjection VolumeProjector::inside(const Point& point) const {
    Eigen::Index nearest = 0;
    (samplePoints_.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    Eigen::Vector3d lower, upper;
    for (int axis = 0; axis < 3; ++axis) {
        lower[axis] = volume_.direction(axis).first();
        upper[axis] = volume_.direction(axis).last();
    }
    const auto osculate = [&](const Eigen::Vector3d& x) {
        // Curvature counts only where the offset stays, which is on the sides.
        return Osculation<3>{volume_.point(x) - point, volume_.jacobian(x),
                             Eigen::Matrix3d::Zero()};
    };
    const ClosestParameter<3> found =
        closestParameter<3>(osculate, lower, upper, samples_[nearest], size_);
    return {found.parameter, found.offset.norm()};
}

VolumeProjection VolumeProjector::closest(const Point& point) const {
    const VolumeProjection within = inside(point), onSides = closestOnSides(point);
    return within.distance < onSides.distance ? within : onSides;
}

} // namespace tokay::geometry
