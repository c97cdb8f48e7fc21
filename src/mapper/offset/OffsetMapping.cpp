// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/offset/OffsetMapping.hpp"

#include "common/errors.hpp"
#include "mapper/Stopwatch.hpp"
#include "mapper/conservation.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>

namespace tokay::mapper {

namespace {

void checkPlane(const SplineInterface& axis) {
    for (const SplinePiece& piece : axis.pieces()) {
        const auto z = piece.curve.controlPoints().col(2);
        if (z.maxCoeff() - z.minCoeff() > 1e-9 * axis.size()) {
            throw InputError(fmt::format("the beam axis {} does not lie in a plane z = const: its "
                                         "control points reach from z = {:.6g} to {:.6g}",
                                         piece.name, z.minCoeff(), z.maxCoeff()));
        }
    }
}

/// Consecutive points are a part; as many as depend on nothing but the points, so that sums over
/// them are the same with any number of threads.
int nParts(std::size_t nPoints) {
    constexpr std::size_t worthAThread = 4096, most = 8;
    return static_cast<int>(std::clamp<std::size_t>(nPoints / worthAThread, 1, most));
}

/// Calls visit(part, i) for each point i of each part.
template <class Visit>
void forEachPoint(std::size_t nPoints, const Visit& visit) {
    const std::size_t n = nParts(nPoints);
#pragma omp parallel for schedule(dynamic, 1) if (n > 1)
    for (std::size_t part = 0; part < n; ++part) {
        for (std::size_t i = part * nPoints / n; i < (part + 1) * nPoints / n; ++i) {
            visit(part, i);
        }
    }
}

} // namespace

OffsetMapping::OffsetMapping(const SplineInterface& axis, const Points& to,
                             const GapLimit& gapLimit)
    : isBeam_(true), controlPoints_(axis.coordinates()) {
    const Stopwatch watch;
    checkPoints(to);
    checkPlane(axis);
    report_.method = "offset points of a beam";
    attachments_.reserve(to.rows());
    GapStatistics gaps(gapLimit, axis.size());
    for (Eigen::Index i = 0; i < to.rows(); ++i) {
        const Point point = to.row(i);
        const CurveInterface::Projection found = axis.closest(point);
        gaps.count(point, found.onCurve.distance, found.onCurve.converged, found.onCurve.ambiguous);
        const SplinePiece& piece = axis.pieces()[found.piece];
        const geometry::CurveBasis basis = piece.curve.basis(found.onCurve.xi, 1);
        const auto first = piece.controlPoints.begin() + basis.first;
        Eigen::Matrix3Xd N = Eigen::Matrix3Xd::Zero(3, basis.N.cols());
        N.topRows(2) = basis.N;
        attach(point, {first, first + basis.N.cols()}, N);
    }
    finish(gaps, to);
    report_.seconds = watch.seconds();
}

OffsetMapping::OffsetMapping(const SurfaceInterface& middle, const Points& to,
                             const GapLimit& gapLimit)
    : isBeam_(false), controlPoints_(middle.coordinates()) {
    const Stopwatch watch;
    checkPoints(to);
    report_.method = "offset points of a shell";
    attachments_.reserve(to.rows());
    GapStatistics gaps(gapLimit, middle.size());
    for (Eigen::Index i = 0; i < to.rows(); ++i) {
        const Point point = to.row(i);
        const SurfaceInterface::Projection found = middle.closest(point);
        const geometry::SurfaceProjection& at = found.onSurface;
        gaps.count(point, at.distance, at.converged, at.ambiguous);
        const SurfacePiece& piece = middle.piece(found.piece);
        geometry::SurfaceBasis basis = piece.patch.basis().basis(at.xi, at.eta, 1);
        for (int& number : basis.controlPoints) {
            number = piece.controlPoints[number];
        }
        attach(point, basis.controlPoints, basis.N);
    }
    finish(gaps, to);
    report_.seconds = watch.seconds();
}

void OffsetMapping::attach(const Point& point, const std::vector<int>& controlPoints,
                           const Eigen::Matrix3Xd& N) {
    const auto last = numbers_.end() - std::min(numbers_.size(), controlPoints.size());
    if (!std::equal(last, numbers_.end(), controlPoints.begin(), controlPoints.end())) {
        numbers_.insert(numbers_.end(), controlPoints.begin(), controlPoints.end());
    }
    Attachment attachment{numbers_.size() - controlPoints.size(),
                          functions_.size(),
                          static_cast<int>(controlPoints.size()),
                          0,
                          Eigen::Vector2d::Zero(),
                          {}};
    if (functions_.empty()) {
        // Most have as many, and growing would take twice the memory.
        functions_.reserve(attachments_.capacity() * N.size());
    }
    functions_.insert(functions_.end(), N.data(), N.data() + N.size());
    const Frame frame = frameOf(attachment, controlPoints_);
    if (!(frame.area > 0)) {
        throw InputError(fmt::format("the point at ({:.6g}, {:.6g}, {:.6g}) projects onto a place "
                                     "where the surface has no normal (a pole)",
                                     point[0], point[1], point[2]));
    }
    const Point offset = point - frame.r;
    attachment.zeta = offset.dot(frame.a3);
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << frame.a1, frame.a2;
    attachment.tangential =
        (tangents.transpose() * tangents).inverse() * (tangents.transpose() * offset);
    attachment.reference = position(attachment, frame);
    attachments_.push_back(attachment);
}

void OffsetMapping::finish(const GapStatistics& gaps, const Points& to) {
    gaps.enter(report_);
    Points translation(controlPoints_.rows(), 3);
    translation.rowwise() = Eigen::RowVector3d(1, 1, 1);
    report_.rowSumError = (apply(translation).array() - 1).abs().maxCoeff();
    Points forces = probeForces(to.rows());
    if (isBeam_) {
        forces.col(2).setZero();
    }
    measureConservation(*this, forces, controlPoints_, to, report_);
    report_.bytes = static_cast<double>(functions_.size()) * sizeof(double) +
                    static_cast<double>(numbers_.size()) * sizeof(int);
}

Eigen::Map<const Eigen::Matrix3Xd> OffsetMapping::functions(const Attachment& attachment) const {
    return {functions_.data() + attachment.firstFunction, 3, attachment.nFunctions};
}

Eigen::Matrix3d OffsetMapping::atPoint(const Attachment& attachment, const Points& values) const {
    const Eigen::Map<const Eigen::Matrix3Xd> N = functions(attachment);
    // Row by row: sums of outer products take a multiple of the time.
    Point value = Point::Zero(), byXi = value, byEta = value;
    for (int j = 0; j < attachment.nFunctions; ++j) {
        const Point here = values.row(controlPoint(attachment, j));
        value += N(0, j) * here;
        byXi += N(1, j) * here;
        byEta += N(2, j) * here;
    }
    Eigen::Matrix3d rows;
    rows << value.transpose(), byXi.transpose(), byEta.transpose();
    return rows;
}

OffsetMapping::Frame OffsetMapping::frameOf(const Attachment& attachment,
                                            const Points& controlPoints) const {
    const Eigen::Matrix3d d = atPoint(attachment, controlPoints);
    Frame frame;
    frame.r = d.row(0);
    frame.a1 = d.row(1);
    // A beam is a strip of unit depth: a1 x a2 then lies left of the axis.
    frame.a2 = isBeam_ ? Point(-Point::UnitZ()) : Point(d.row(2));
    frame.a3 = frame.a1.cross(frame.a2);
    frame.area = frame.a3.norm();
    frame.a3 /= frame.area;
    return frame;
}

Point OffsetMapping::position(const Attachment& attachment, const Frame& frame) {
    return frame.r + attachment.zeta * frame.a3 + attachment.tangential[0] * frame.a1 +
           attachment.tangential[1] * frame.a2;
}

Point OffsetMapping::positionVariation(const Attachment& attachment, const Frame& frame,
                                       const Eigen::Matrix3d& d) {
    const Point da1 = d.row(1), da2 = d.row(2);
    const Point turned = da1.cross(frame.a2) + frame.a1.cross(da2);
    const Point da3 = (turned - frame.a3 * frame.a3.dot(turned)) / frame.area;
    return d.row(0).transpose() + attachment.zeta * da3 + attachment.tangential[0] * da1 +
           attachment.tangential[1] * da2;
}

Points OffsetMapping::moved(const Points& displacements) const {
    const Points current = controlPoints_ + displacements;
    Points result(attachments_.size(), 3);
    forEachPoint(attachments_.size(), [&](std::size_t, std::size_t i) {
        const Attachment& attachment = attachments_[i];
        result.row(i) = position(attachment, frameOf(attachment, current)) - attachment.reference;
    });
    return result;
}

Points OffsetMapping::variation(const Points& displacements, const Points& variation) const {
    const Points current = controlPoints_ + displacements;
    Points result(attachments_.size(), 3);
    forEachPoint(attachments_.size(), [&](std::size_t, std::size_t i) {
        const Attachment& attachment = attachments_[i];
        result.row(i) = positionVariation(attachment, frameOf(attachment, current),
                                          atPoint(attachment, variation));
    });
    return result;
}

Points OffsetMapping::forces(const Points& displacements, const Points& forces) const {
    const Points current = controlPoints_ + displacements;
    std::vector<Points> ofParts(nParts(attachments_.size()), Points::Zero(current.rows(), 3));
    forEachPoint(attachments_.size(), [&](std::size_t part, std::size_t i) {
        const Attachment& attachment = attachments_[i];
        const Eigen::Matrix3d conjugate =
            conjugateForces(attachment, frameOf(attachment, current), forces.row(i));
        const Eigen::Map<const Eigen::Matrix3Xd> N = functions(attachment);
        for (int j = 0; j < attachment.nFunctions; ++j) {
            ofParts[part].row(controlPoint(attachment, j)) += N(0, j) * conjugate.row(0) +
                                                              N(1, j) * conjugate.row(1) +
                                                              N(2, j) * conjugate.row(2);
        }
    });
    for (std::size_t part = 1; part < ofParts.size(); ++part) {
        ofParts[0] += ofParts[part];
    }
    return ofParts[0];
}

Eigen::Matrix3d OffsetMapping::conjugateForces(const Attachment& attachment, const Frame& frame,
                                               const Point& f) {
    const Point g = attachment.zeta / frame.area * (f - frame.a3 * frame.a3.dot(f));
    Eigen::Matrix3d conjugate;
    conjugate.row(0) = f;
    conjugate.row(1) = frame.a2.cross(g) + attachment.tangential[0] * f;
    conjugate.row(2) = g.cross(frame.a1) + attachment.tangential[1] * f;
    return conjugate;
}

RowSparseMatrix OffsetMapping::derivative(const RowSparseMatrix& shares) const {
    constexpr std::size_t entriesAtOnce = 1 << 20; // 16 MB; many points share entries
    RowSparseMatrix sum(3 * shares.cols(), 3 * controlPoints_.rows());
    std::vector<Eigen::Triplet<double>> entries;
    const auto addEntries = [&] {
        RowSparseMatrix part(sum.rows(), sum.cols());
        part.setFromTriplets(entries.begin(), entries.end());
        sum += part;
        entries.clear();
    };
    for (std::size_t i = 0; i < attachments_.size(); ++i) {
        const Attachment& attachment = attachments_[i];
        const Frame frame = frameOf(attachment, controlPoints_);
        for (RowSparseMatrix::InnerIterator share(shares, static_cast<Eigen::Index>(i)); share;
             ++share) {
            appendDerivative(attachment, frame, share.value(), share.col(), entries);
        }
        if (entries.size() > entriesAtOnce) {
            addEntries();
        }
    }
    addEntries();
    return sum;
}

void OffsetMapping::appendDerivative(const Attachment& attachment, const Frame& frame,
                                     double weight, Eigen::Index row,
                                     std::vector<Eigen::Triplet<double>>& entries) const {
    const Eigen::Map<const Eigen::Matrix3Xd> N = functions(attachment);
    for (int j = 0; j < attachment.nFunctions; ++j) {
        for (int component = 0; component < 3; ++component) {
            const Point along = weight * Point::Unit(component);
            const Point change = positionVariation(attachment, frame, N.col(j) * along.transpose());
            const int column = 3 * controlPoint(attachment, j) + component;
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(3 * row + k, column, change[k]);
            }
        }
    }
}

Eigen::VectorXd OffsetMapping::offsets() const {
    Eigen::VectorXd offsets(attachments_.size());
    for (std::size_t i = 0; i < attachments_.size(); ++i) {
        offsets[i] = attachments_[i].zeta;
    }
    return offsets;
}

Eigen::MatrixXd OffsetMapping::apply(const Eigen::MatrixXd& values) const {
    return variation(Points::Zero(controlPoints_.rows(), 3), values);
}

Eigen::MatrixXd OffsetMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    return this->forces(Points::Zero(controlPoints_.rows(), 3), forces);
}

} // namespace tokay::mapper
