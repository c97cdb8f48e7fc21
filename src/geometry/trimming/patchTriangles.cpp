// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/trimming/patchTriangles.hpp"

#include "common/errors.hpp"
#include "geometry/bezier/bezierPieces.hpp"
#include "geometry/quadrature/polygonRegion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace tokay::geometry {

namespace {

constexpr int mostDivisions = 512;

int divisions(double bend, double tolerance) {
    // A part's sag falls with the square of its length.
    const double n = std::ceil(std::sqrt(bend / tolerance));
    return static_cast<int>(std::clamp(n, 1.0, static_cast<double>(mostDivisions)));
}

/// Largest distance of control points from an evenly parametrised chord, and
/// twist of the cells between them.
struct Bends {
    double u = 0, v = 0, twist = 0;
};

Bends bendsOf(const NurbsSurface& piece) {
    const int p = piece.u().degree(), q = piece.v().degree();
    const auto at = [&](int i, int j) -> Point {
        return piece.controlPoints().row(i + (p + 1) * j);
    };
    Bends bends;
    for (int j = 0; j <= q; ++j) {
        for (int i = 0; i <= p; ++i) {
            const double s = static_cast<double>(i) / p, t = static_cast<double>(j) / q;
            bends.u = std::max(bends.u, (at(i, j) - (1 - s) * at(0, j) - s * at(p, j)).norm());
            bends.v = std::max(bends.v, (at(i, j) - (1 - t) * at(i, 0) - t * at(i, q)).norm());
        }
    }
    bends.twist = 0.25 * (at(0, 0) - at(p, 0) - at(0, q) + at(p, q)).norm();
    return bends;
}

/// Grid lines of a direction: knot lines and what lies between.
std::vector<double> lines(const KnotVector& knots, const std::vector<int>& parts) {
    std::vector<double> result = {knots.first()};
    for (int i = 0; i < knots.nSpans(); ++i) {
        const double from = knots.breakpoints()[i], to = knots.breakpoints()[i + 1];
        for (int k = 1; k < parts[i]; ++k) {
            result.push_back(from + (to - from) * k / parts[i]);
        }
        result.push_back(to);
    }
    return result;
}

class Triangulation {
  public:
    Triangulation(const TrimmedPatch& patch, double tolerance)
        : patch_(patch), tolerance_(tolerance), grid_(gridFor(patch, tolerance)) {}

    PatchTriangles run() {
        const Region loops =
            patch_.isTrimmed() ? patch_.tessellatedLoops(loopTolerance()) : Region{};
        for (int j = 0; j < grid_.nV(); ++j) {
            ParameterBox row = grid_.box(j * grid_.nU());
            row.upper[0] = grid_.box().upper[0];
            const Region inRow = isCutRow(row) ? intersection(loops, row) : Region{};
            for (int i = 0; i < grid_.nU(); ++i) {
                appendCell(grid_.box(i + j * grid_.nU()), inRow);
            }
        }
        result_.points.resize(result_.parameters.size(), 3);
        for (std::size_t i = 0; i < result_.parameters.size(); ++i) {
            result_.points.row(i) =
                patch_.surface().point(result_.parameters[i][0], result_.parameters[i][1]);
        }
        return std::move(result_);
    }

  private:
    static ElementGrid gridFor(const TrimmedPatch& patch, double tolerance) {
        const NurbsSurface& basis = patch.basis();
        const int nU = basis.u().nSpans(), nV = basis.v().nSpans();
        std::vector<int> partsU(nU, 1), partsV(nV, 1);
        const std::vector<NurbsSurface> pieces = bezierPieces(basis);
        for (int element = 0; element < nU * nV; ++element) {
            const Bends bends = bendsOf(pieces[element]);
            int &inU = partsU[element % nU], &inV = partsV[element / nU];
            inU = std::max({inU, divisions(bends.u, tolerance), divisions(bends.twist, tolerance)});
            inV = std::max({inV, divisions(bends.v, tolerance), divisions(bends.twist, tolerance)});
        }
        return ElementGrid(lines(basis.u(), partsU), lines(basis.v(), partsV));
    }

    /// The chord tolerance in parameters, by the largest tangents.
    Parameters loopTolerance() const {
        Parameters speed = Parameters::Constant(0);
        for (int element = 0; element < patch_.nElements(); ++element) {
            const Parameters at = patch_.elementBox(element).centre();
            const Points d = patch_.surface().derivatives(at[0], at[1], 1);
            speed = speed.cwiseMax(Parameters(d.row(1).norm(), d.row(2).norm()));
        }
        return tolerance_ * speed.cwiseMax(tolerance_ / mostDivisions).cwiseInverse();
    }

    bool isCutRow(const ParameterBox& row) const {
        const int first = patch_.elementAt({patch_.box().lower[0], row.centre()[1]});
        for (int i = 0; i < patch_.nElementsU(); ++i) {
            if (patch_.state(first + i) == ElementState::cut) {
                return true;
            }
        }
        return false;
    }

    void appendCell(const ParameterBox& cell, const Region& inRow) {
        const int element = patch_.elementAt(cell.centre());
        if (patch_.state(element) == ElementState::empty) {
            return;
        }
        const Polygon corners = {
            cell.lower, {cell.upper[0], cell.lower[1]}, cell.upper, {cell.lower[0], cell.upper[1]}};
        const Region region = patch_.state(element) == ElementState::full
                                  ? Region{corners}
                                  : intersection(inRow, cell);
        for (const PlaneTriangle& triangle : triangulated(region)) {
            const std::array<int, 3> numbers = {number(triangle[0]), number(triangle[1]),
                                                number(triangle[2])};
            if (numbers[0] == numbers[1] || numbers[1] == numbers[2] || numbers[2] == numbers[0]) {
                continue;
            }
            result_.triangles.push_back(numbers);
            result_.elements.push_back(element);
        }
    }

    /// Corners that two cells compute, each with its own rounding, are one.
    int number(const Parameters& at) {
        const Parameters steps = (at - grid_.box().lower).cwiseQuotient(1e-10 * grid_.box().size());
        const std::int64_t i = std::llround(steps[0]), j = std::llround(steps[1]);
        for (std::int64_t k = i - 1; k <= i + 1; ++k) {
            for (std::int64_t l = j - 1; l <= j + 1; ++l) {
                if (const auto found = numbers_.find({k, l}); found != numbers_.end()) {
                    return found->second;
                }
            }
        }
        const int fresh = static_cast<int>(result_.parameters.size());
        numbers_[{i, j}] = fresh;
        result_.parameters.push_back(at);
        return fresh;
    }

    const TrimmedPatch& patch_;
    double tolerance_;
    ElementGrid grid_;
    std::map<std::pair<std::int64_t, std::int64_t>, int> numbers_;
    PatchTriangles result_;
};

} // namespace

PatchTriangles patchTriangles(const TrimmedPatch& patch, double chordTolerance) {
    if (!(chordTolerance > 0)) {
        throw InputError(
            fmt::format("the chord tolerance is {}: it must be positive", chordTolerance));
    }
    return Triangulation(patch, chordTolerance).run();
}

} // namespace tokay::geometry
