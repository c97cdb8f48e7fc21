// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/DirichletExtension.hpp"

#include "common/errors.hpp"
#include "geometry/quadrature/gaussLegendre.hpp"
#include "igaStructure/kinematics/shell/edges/EdgeTraction.hpp"
#include "igaStructure/kinematics/shell/edges/NodeUnion.hpp"
#include "igaStructure/kinematics/shell/egm/ExtensionFunctional.hpp"
#include "igaStructure/kinematics/shell/egm/FaceJump.hpp"
#include "igaStructure/kinematics/shell/egm/GradientTerm.hpp"
#include "igaStructure/kinematics/shell/egm/JumpChangeTerm.hpp"
#include "igaStructure/kinematics/shell/egm/StrongForm.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tokay::structure {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Size of an element in space.
double sizeOf(const ShellPatch& patch, int element) {
    const geometry::ParameterBox box = patch.patch().elementBox(element);
    const geometry::Points d = patch.surface().derivatives(box.centre()[0], box.centre()[1], 1);
    const Vector3d a1 = d.row(1), a2 = d.row(2);
    return std::sqrt(box.area() * a1.cross(a2).norm());
}

bool any(const std::array<bool, 3>& components) {
    return components[0] || components[1] || components[2];
}

std::array<bool, 3> either(const std::array<bool, 3>& a, const std::array<bool, 3>& b) {
    return {a[0] || b[0], a[1] || b[1], a[2] || b[2]};
}

// The strong form of bending takes fourth derivatives, which splines of degree 2 have none of.
bool hasStrongBending(const geometry::NurbsSurface& surface) {
    return std::min(surface.u().degree(), surface.v().degree()) >= 3;
}

PatchLocation seenFrom(const ShellPatch& patch, int element, const EdgePoint& point) {
    const int nU = patch.patch().nElementsU();
    return {patch, element % nU, element / nU, point.side.parameters, point.side.tangent};
}

} // namespace

DirichletExtension::DirichletExtension(const ShellDescription& description,
                                       const ShellPatches& patches,
                                       const std::vector<TrimmedSupport>& supports,
                                       const std::vector<bool>& fixed)
    : description_(description), patches_(patches),
      elements_(description, patches, supports, fixed),
      hasMotion_(std::any_of(supports.begin(), supports.end(), [](const TrimmedSupport& support) {
          return support.motion != nullptr;
      })) {
    ExtensionFunctional functional(static_cast<int>(fixed.size()), dependents());
    addTrace(functional);
    traceData_ = functional.dataMatrix();
    if (description.egm.continuation == EgmContinuation::gradient) {
        for (int face = 0; face < static_cast<int>(patches.size()); ++face) {
            GradientTerm(*patches[face], face, elements_).add(functional);
        }
    } else {
        addJumps(functional);
        if (residual() != EgmResidual::none) {
            addResiduals(functional);
        }
    }
    const SparseMatrix data = functional.dataMatrix();
    loadData_ = data.rightCols(data.cols() - traceData_.cols());
    factorise(functional);
    findMatrix(fixed);
}

DirichletExtension::~DirichletExtension() = default;

EgmResidual DirichletExtension::residual() const {
    return description_.egm.residual.value_or(
        description_.strains == Strains::linear ? EgmResidual::whole : EgmResidual::none);
}

double DirichletExtension::gamma(int face) const {
    const geometry::NurbsSurface& surface = patches_[face]->surface();
    const int degree = std::min(surface.u().degree(), surface.v().degree());
    return description_.egm.gamma.value_or(degree == 1 ? 0.5 : 0.01);
}

void DirichletExtension::addTrace(ExtensionFunctional& functional) const {
    for (const TracePoint& point : trace()) {
        const PatchLocation at =
            seenFrom(*patches_[point.support->trim.face], point.element, point.on);
        functional.add(at.nodes, point.support->fixed, at.N.row(0), point.on.weight,
                       functional.newData());
    }
    if (description_.bending) {
        for (const TracePoint& point : trace()) {
            addEdgeCondition(point, functional);
        }
    }
}

// The second condition of a plate, where the support holds its deflection.
void DirichletExtension::addEdgeCondition(const TracePoint& point,
                                          ExtensionFunctional& functional) const {
    const int face = point.support->trim.face;
    const PatchLocation at = seenFrom(*patches_[face], point.element, point.on);
    const Vector3d normal = at.normal();
    constexpr double inPlane = 1e-6;
    for (int c = 0; c < 3; ++c) {
        if (!point.support->fixed[c] && std::abs(normal[c]) > inPlane) {
            return;
        }
    }
    const double h = sizeOf(*patches_[face], point.element);
    if (point.support->clamped) {
        const RowVectorXd across = at.conormal().transpose() * at.N.bottomRows<2>();
        MatrixXd row(1, 3 * across.size());
        for (Index k = 0; k < across.size(); ++k) {
            row.block<1, 3>(0, 3 * k) = across[k] * normal.transpose();
        }
        functional.add(at.nodes, std::sqrt(point.on.weight) * h * row);
    } else {
        const double t = description_.thickness[face];
        const double stiffness =
            description_.materialOf(face).planeStressModulus() * t * t * t / 12;
        const EdgeTraction traction(at, point.element, true);
        functional.add(traction.nodes,
                       std::sqrt(point.on.weight) * h * h / stiffness * traction.moment);
    }
}

void DirichletExtension::addJumps(ExtensionFunctional& functional) const {
    for (int face = 0; face < static_cast<int>(patches_.size()); ++face) {
        addJumpsAlong(face, 0, functional);
        addJumpsAlong(face, 1, functional);
    }
}

// Faces across an axis: of element pairs next to each other along it. With the strong form of
// bending jumps that hold fourth derivatives shall not vanish, only not change.
void DirichletExtension::addJumpsAlong(int face, int axis, ExtensionFunctional& functional) const {
    const geometry::TrimmedPatch& patch = patches_[face]->patch();
    const bool keepsJumps = description_.bending && residual() != EgmResidual::none &&
                            hasFourthDerivativeInKnots(patches_[face]->surface(), axis);
    if (keepsJumps) {
        JumpChangeTerm(*patches_[face], face, axis, elements_, gamma(face)).add(functional);
    }
    for (int element = 0; element < patch.nElements(); ++element) {
        const int before = neighboursAlong(patch, element, axis)[0];
        if (before < 0 || !elements_.hasBody(face, element) ||
            (keepsJumps && FaceJump(*patches_[face], axis, {before, element}).isSmooth())) {
            continue;
        }
        addJump(face, axis, {before, element}, functional);
    }
}

// Jumps of those derivatives across the face that the basis lets jump.
void DirichletExtension::addJump(int face, int axis, const std::array<int, 2>& pair,
                                 ExtensionFunctional& functional) const {
    const auto components =
        either(elements_.dependsIn(face, pair[0]), elements_.dependsIn(face, pair[1]));
    if (!any(components)) {
        return;
    }
    const ShellPatch& patch = *patches_[face];
    const geometry::NurbsSurface& surface = patch.surface();
    const geometry::KnotVector& across = axis == 0 ? surface.u() : surface.v();
    const geometry::KnotVector& along = axis == 0 ? surface.v() : surface.u();
    const geometry::ParameterBox boxes[2] = {patch.patch().elementBox(pair[0]),
                                             patch.patch().elementBox(pair[1])};
    const double knot = boxes[1].lower[axis];
    const double size = 0.5 * (boxes[0].size()[axis] + boxes[1].size()[axis]);
    const int degree = across.degree();
    const auto& rule = geometry::gaussLegendre(along.degree() + 1);
    for (std::size_t g = 0; g < rule.points.size(); ++g) {
        geometry::Parameters at = boxes[1].lower + rule.points[g] * boxes[1].size();
        at[axis] = knot;
        NodeUnion nodes;
        MatrixXd jumps = MatrixXd::Zero(degree + 1, 2 * patch.nFunctions());
        geometry::Points X[2];
        for (int side = 0; side < 2; ++side) {
            const int nU = patch.patch().nElementsU();
            const geometry::SurfaceBasis basis = geometry::spanBasis(
                surface, surface.u().findSpan(surface.u().breakpoints()[pair[side] % nU]),
                surface.v().findSpan(surface.v().breakpoints()[pair[side] / nU]), at[0], at[1],
                degree);
            const auto places = nodes.add(elements_.nodes(face, pair[side]));
            for (int k = 0; k <= degree; ++k) {
                const int row =
                    axis == 0 ? geometry::derivativeRow(k, 0) : geometry::derivativeRow(0, k);
                for (std::size_t f = 0; f < places.size(); ++f) {
                    jumps(k, places[f]) +=
                        (side == 0 ? -1 : 1) * basis.N(row, static_cast<Index>(f));
                }
            }
            X[side] = basis.N.topRows(3) * surface.controlPoints()(basis.controlPoints, Eigen::all);
        }
        constexpr double smooth = 1e-9;
        if ((X[0].row(1 + axis) - X[1].row(1 + axis)).norm() > smooth * X[0].row(1 + axis).norm()) {
            return; // a kink of the surface or of its parameters: nothing goes on smoothly there
        }
        const double length =
            rule.weights[g] * boxes[1].size()[1 - axis] * X[0].row(2 - axis).norm();
        for (int k = degree - across.multiplicity(knot) + 1; k <= degree; ++k) {
            functional.add(nodes.nodes(), components, jumps.row(k).head(nodes.size()),
                           gamma(face) * std::pow(size, 2 * k) * length);
        }
    }
}

void DirichletExtension::addResiduals(ExtensionFunctional& functional) {
    for (int face = 0; face < static_cast<int>(patches_.size()); ++face) {
        for (int element = 0; element < patches_[face]->patch().nElements(); ++element) {
            if (elements_.hasBody(face, element) && any(elements_.dependsIn(face, element))) {
                addResidual(face, element, functional);
            }
        }
    }
}

namespace {

std::vector<geometry::ParameterPoint> pointsOf(const ShellPatch& patch, int element, bool whole) {
    std::vector<geometry::ParameterPoint> points;
    if (!whole && patch.patch().state(element) == geometry::ElementState::cut) {
        for (const ShellPatch::CutPoint& point : patch.cutPoints(element)) {
            points.push_back({point.xi, point.eta, point.weight});
        }
        return points;
    }
    const geometry::ParameterBox box = patch.patch().elementBox(element);
    const auto& u = geometry::gaussLegendre(patch.surface().u().degree() + 1);
    const auto& v = geometry::gaussLegendre(patch.surface().v().degree() + 1);
    for (std::size_t j = 0; j < v.points.size(); ++j) {
        for (std::size_t i = 0; i < u.points.size(); ++i) {
            points.push_back({box.lower[0] + u.points[i] * box.size()[0],
                              box.lower[1] + v.points[j] * box.size()[1],
                              u.weights[i] * v.weights[j] * box.area()});
        }
    }
    return points;
}

// Scales a residual to a displacement: along the surface and across it.
Matrix3d flexibility(const StrongForm& form, double h, bool across) {
    const Matrix3d normal = form.normal * form.normal.transpose();
    const double stiffness = across ? form.across(h) : 0;
    return (Matrix3d::Identity() - normal) / form.tangential(h) +
           (stiffness > 0 ? 1 / stiffness : 0) * normal;
}

} // namespace

void DirichletExtension::addResidual(int face, int element, ExtensionFunctional& functional) {
    const ShellPatch& patch = *patches_[face];
    const double h = sizeOf(patch, element);
    const auto points = pointsOf(patch, element, residual() == EgmResidual::whole);
    std::vector<int> nodes; // the same at all points
    MatrixXd all;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const StrongForm form(description_, face, patch, element, {points[k].xi, points[k].eta});
        nodes = form.nodes;
        all.conservativeResize(static_cast<Index>(3 * points.size()), form.L.cols());
        const double weight = std::sqrt(description_.egm.delta / h * points[k].weight * form.area);
        const Matrix3d scale =
            weight *
            flexibility(form, h, !description_.bending || hasStrongBending(patch.surface()));
        const MatrixXd rows = scale * form.L;
        all.middleRows(static_cast<Index>(3 * k), 3) = rows;
        functional.addData(nodes, rows, -scale, functional.newData());
        loads_.push_back({face, patch.massPerArea(), form.position, form.normal});
    }
    functional.add(nodes, all);
}

namespace {

// Its product with a matrix has the columns of some unknowns only.
SparseMatrix selection(const std::vector<int>& unknowns, Index n) {
    std::vector<Eigen::Triplet<double>> own;
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
        own.emplace_back(unknowns[k], static_cast<Index>(k), 1);
    }
    SparseMatrix select(n, static_cast<Index>(unknowns.size()));
    select.setFromTriplets(own.begin(), own.end());
    return select;
}

// The same, empty there.
SparseMatrix allBut(const std::vector<int>& unknowns, SparseMatrix matrix) {
    std::vector<bool> left(static_cast<std::size_t>(matrix.cols()), true);
    for (const int unknown : unknowns) {
        left[unknown] = false;
    }
    matrix.prune([&](Index, Index column, double) { return left[column]; });
    return matrix;
}

} // namespace

// The matrix of u_D, and what multiplies the unknowns that u_D follows: in the iterated form
// those of the last iterate.
void DirichletExtension::factorise(const ExtensionFunctional& functional) {
    const SparseMatrix squares = functional.matrix();
    const SparseMatrix lagged = functional.laggedMatrix();
    const SparseMatrix select = selection(dependents(), squares.cols());
    const bool isGeneral = isClosed() && lagged.nonZeros() > 0;
    const SparseMatrix inner =
        isGeneral ? SparseMatrix((squares + lagged) * select) : SparseMatrix(squares * select);
    coupling_ = isClosed() ? allBut(dependents(), squares + lagged)
                           : SparseMatrix(allBut(dependents(), squares) + lagged);
    const InputError undecided("supports: the elements that no supported curve cuts do not suffice "
                               "to extend the displacement from (edgeMethod egm): refine "
                               "discretisation.elements");
    solver_ = makeLinearSolver(inner, std::vector<bool>(dependents().size(), false),
                               isGeneral ? MatrixKind::general : MatrixKind::positiveDefinite);
    try {
        solver_->factorise(inner);
    } catch (const NotPositiveDefinite&) {
        throw undecided;
    } catch (const SingularMatrix&) {
        throw undecided;
    }
}

void DirichletExtension::findMatrix(const std::vector<bool>& fixed) {
    const auto n = static_cast<Index>(fixed.size());
    std::vector<bool> isFree(fixed.size());
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        isFree[k] = !fixed[k];
    }
    for (const int unknown : dependents()) {
        isFree[unknown] = false;
    }
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<int> columns; // free unknowns that dependents follow
    for (Index k = 0; k < n; ++k) {
        if (isFree[k]) {
            entries.emplace_back(k, k, 1);
            if (coupling_.outerIndexPtr()[k + 1] > coupling_.outerIndexPtr()[k]) {
                columns.push_back(static_cast<int>(k));
            }
        }
    }
    if (isClosed()) {
        addCombinations(columns, entries);
    }
    matrix_.resize(n, n);
    matrix_.setFromTriplets(entries.begin(), entries.end());
}

// T, some columns at a time: it is dense, but most of it is nothing.
void DirichletExtension::addCombinations(const std::vector<int>& columns,
                                         std::vector<Eigen::Triplet<double>>& entries) const {
    constexpr double negligible = 1e-14; // control values are of one size
    constexpr std::size_t together = 64;
    for (std::size_t from = 0; from < columns.size(); from += together) {
        const std::size_t count = std::min(together, columns.size() - from);
        MatrixXd right(coupling_.rows(), static_cast<Index>(count));
        for (std::size_t k = 0; k < count; ++k) {
            right.col(static_cast<Index>(k)) = -coupling_.col(columns[from + k]);
        }
        const MatrixXd T = solver_->solveAll(right);
        for (std::size_t k = 0; k < count; ++k) {
            for (Index row = 0; row < T.rows(); ++row) {
                const double value = T(row, static_cast<Index>(k));
                if (std::abs(value) > negligible) {
                    entries.emplace_back(dependents()[row], columns[from + k], value);
                }
            }
        }
    }
}

VectorXd DirichletExtension::spread(const VectorXd& dependent) const {
    VectorXd all = VectorXd::Zero(matrix_.rows());
    all(dependents()) = dependent;
    return all;
}

VectorXd DirichletExtension::loadData(double time) const {
    VectorXd data(3 * static_cast<Index>(loads_.size()));
    for (std::size_t k = 0; k < loads_.size(); ++k) {
        const Load& at = loads_[k];
        Vector3d sum = Vector3d::Zero();
        for (const ShellLoads::Traction& load : description_.loads.tractions) {
            if (load.face == at.face) {
                sum += load.traction.value(at.position, time);
            }
        }
        for (const ShellLoads::Pressure& load : description_.loads.pressures) {
            if (std::count(load.faces.begin(), load.faces.end(), at.face) > 0) {
                sum += load.pressure.value(at.position, time) * at.normal;
            }
        }
        for (const VectorField& gravity : description_.loads.gravities) {
            sum += at.massPerArea * gravity.value(at.position, time);
        }
        data.segment<3>(3 * static_cast<Index>(k)) = sum;
    }
    return data;
}

// Of the points of the curves, as supports move.
VectorXd DirichletExtension::motionData(double time) const {
    VectorXd data = VectorXd::Zero(3 * static_cast<Index>(trace().size()));
    for (std::size_t k = 0; k < trace().size(); ++k) {
        if (const SupportMotion& motion = trace()[k].support->motion) {
            data.segment<3>(3 * static_cast<Index>(k)) =
                motion->value(trace()[k].on.side.position, time);
        }
    }
    return data;
}

void DirichletExtension::own(const TracePoint& point, SupportOwners& owners) const {
    for (const int node : elements_.nodes(point.support->trim.face, point.element)) {
        for (int c = 0; c < 3; ++c) {
            const int unknown = 3 * node + c;
            if (point.support->fixed[c] && owners[unknown] < 0 &&
                std::binary_search(dependents().begin(), dependents().end(), unknown)) {
                owners[unknown] = point.support->number;
            }
        }
    }
}

VectorXd DirichletExtension::values(double time, const VectorXd& known) const {
    const VectorXd& data = latestData_.at(time, [&] { return dataAt(time); });
    return spread(solver_->solve(data - coupling_ * known));
}

// What loads and motions add to the equations of u_D.
VectorXd DirichletExtension::dataAt(double time) const {
    VectorXd data = loadData_ * loadData(time);
    if (hasMotion_) {
        data += traceData_ * motionData(time);
    }
    return data;
}

VectorXd DirichletExtension::ofTrace(const Eigen::Matrix3Xd& displacements) const {
    return spread(solver_->solve(traceData_ * displacements.reshaped()));
}

} // namespace tokay::structure
