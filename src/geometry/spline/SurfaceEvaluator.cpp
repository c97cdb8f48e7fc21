// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/spline/SurfaceEvaluator.hpp"

#include <Eigen/Geometry>

namespace tokay::geometry {

namespace {

/// True if the parameter lies in the span, whose end belongs to the next one.
bool contains(const KnotVector& knots, int span, double xi) {
    return span >= 0 && knots.knots()[span] <= xi && xi < knots.knots()[span + 1];
}

} // namespace

SurfaceEvaluator::SurfaceEvaluator(const NurbsSurface& surface)
    : surface_(surface), Nu_(2, surface.u().degree() + 1), Nv_(2, surface.v().degree() + 1),
      N_(Nu_.cols() * Nv_.cols()) {
    controlPoints_.resize(N_.size());
    homogeneous_.resize(N_.size(), 4);
}

void SurfaceEvaluator::gather(int spanU, int spanV) {
    spanU_ = spanU;
    spanV_ = spanV;
    const int nU = surface_.u().nBasis();
    const int firstU = spanU - surface_.u().degree(), firstV = spanV - surface_.v().degree();
    for (int j = 0, k = 0; j < Nv_.cols(); ++j) {
        for (int i = 0; i < Nu_.cols(); ++i, ++k) {
            const int number = firstU + i + nU * (firstV + j);
            const double weight = surface_.isRational() ? surface_.weights()[number] : 1;
            controlPoints_[k] = number;
            homogeneous_.row(k) << weight * surface_.controlPoints().row(number), weight;
        }
    }
}

void SurfaceEvaluator::enter(const Parameters& place) {
    const KnotVector &u = surface_.u(), &v = surface_.v();
    if (contains(u, spanU_, place[0]) && contains(v, spanV_, place[1])) {
        return;
    }
    const int spanU = u.findSpan(place[0]), spanV = v.findSpan(place[1]);
    if (spanU != spanU_ || spanV != spanV_) {
        gather(spanU, spanV);
    }
}

void SurfaceEvaluator::moveTo(double xi, double eta) {
    enter({xi, eta});
    evaluate(xi, eta);
}

void SurfaceEvaluator::evaluate(double xi, double eta) {
    surface_.u().valuesAndSlopes(spanU_, xi, Nu_);
    surface_.v().valuesAndSlopes(spanV_, eta, Nv_);

    Eigen::RowVector4d sum = Eigen::RowVector4d::Zero(), byXi = sum, byEta = sum;
    for (int j = 0, k = 0; j < Nv_.cols(); ++j) {
        Eigen::RowVector4d row = Eigen::RowVector4d::Zero(), slope = row;
        for (int i = 0; i < Nu_.cols(); ++i, ++k) {
            row += Nu_(0, i) * homogeneous_.row(k);
            slope += Nu_(1, i) * homogeneous_.row(k);
            N_[k] = Nu_(0, i) * Nv_(0, j);
        }
        sum += Nv_(0, j) * row;
        byXi += Nv_(0, j) * slope;
        byEta += Nv_(1, j) * row;
    }
    point_ = sum.head<3>();
    tangentXi_ = byXi.head<3>();
    tangentEta_ = byEta.head<3>();
    if (!surface_.isRational()) {
        return;
    }
    const double w = sum[3];
    N_.array() *= homogeneous_.col(3).array() / w;
    point_ /= w;
    tangentXi_ = (tangentXi_ - byXi[3] * point_) / w;
    tangentEta_ = (tangentEta_ - byEta[3] * point_) / w;
}

double SurfaceEvaluator::jacobian() const {
    return tangentXi_.cross(tangentEta_).norm();
}

} // namespace tokay::geometry
