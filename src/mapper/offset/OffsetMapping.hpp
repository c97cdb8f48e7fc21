// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/Mapping.hpp"
#include "mapper/RowSparseMatrix.hpp"
#include "mapper/interface/SplineInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"

namespace tokay::mapper {

/// Motion of points at a distance from a beam's axis or a shell's middle surface,
///   x = r + zeta a3 + c^alpha a_alpha,
/// with the current normal a3: points turn with their section, so the map is not
/// linear, and the load transfer is the transpose of its derivative at the current
/// state. Moments arrive as couples of control point forces; virtual work, sum and
/// moment of the forces are kept exactly. The tangential part c is zero but for
/// points beyond an end or an edge (the end face of a beam), or beside a beam's plane.
///
/// As a Mapping it is its derivative in the reference configuration; values have
/// three components.
class OffsetMapping : public Mapping {
  public:
    /// Points around a beam in a plane z = const; positive zeta lies left of xi.
    /// @param gapLimit  of the offsets, relative to the interface's size
    /// @throws InputError for a point beyond the limit or not finite
    OffsetMapping(const SplineInterface& axis, const Points& to,
                  const GapLimit& gapLimit = {0.1, true});

    /// Points around a shell; positive zeta lies on the side of a1 x a2.
    OffsetMapping(const SurfaceInterface& middle, const Points& to,
                  const GapLimit& gapLimit = {0.1, true});

    Points moved(const Points& displacements) const override;
    Points variation(const Points& displacements, const Points& variation) const override;
    Points forces(const Points& displacements, const Points& forces) const override;

    /// The derivative in the reference configuration as a matrix, of weighted sums of
    /// points; a point's components are next to each other.
    /// @param shares  weight of each point in each sum, nPoints x nSums
    /// @return        3 nSums x 3 nControlPoints
    RowSparseMatrix derivative(const RowSparseMatrix& shares) const;

    /// Distance of each point along the normal, with sign [m].
    Eigen::VectorXd offsets() const;

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override;
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override;

  private:
    /// A point and the functions at its projection.
    struct Attachment {
        std::size_t firstNumber;   ///< in numbers_
        std::size_t firstFunction; ///< in functions_
        int nFunctions;
        double zeta;
        Eigen::Vector2d tangential;
        Point reference; ///< where that is with no displacement
    };
    /// Base vectors at a projection.
    struct Frame {
        Point r, a1, a2, a3;
        double area;
    };

    /// Columns: functions, rows: their values and derivatives by xi and by eta (zero for a beam).
    Eigen::Map<const Eigen::Matrix3Xd> functions(const Attachment& attachment) const;
    int controlPoint(const Attachment& attachment, int function) const {
        return numbers_[attachment.firstNumber + function];
    }
    /// @param values  of the control points
    /// @return  rows: their value, derivatives by xi and by eta at the projection
    Eigen::Matrix3d atPoint(const Attachment& attachment, const Points& values) const;
    static Point position(const Attachment& attachment, const Frame& frame);
    Frame frameOf(const Attachment& attachment, const Points& controlPoints) const;
    /// Derivative of a point's position along variations of its projection's value and
    /// derivatives by xi and by eta, the rows of d.
    static Point positionVariation(const Attachment& attachment, const Frame& frame,
                                   const Eigen::Matrix3d& d);
    /// Rows: what is work-conjugate to r, a1 and a2, of a force on the point.
    static Eigen::Matrix3d conjugateForces(const Attachment& attachment, const Frame& frame,
                                           const Point& f);
    /// Appends a point's derivative, times a weight, from 3 row on.
    void appendDerivative(const Attachment& attachment, const Frame& frame, double weight,
                          Eigen::Index row, std::vector<Eigen::Triplet<double>>& entries) const;
    void attach(const Point& point, const std::vector<int>& controlPoints,
                const Eigen::Matrix3Xd& N);
    void finish(const GapStatistics& gaps, const Points& to);

    bool isBeam_;
    Points controlPoints_;
    std::vector<Attachment> attachments_;
    /// Numbers of control points, which neighbours in an element share, and functions: next to
    /// each other, as an exchange reads all of them.
    std::vector<int> numbers_;
    std::vector<double> functions_;
};

} // namespace tokay::mapper
