// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/nearest/SplineSamples.hpp"

namespace tokay::mapper {

namespace {

class SampleList {
  public:
    explicit SampleList(double size) : least_(1e-9 * size) {}

    void add(const Point& point, const Functions& functions) {
        for (const Point& other : points_) {
            if ((other - point).norm() <= least_) {
                return;
            }
        }
        const int row = static_cast<int>(points_.size());
        points_.push_back(point);
        for (std::size_t k = 0; k < functions.values.size(); ++k) {
            entries_.emplace_back(row, functions.values[k], functions.weights[k]);
        }
    }

    SplineSamples finish(int nControlPoints) const {
        const auto n = static_cast<Eigen::Index>(points_.size());
        SplineSamples samples{Points(n, 3), RowSparseMatrix(n, nControlPoints)};
        for (Eigen::Index i = 0; i < n; ++i) {
            samples.points.row(i) = points_[i];
        }
        samples.functions.setFromTriplets(entries_.begin(), entries_.end());
        return samples;
    }

  private:
    double least_;
    std::vector<Point> points_;
    std::vector<Eigen::Triplet<double>> entries_;
};

} // namespace

SplineSamples splineSamples(const SplineInterface& splines) {
    SampleList list(splines.size());
    for (int i = 0; i < splines.nCurves(); ++i) {
        for (const double xi : splines.pieces()[i].curve.knotVector().grevilleAbscissae()) {
            list.add(splines.curve(i).derivatives(xi, 0).row(0), splines.curve(i).functions(xi));
        }
    }
    return list.finish(splines.nValues());
}

SplineSamples splineSamples(const SurfaceInterface& splines) {
    SampleList list(splines.size());
    for (int i = 0; i < splines.nPieces(); ++i) {
        const geometry::TrimmedPatch& patch = splines.piece(i).patch;
        for (const double eta : patch.basis().v().grevilleAbscissae()) {
            for (const double xi : patch.basis().u().grevilleAbscissae()) {
                if (!patch.isTrimmed() || patch.contains({xi, eta})) {
                    list.add(patch.basis().point(xi, eta), splines.functions(i, xi, eta));
                }
            }
        }
    }
    return list.finish(splines.nValues());
}

} // namespace tokay::mapper
