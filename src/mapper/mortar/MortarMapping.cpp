// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/mortar/MortarMapping.hpp"

#include "common/errors.hpp"
#include "geometry/spline/SurfaceEvaluator.hpp"
#include "geometry/trimming/elementQuadrature.hpp"
#include "mapper/Stopwatch.hpp"
#include "mapper/conservation.hpp"
#include "mapper/intersection/SplineFacets.hpp"
#include "mapper/intersection/curveIntersection.hpp"
#include "mapper/intersection/meshIntersection.hpp"
#include "mapper/intersection/patchIntersection.hpp"

#include <fmt/format.h>

namespace tokay::mapper {

namespace {

int quadratureDegree(const SurfaceInterface& splines, const MortarOptions& options) {
    if (options.patchQuadratureDegree > 0) {
        return options.patchQuadratureDegree;
    }
    int degree = 1;
    for (int i = 0; i < splines.nPieces(); ++i) {
        const geometry::NurbsSurface& surface = splines.piece(i).patch.basis();
        degree = std::max(degree, surface.u().degree() + surface.v().degree());
    }
    return degree;
}

/// Area of the patches, and their functions, whether a face reaches them or not.
double markPatches(const SurfaceInterface& splines, int degree, MortarAssembler& assembler) {
    double area = 0;
    for (int i = 0; i < splines.nPieces(); ++i) {
        const geometry::TrimmedPatch& patch = splines.piece(i).patch;
        geometry::SurfaceEvaluator surface(patch.basis());
        for (int element = 0; element < patch.nElements(); ++element) {
            for (const auto& at : elementQuadrature(patch, element, degree)) {
                surface.moveTo(at.xi, at.eta);
                area += at.weight * surface.jacobian();
                for (const int number : surface.controlPoints()) {
                    assembler.addUnmatched(splines.piece(i).controlPoints[number]);
                }
            }
        }
    }
    return area;
}

void integrateIntersection(const SurfaceMesh& from, const SurfaceInterface& to,
                           const MortarOptions& options, MortarAssembler& assembler,
                           GapStatistics& gaps) {
    const int degree = quadratureDegree(to, options);
    double covered = 0;
    Functions onMesh;
    IntersectionVisitor visitor;
    visitor.point = [&](const IntersectionPoint& at) {
        covered += at.weight;
        if (!gaps.count(at.position, at.gap, true, false, at.weight)) {
            return;
        }
        from.evaluate(at.triangle, at.inTriangle, onMesh);
        assembler.add(at.weight, at.onPatch, onMesh, at.element);
    };
    visitor.endTriangle = [&](int triangle, double) {
        if (triangle + 1 == from.nTriangles() ||
            from.faceOf(triangle + 1) != from.faceOf(triangle)) {
            assembler.endGroup();
        }
    };
    intersect(from, to, options.gapLimit.relative * from.size(), degree, visitor);
    const double area = markPatches(to, degree, assembler);
    if (covered < (1 - 1e-9) * area) {
        gaps.countUncovered(area - covered);
    }
}

void integrateIntersection(const SurfaceInterface& from, const SurfaceMesh& to,
                           const MortarOptions& options, MortarAssembler& assembler,
                           GapStatistics& gaps) {
    Functions onMesh;
    IntersectionVisitor visitor;
    visitor.point = [&](const IntersectionPoint& at) {
        to.evaluate(at.triangle, at.inTriangle, onMesh);
        if (gaps.count(at.position, at.gap, true, false, at.weight)) {
            assembler.add(at.weight, onMesh, at.onPatch);
        } else {
            assembler.addUnmatched(onMesh.values);
        }
    };
    visitor.endTriangle = [&](int triangle, double coveredShare) {
        if (coveredShare < 1 - 1e-9) {
            gaps.countUncovered((1 - coveredShare) * to.triangle(triangle).area());
            assembler.addUnmatched(
                to.functions(triangle, geometry::Barycentric::Constant(1.0 / 3)).values);
        }
        if (triangle + 1 == to.nTriangles() || to.faceOf(triangle + 1) != to.faceOf(triangle)) {
            assembler.endGroup();
        }
    };
    intersect(to, from, options.gapLimit.relative * from.size(), quadratureDegree(from, options),
              visitor);
}

/// Chord tolerance of the triangles that stand for the source's knot spans. It moves the lines
/// where the source is less smooth, which costs no order.
constexpr double facetTolerance = 1e-3;

void integrateIntersection(const SurfaceInterface& from, const SurfaceInterface& to,
                           const MortarOptions& options, MortarAssembler& assembler,
                           GapStatistics& gaps) {
    const int degree = std::max(quadratureDegree(from, options), quadratureDegree(to, options));
    const SplineFacets facets = splineFacets(from, facetTolerance);
    double covered = 0;
    IntersectionVisitor visitor;
    visitor.point = [&](const IntersectionPoint& at) {
        covered += at.weight;
        const int piece = facets.pieces[at.triangle];
        const geometry::SurfaceProjection source = from.projector(piece).closest(at.position);
        if (gaps.count(at.position, source.distance, source.converged, source.ambiguous,
                       at.weight)) {
            assembler.add(at.weight, at.onPatch, from.functions(piece, source.xi, source.eta),
                          at.element);
        }
    };
    visitor.endTriangle = [&](int, double) { assembler.endGroup(); };
    intersect(facets.mesh, to, options.gapLimit.relative * from.size(), degree, visitor);
    const double area = markPatches(to, degree, assembler);
    if (covered < (1 - 1e-9) * area) {
        gaps.countUncovered(area - covered);
    }
}

RowSparseMatrix sparseDiagonal(const Eigen::VectorXd& diagonal) {
    RowSparseMatrix matrix(diagonal.size(), diagonal.size());
    for (Eigen::Index i = 0; i < diagonal.size(); ++i) {
        if (diagonal[i] != 0) {
            matrix.insert(i, i) = diagonal[i];
        }
    }
    return matrix;
}

/// The gradient term if it is the choice.
template <class From, class To>
GradientTerm chosenTerm(const From& from, const To& to, const MortarOptions& options) {
    return options.singular == SingularMass::gradientTerm ? gradientTerm(from, to) : GradientTerm();
}

void refuseDualBasis(const MortarOptions& options) {
    if (options.basis == MortarBasis::dual) {
        throw InputError("there is no dual basis for splines on patches: choose the "
                         "standard mortar basis");
    }
}

} // namespace

template <class From, class To, class Integrate>
void MortarMapping::build(const From& from, const To& to, const MortarOptions& options,
                          MortarAssembler assembler, Integrate integrate,
                          GradientTerm gradientTerm) {
    const Stopwatch watch;
    GapStatistics gaps(options.gapLimit, from.size());
    integrate(assembler, gaps);
    gaps.enter(report_);
    slopes_ = std::move(gradientTerm.slopes);
    finish(assembler, options, from, to, gradientTerm.energy);
    report_.seconds = watch.seconds();
}

MortarMapping::MortarMapping(const CurveInterface& from, const CurveInterface& to,
                             const MortarOptions& options) {
    build(
        from, to, options, {to.nValues(), from.nValues(), options.basis},
        [&](MortarAssembler& assembler, GapStatistics& gaps) {
            integrateIntersection(from, to, options.gapLimit, options.nExtraPoints, assembler,
                                  gaps);
        },
        chosenTerm(from, to, options));
}

MortarMapping::MortarMapping(const SurfaceMesh& from, const SurfaceMesh& to,
                             const MortarOptions& options) {
    build(from, to, options, {to.nValues(), from.nValues(), options.basis},
          [&](MortarAssembler& assembler, GapStatistics& gaps) {
              integrateIntersection(from, to, options.gapLimit, assembler, gaps);
          });
}

MortarMapping::MortarMapping(const SurfaceMesh& from, const SurfaceInterface& to,
                             const MortarOptions& options) {
    refuseDualBasis(options);
    build(
        from, to, options, {to.nValues(), from.nValues(), options.basis, to.nElements()},
        [&](MortarAssembler& assembler, GapStatistics& gaps) {
            integrateIntersection(from, to, options, assembler, gaps);
        },
        chosenTerm(from, to, options));
}

MortarMapping::MortarMapping(const SurfaceInterface& from, const SurfaceMesh& to,
                             const MortarOptions& options) {
    build(from, to, options, {to.nValues(), from.nValues(), options.basis},
          [&](MortarAssembler& assembler, GapStatistics& gaps) {
              integrateIntersection(from, to, options, assembler, gaps);
          });
}

MortarMapping::MortarMapping(const SurfaceInterface& from, const SurfaceInterface& to,
                             const MortarOptions& options) {
    refuseDualBasis(options);
    build(
        from, to, options, {to.nValues(), from.nValues(), options.basis, to.nElements()},
        [&](MortarAssembler& assembler, GapStatistics& gaps) {
            integrateIntersection(from, to, options, assembler, gaps);
        },
        chosenTerm(from, to, options));
}

// With the given values g = P phi_O on the right-hand side the matrix stays symmetric:
// M_ff phi_f = (M_fO - M_fg P) phi_O beside D_gg phi_g = D_gg P phi_O.
void MortarMapping::interpolate(const std::vector<int>& values, const Discretisation& from,
                                const Discretisation& to) {
    Eigen::VectorXd interpolated = Eigen::VectorXd::Zero(to.nValues());
    std::vector<Eigen::Triplet<double>> entries;
    for (const int value : values) {
        interpolated[value] = 1;
        const Functions there = from.locate(to.coordinates().row(value));
        for (std::size_t j = 0; j < there.values.size(); ++j) {
            entries.emplace_back(value, there.values[j], there.weights[j]);
        }
    }
    RowSparseMatrix interpolation(cross_.rows(), cross_.cols());
    interpolation.setFromTriplets(entries.begin(), entries.end());

    const Eigen::VectorXd given = mass_.diagonal().cwiseProduct(interpolated);
    const RowSparseMatrix toFree =
                              sparseDiagonal(Eigen::VectorXd::Ones(to.nValues()) - interpolated),
                          toGiven = sparseDiagonal(given);
    const RowSparseMatrix ofGiven = mass_ * interpolation;
    const RowSparseMatrix projected = cross_ - ofGiven;
    const RowSparseMatrix freeCross = toFree * projected, givenCross = toGiven * interpolation;
    cross_ = freeCross + givenCross;
    const RowSparseMatrix freeRows = toFree * mass_;
    const RowSparseMatrix freeMass = (freeRows * toFree).pruned();
    mass_ = freeMass + toGiven;
}

void MortarMapping::finish(MortarAssembler& assembler, const MortarOptions& options,
                           const Discretisation& from, const Discretisation& to,
                           const RowSparseMatrix& gradientTerm) {
    report_.method = options.basis == MortarBasis::dual ? "mortar, dual basis" : "mortar";
    mass_ = assembler.takeMass();
    cross_ = assembler.takeCross();
    if (!options.interpolated.empty()) {
        interpolate(options.interpolated, from, to);
        report_.method +=
            fmt::format(", {} values on the rim interpolated", options.interpolated.size());
    }
    inverse_.emplace(mass_, options.singular, gradientTerm);
    report_.nUncovered = assembler.nUncovered(mass_);
    report_.nInverted = inverse_->nActive();
    report_.rank = inverse_->rank();
    report_.condition = inverse_->conditionOnRange();
    if (inverse_->isSingular()) {
        report_.regularisation = options.singular != SingularMass::gradientTerm ? "minimum norm"
                                 : slopes_.nonZeros() > 0 ? "gradient term with the source's slope"
                                                          : "gradient term";
    }

    // A singular mass matrix leaves values open, but not the field: errors are
    // measured in the field, by test tractions.
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(to.nValues());
    const Eigen::VectorXd mapped = apply(Eigen::VectorXd::Ones(from.nValues()));
    report_.rowSumError = (mass_ * (mapped - ones)).norm() / (mass_ * ones).norm();
    const Points forces = mass_ * probeForces(to.nValues());
    measureConservation(*this, forces, from.coordinates(), to.coordinates(), report_);
    report_.bytes = bytesOf(mass_) + bytesOf(cross_) + bytesOf(slopes_);
}

Eigen::MatrixXd MortarMapping::apply(const Eigen::MatrixXd& values) const {
    return slopes_.size() > 0 ? inverse_->solve(cross_ * values, slopes_ * values)
                              : inverse_->solve(cross_ * values);
}

Eigen::MatrixXd MortarMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    const TransposedSolution solved = inverse_->solveTransposed(forces);
    Eigen::MatrixXd onSource = cross_.transpose() * solved.trace;
    if (solved.slopes.size() > 0) {
        onSource += slopes_.transpose() * solved.slopes;
    }
    return onSource;
}

} // namespace tokay::mapper
