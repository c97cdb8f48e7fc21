#include "igaStructure/model/PlaneLine.hpp"

#include "common/errors.hpp"
#include "igaStructure/model/Supports.hpp"

#include <fmt/format.h>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::vector<int> firstFunctions(const geometry::NurbsCurve& curve) {
    std::vector<int> first;
    for (int element = 0; element < curve.knotVector().nSpans(); ++element) {
        first.push_back(curve.knotVector().findSpan(curve.knotVector().breakpoints()[element]) -
                        curve.degree());
    }
    return first;
}

// Derivatives (x', x'') of the line by the control points of an element: 4 rows.
MatrixXd derivativeRows(const LinePoint& point) {
    MatrixXd rows = MatrixXd::Zero(4, 2 * point.N.cols());
    for (int a = 0; a < point.N.cols(); ++a) {
        for (int c = 0; c < 2; ++c) {
            rows(c, 2 * a + c) = point.N(1, a);
            rows(2 + c, 2 * a + c) = point.N(2, a);
        }
    }
    return rows;
}

} // namespace

PlaneLine::PlaneLine(geometry::NurbsCurve curve, const LineSection& section, Strains strains,
                     const std::vector<LineSupport>& supports, LineLoads loads)
    : curve_(std::move(curve)), section_(section), strains_(strains),
      points_(linePoints(curve_, curve_.degree() + 1)), frames_(curve_, supports),
      pattern_(curve_.nControlPoints(), curve_.degree(), firstFunctions(curve_)),
      force_(curve_, section, std::move(loads)) {
    requireUsable();
}

void PlaneLine::requireUsable() const {
    if (!curve_.controlPoints().col(2).isZero(0)) {
        throw InputError("a beam or cable must lie in z = 0, but a control point has another z");
    }
    if (!section_.bends()) {
        return;
    }
    if (curve_.degree() < 2) {
        throw InputError("a beam bends only with functions of degree 2 or more, but has degree 1");
    }
    for (double knot : curve_.knotVector().breakpoints()) {
        const bool isInner =
            knot != curve_.knotVector().first() && knot != curve_.knotVector().last();
        if (isInner && curve_.knotVector().multiplicity(knot) >= curve_.degree()) {
            const geometry::Point at = curve_.point(knot);
            throw InputError(fmt::format(
                "the basis has a hinge at x = {:.6g}, y = {:.6g} (knot {:g} is repeated {} times, "
                "the degree is {}): a beam needs a curve whose tangent is continuous in its "
                "parameter; an arc may reach over a quarter turn",
                at[0], at[1], knot, curve_.knotVector().multiplicity(knot), curve_.degree()));
        }
    }
}

double PlaneLine::normalForce(const LineStrain& strain) const {
    return section_.prestress + section_.axialStiffness * strain.axial;
}

double PlaneLine::bendingMoment(const LineStrain& strain) const {
    return section_.bends() ? section_.bendingStiffness * strain.curvature : 0;
}

SparseMatrix PlaneLine::lumpedMassMatrix() const {
    VectorXd masses = VectorXd::Zero(nUnknowns());
    for (const LinePoint& point : points_) {
        for (int a = 0; a < point.N.cols(); ++a) {
            masses.segment<2>(2 * (point.first + a)).array() +=
                section_.mass * point.length * point.N(0, a);
        }
    }
    return frames_.matrix(SparseMatrix(masses.asDiagonal()));
}

// Work-conjugate to the derivatives of the position, per length.
Eigen::Vector4d PlaneLine::conjugate(const LineStrain& strain,
                                     const LineDerivatives& displacement) const {
    if (!isLinear()) {
        return normalForce(strain) * strain.axialGradient +
               bendingMoment(strain) * strain.curvatureGradient;
    }
    Eigen::Vector4d u;
    u << displacement.first, displacement.second;
    return stiffness(strain) * u;
}

Eigen::Matrix4d PlaneLine::stiffness(const LineStrain& strain) const {
    const double axialForce = isLinear() ? section_.prestress : normalForce(strain);
    return section_.axialStiffness * strain.axialGradient * strain.axialGradient.transpose() +
           section_.bendingStiffness * strain.curvatureGradient *
               strain.curvatureGradient.transpose() +
           axialForce * strain.axialHessian + bendingMoment(strain) * strain.curvatureHessian;
}

SparseMatrix PlaneLine::massMatrix() const {
    SparseMatrix mass = pattern_.zeroMatrix();
    const int n = 2 * (curve_.degree() + 1);
    for (const LinePoint& point : points_) {
        MatrixXd element = MatrixXd::Zero(n, n);
        const MatrixXd scalar =
            section_.mass * point.length * point.N.row(0).transpose() * point.N.row(0);
        for (int b = 0; b < scalar.cols(); ++b) {
            for (int a = 0; a < scalar.rows(); ++a) {
                element(2 * a, 2 * b) = element(2 * a + 1, 2 * b + 1) = scalar(a, b);
            }
        }
        const Eigen::Vector2d& tangent = point.position.first;
        const VectorXd angle =
            derivativeRows(point).topRows(2).transpose() * turned(tangent) / tangent.squaredNorm();
        element += section_.rotaryInertia * point.length * angle * angle.transpose();
        pattern_.add(point.element, element, mass);
    }
    return frames_.matrix(mass);
}

StructuralModel::Internal PlaneLine::internalForce(const VectorXd& displacement) const {
    const VectorXd ofControlPoints = frames_.displacements(displacement);
    VectorXd force = VectorXd::Zero(nUnknowns());
    for (const LinePoint& point : points_) {
        const LineDerivatives u = point.derivatives(ofControlPoints);
        const LineStrain strain(point.position, u, strains_);
        force.segment(2 * point.first, 2 * point.N.cols()) +=
            point.length * derivativeRows(point).transpose() * conjugate(strain, u);
    }
    return {frames_.forces(force), 1};
}

StructuralModel::Internal PlaneLine::internalForce(const VectorXd& displacement,
                                                   SparseMatrix& tangent) const {
    const VectorXd ofControlPoints = frames_.displacements(displacement);
    SparseMatrix sum = pattern_.zeroMatrix();
    for (const LinePoint& point : points_) {
        const LineStrain strain(point.position, point.derivatives(ofControlPoints), strains_);
        const MatrixXd rows = derivativeRows(point);
        pattern_.add(point.element, point.length * rows.transpose() * stiffness(strain) * rows,
                     sum);
    }
    tangent = frames_.matrix(sum);
    return internalForce(displacement);
}

double PlaneLine::strainEnergy(const VectorXd& displacement) const {
    if (isLinear()) {
        return 0.5 * displacement.dot(internalForce(displacement).force);
    }
    const VectorXd ofControlPoints = frames_.displacements(displacement);
    double energy = 0;
    for (const LinePoint& point : points_) {
        const LineStrain strain(point.position, point.derivatives(ofControlPoints), strains_);
        energy += 0.5 * point.length *
                  ((normalForce(strain) + section_.prestress) * strain.axial +
                   bendingMoment(strain) * strain.curvature);
    }
    return energy;
}

const VectorXd& PlaneLine::externalForce(double time) {
    VectorXd force = force_.dead(time);
    if (isLinear() && force_.hasFollowers()) {
        force += force_.followers(time, VectorXd::Zero(nUnknowns()));
    }
    externalForce_ = frames_.forces(force);
    return externalForce_;
}

void PlaneLine::addFollowerForce(const VectorXd& displacement, double time, VectorXd& force) const {
    if (hasFollowers()) {
        force += frames_.forces(force_.followers(time, frames_.displacements(displacement)));
    }
}

void PlaneLine::subtractFollowerDerivative(const VectorXd& displacement, double time,
                                           SparseMatrix& tangent) const {
    if (!hasFollowers()) {
        return;
    }
    SparseMatrix sum = pattern_.zeroMatrix();
    force_.visitFollowerTangents(
        time, frames_.displacements(displacement),
        [&](int element, const MatrixXd& matrix) { pattern_.add(element, -matrix, sum); });
    tangent += frames_.matrix(sum);
}

bool PlaneLine::hasSymmetricTangent() const {
    if (!hasFollowers() || !force_.hasPressure()) {
        return true;
    }
    const std::vector<bool>& fixed = frames_.fixed();
    const std::size_t last = fixed.size() - 2;
    return force_.hasUniformPressure() && (fixed[0] || fixed[1]) &&
           (fixed[last] || fixed[last + 1]);
}

std::vector<std::string> PlaneLine::freeRigidMotions() const {
    return structure::freeRigidMotions(frames_.heldMotions());
}

double PlaneLine::size() const {
    const geometry::Points& points = curve_.controlPoints();
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

double PlaneLine::length() const {
    double length = 0;
    for (const LinePoint& point : points_) {
        length += point.length;
    }
    return length;
}

LineState PlaneLine::stateAt(double xi, const VectorXd& displacement) const {
    const VectorXd all = frames_.displacements(displacement);
    const geometry::CurveBasis basis = curve_.basis(xi, 3);
    const geometry::Points X = curve_.derivatives(xi, 3);
    Eigen::Matrix<double, 3, 2> u = Eigen::Matrix<double, 3, 2>::Zero();
    for (int a = 0; a < basis.N.cols(); ++a) {
        u += basis.N.col(a).tail<3>() * all.segment<2>(2 * (basis.first + a)).transpose();
    }
    const LineDerivatives reference{X.row(1).head<2>(), X.row(2).head<2>()};
    const LineDerivatives motion{u.row(0), u.row(1)};
    const LineStrain strain(reference, motion, strains_);
    LineState state{normalForce(strain), bendingMoment(strain), 0};
    if (section_.bends()) {
        const double stretch = isLinear() ? 1 : std::sqrt(1 + 2 * strain.axial);
        state.shearForce =
            -section_.bendingStiffness *
            curvatureSlope(reference, X.row(3).head<2>(), motion, u.row(2), strains_) / stretch;
    }
    return state;
}

} // namespace tokay::structure
