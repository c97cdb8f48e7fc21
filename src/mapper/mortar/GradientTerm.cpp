// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/GradientTerm.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"
#include "mapper/interface/normalSlopes.hpp"

#include <Eigen/Geometry>

#include <functional>

namespace tokay::mapper {

namespace {

/// Functions' derivatives along a direction at a place [1/m].
using Slope = std::function<Functions(const Point& place, const Point& direction)>;

class TermSum {
  public:
    /// @param to, from  derivatives of both sides' functions along one direction
    void add(double measure, const Functions& to, const Functions& from) {
        add(measure, to, to, energy_);
        add(measure, to, from, slopes_);
    }

    GradientTerm finish(int nTo, int nFrom) const {
        GradientTerm term{RowSparseMatrix(nTo, nTo), RowSparseMatrix(nTo, nFrom)};
        term.energy.setFromTriplets(energy_.begin(), energy_.end());
        term.slopes.setFromTriplets(slopes_.begin(), slopes_.end());
        return term;
    }

  private:
    using Entries = std::vector<Eigen::Triplet<double>>;

    static void add(double measure, const Functions& rows, const Functions& columns,
                    Entries& entries) {
        for (std::size_t k = 0; k < rows.values.size(); ++k) {
            for (std::size_t l = 0; l < columns.values.size(); ++l) {
                entries.emplace_back(rows.values[k], columns.values[l],
                                     measure * rows.weights[static_cast<Eigen::Index>(k)] *
                                         columns.weights[static_cast<Eigen::Index>(l)]);
            }
        }
    }

    Entries energy_, slopes_;
};

Functions slopeOf(const SurfacePiece& piece, double xi, double eta, const Point& direction) {
    Functions slope = directionalDerivative(piece.patch.basis(), xi, eta, direction);
    for (int& number : slope.values) {
        number = piece.controlPoints[static_cast<std::size_t>(number)];
    }
    return slope;
}

void addElement(const SurfacePiece& piece, const geometry::ParameterBox& box, const Slope& ofSource,
                TermSum& sum) {
    const geometry::NurbsSurface& surface = piece.patch.basis();
    const auto& alongU = geometry::gaussLegendre(surface.u().degree() + 1);
    const auto& alongV = geometry::gaussLegendre(surface.v().degree() + 1);
    for (std::size_t j = 0; j < alongV.points.size(); ++j) {
        for (std::size_t i = 0; i < alongU.points.size(); ++i) {
            const double xi = box.lower[0] + alongU.points[i] * box.size()[0];
            const double eta = box.lower[1] + alongV.points[j] * box.size()[1];
            const Points d = surface.derivatives(xi, eta, 1);
            const Point area = Point(d.row(1)).cross(Point(d.row(2)));
            const double measure = alongU.weights[i] * alongV.weights[j] * box.area() * area.norm();
            const Point first = Point(d.row(1)).normalized();
            for (const Point& direction : {first, Point(area.normalized().cross(first))}) {
                sum.add(measure, slopeOf(piece, xi, eta, direction), ofSource(d.row(0), direction));
            }
        }
    }
}

GradientTerm termOfPatches(const SurfaceInterface& to, int nFrom, const Slope& ofSource) {
    TermSum sum;
    for (int i = 0; i < to.nPieces(); ++i) {
        const geometry::TrimmedPatch& patch = to.piece(i).patch;
        for (const int element : patch.elements(geometry::ElementState::cut)) {
            addElement(to.piece(i), patch.elementBox(element), ofSource, sum);
        }
    }
    return sum.finish(to.nValues(), nFrom);
}

} // namespace

GradientTerm gradientTerm(const CurveInterface& from, const CurveInterface& to) {
    TermSum sum;
    for (int i = 0; i < to.nCurves(); ++i) {
        for (const NormalSlope& at : to.curve(i).normalSlopes()) {
            const CurveInterface::Projection source = from.closest(at.foot);
            sum.add(at.measure, at, from.curve(source.piece).slope(source.onCurve.xi, at.normal));
        }
    }
    return sum.finish(to.nValues(), from.nValues());
}

GradientTerm gradientTerm(const SurfaceInterface& from, const SurfaceInterface& to) {
    return termOfPatches(to, from.nValues(), [&](const Point& place, const Point& direction) {
        const SurfaceInterface::Projection source = from.closest(place);
        return slopeOf(from.piece(source.piece), source.onSurface.xi, source.onSurface.eta,
                       direction);
    });
}

GradientTerm gradientTerm(const SurfaceMesh& from, const SurfaceInterface& to) {
    return termOfPatches(to, from.nValues(),
                         [](const Point&, const Point&) { return Functions(); });
}

} // namespace tokay::mapper
