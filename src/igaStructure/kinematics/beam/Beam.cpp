// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/Beam.hpp"

#include "common/errors.hpp"
#include "igaStructure/kinematics/beam/isStraight.hpp"

#include <fmt/format.h>

#include <numeric>

namespace tokay::structure {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Beam::Beam(geometry::NurbsCurve curve, const BeamSection& section, Strains strains,
           const std::vector<BeamSupport>& supports, BeamLoads loads, int dimension)
    : dimension_(dimension), curve_(std::move(curve)), section_(section), strains_(strains),
      points_(beamPoints(curve_, curve_.degree() + 1, dimension)),
      frames_(curve_, supports, dimension),
      pattern_(dimension, tensorNeighbours({curve_.knotVector()})),
      force_(curve_, section, std::move(loads), dimension) {
    for (const BeamSupport& support : supports) {
        supportNames_.push_back(support.name);
    }
    requireUsable();
}

std::vector<std::string> Beam::supportNames() const {
    return supportNames_;
}

// Forces on unknowns are, on control points, some of one that is held and of the next.
std::vector<SupportLoad> Beam::supportLoads(const VectorXd& displacement, const VectorXd& reaction,
                                            double /*time*/) const {
    std::vector<SupportLoad> loads(supportNames_.size());
    const geometry::Points& atRest = curve_.controlPoints();
    const geometry::Points positions =
        isLinear() ? atRest : moved(atRest, dimension_, controlDisplacements(displacement));
    for (std::size_t k = 0; k < loads.size(); ++k) {
        VectorXd own = reaction;
        for (Eigen::Index unknown = 0; unknown < own.size(); ++unknown) {
            own[unknown] *= frames_.owners()[unknown] == static_cast<int>(k) ? 1 : 0;
        }
        addForces(SupportOwners(own.size(), static_cast<int>(k)), positions, dimension_,
                  frames_.onControlPoints(own), loads);
    }
    return loads;
}

void Beam::requireUsable() const {
    if (dimension_ == 2 && !curve_.controlPoints().col(2).isZero(0)) {
        throw InputError("a beam or cable of the plane must lie in z = 0, but a control point has "
                         "another z");
    }
    if (!section_.bends()) {
        return;
    }
    requireSmooth();
    if (dimension_ == 3 && !isStraight(curve_)) {
        throw InputError("a beam in space must be straight in its reference configuration: a "
                         "curved one needs its section's frame and torsion; use a shell or solid, "
                         "or a beam in the plane");
    }
}

void Beam::requireSmooth() const {
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

double Beam::normalForce(const BeamStrain& strain) const {
    return section_.prestress + section_.axialStiffness * strain.axial;
}

Eigen::Vector3d Beam::bendingMoment(const BeamStrain& strain) const {
    return section_.bendingStiffness * strain.curvature;
}

SparseMatrix Beam::lumpedMassMatrix() const {
    VectorXd masses = VectorXd::Zero(nUnknowns());
    for (const BeamPoint& point : points_) {
        for (int a = 0; a < point.N.cols(); ++a) {
            masses.segment(dimension_ * (point.first + a), dimension_).array() +=
                section_.mass * point.length * point.N(0, a);
        }
    }
    return frames_.matrix(SparseMatrix(masses.asDiagonal()));
}

// Work-conjugate to the derivatives of the position, per length.
Beam::Vector6d Beam::conjugate(const BeamStrain& strain,
                               const BeamDerivatives& displacement) const {
    if (isLinear()) {
        Vector6d u;
        u << displacement.first, displacement.second;
        return stiffness(strain) * u;
    }
    Vector6d conjugate = strain.curvatureGradient.transpose() * bendingMoment(strain);
    conjugate.head<3>() += normalForce(strain) * strain.axialGradient;
    return conjugate;
}

BeamStrain::Matrix6d Beam::stiffness(const BeamStrain& strain) const {
    return stiffness(strain, isLinear() ? section_.prestress : normalForce(strain),
                     bendingMoment(strain));
}

BeamStrain::Matrix6d Beam::stiffness(const BeamStrain& strain, double axialForce,
                                     const Eigen::Vector3d& moment) const {
    BeamStrain::Matrix6d stiffness = BeamStrain::Matrix6d::Zero();
    if (section_.bends()) {
        stiffness = section_.bendingStiffness * strain.curvatureGradient.transpose() *
                        strain.curvatureGradient +
                    strain.curvatureHessian(moment);
    }
    stiffness.topLeftCorner<3, 3>() +=
        section_.axialStiffness * strain.axialGradient * strain.axialGradient.transpose() +
        axialForce * strain.axialHessian * Eigen::Matrix3d::Identity();
    return stiffness;
}

MatrixXd Beam::onElement(const BeamPoint& point, const BeamStrain::Matrix6d& K) const {
    const int n = static_cast<int>(point.N.cols());
    const int d = dimension_;
    MatrixXd element(d * n, d * n);
    for (int b = 0; b < n; ++b) {
        const double first = point.N(1, b);
        const double second = point.N(2, b);
        const Eigen::Matrix<double, 6, 3> column =
            first * K.leftCols<3>() + second * K.rightCols<3>();
        for (int a = 0; a < n; ++a) {
            const Eigen::Matrix3d block =
                point.N(1, a) * column.topRows<3>() + point.N(2, a) * column.bottomRows<3>();
            element.block(d * a, d * b, d, d) = point.length * block.topLeftCorner(d, d);
        }
    }
    return element;
}

std::vector<int> Beam::nodesOf(int element) const {
    const geometry::KnotVector& knots = curve_.knotVector();
    std::vector<int> nodes(knots.degree() + 1);
    std::iota(nodes.begin(), nodes.end(),
              knots.findSpan(knots.breakpoints()[element]) - knots.degree());
    return nodes;
}

MatrixXd Beam::elementMass(const BeamPoint& point) const {
    const int n = static_cast<int>(point.N.cols());
    const int d = dimension_;
    const Eigen::Vector3d tangent = point.position.first.normalized();
    const Eigen::Matrix3d rotary = section_.rotaryInertia / point.position.first.squaredNorm() *
                                   (Eigen::Matrix3d::Identity() - tangent * tangent.transpose());
    MatrixXd element(d * n, d * n);
    for (int b = 0; b < n; ++b) {
        for (int a = 0; a < n; ++a) {
            const Eigen::Matrix3d block =
                section_.mass * point.N(0, a) * point.N(0, b) * Eigen::Matrix3d::Identity() +
                point.N(1, a) * point.N(1, b) * rotary;
            element.block(d * a, d * b, d, d) = point.length * block.topLeftCorner(d, d);
        }
    }
    return element;
}

SparseMatrix Beam::massMatrix() const {
    SparseMatrix mass = pattern_.zeroMatrix();
    for (const BeamPoint& point : points_) {
        pattern_.add(nodesOf(point.element), elementMass(point), mass.valuePtr());
    }
    return frames_.matrix(mass);
}

StructuralModel::Internal Beam::internalForce(const VectorXd& displacement) const {
    const VectorXd ofControlPoints = frames_.displacements(displacement);
    VectorXd force = VectorXd::Zero(nUnknowns());
    for (const BeamPoint& point : points_) {
        const BeamDerivatives u = point.derivatives(ofControlPoints);
        const BeamStrain strain(point.position, u, strains_);
        const Vector6d conjugate = point.length * this->conjugate(strain, u);
        for (int a = 0; a < point.N.cols(); ++a) {
            const Eigen::Vector3d nodal =
                point.N(1, a) * conjugate.head<3>() + point.N(2, a) * conjugate.tail<3>();
            force.segment(dimension_ * (point.first + a), dimension_) += nodal.head(dimension_);
        }
    }
    return {frames_.forces(force), 1};
}

StructuralModel::Internal Beam::internalForce(const VectorXd& displacement,
                                              SparseMatrix& tangent) const {
    const VectorXd ofControlPoints = frames_.displacements(displacement);
    SparseMatrix sum = pattern_.zeroMatrix();
    for (const BeamPoint& point : points_) {
        const BeamStrain strain(point.position, point.derivatives(ofControlPoints), strains_);
        pattern_.add(nodesOf(point.element), onElement(point, stiffness(strain)), sum.valuePtr());
    }
    tangent = frames_.matrix(sum);
    return internalForce(displacement);
}

StructuralModel::Internal Beam::mixedInternalForce(const VectorXd& displacement,
                                                   const VectorXd& linearisedAt,
                                                   SparseMatrix& tangent) const {
    if (isLinear()) {
        return internalForce(displacement, tangent);
    }
    const VectorXd ofControlPoints = frames_.displacements(displacement);
    const VectorXd before = frames_.displacements(linearisedAt);
    SparseMatrix sum = pattern_.zeroMatrix();
    for (const BeamPoint& point : points_) {
        const BeamDerivatives u = point.derivatives(ofControlPoints);
        const BeamDerivatives start = point.derivatives(before);
        const BeamStrain strain(point.position, u, strains_);
        BeamStrain predicted(point.position, start, strains_);
        Vector6d change;
        change << u.first - start.first, u.second - start.second;
        predicted.axial += predicted.axialGradient.dot(change.head<3>());
        predicted.curvature += predicted.curvatureGradient * change;
        pattern_.add(
            nodesOf(point.element),
            onElement(point, stiffness(strain, normalForce(predicted), bendingMoment(predicted))),
            sum.valuePtr());
    }
    tangent = frames_.matrix(sum);
    return internalForce(displacement);
}

double Beam::strainEnergy(const VectorXd& displacement) const {
    if (isLinear()) {
        return 0.5 * displacement.dot(internalForce(displacement).force);
    }
    const VectorXd ofControlPoints = frames_.displacements(displacement);
    double energy = 0;
    for (const BeamPoint& point : points_) {
        const BeamStrain strain(point.position, point.derivatives(ofControlPoints), strains_);
        energy += 0.5 * point.length *
                  ((normalForce(strain) + section_.prestress) * strain.axial +
                   bendingMoment(strain).dot(strain.curvature));
    }
    return energy;
}

const VectorXd& Beam::externalForce(double time) {
    VectorXd force = force_.dead(time);
    if (isLinear() && force_.hasFollowers()) {
        force += force_.followers(time, VectorXd::Zero(nUnknowns()));
    }
    externalForce_ = frames_.forces(force);
    return externalForce_;
}

void Beam::addFollowerForce(const VectorXd& displacement, double time, VectorXd& force) const {
    if (hasFollowers()) {
        force += frames_.forces(force_.followers(time, frames_.displacements(displacement)));
    }
}

void Beam::subtractFollowerDerivative(const VectorXd& displacement, double time,
                                      SparseMatrix& tangent) const {
    if (!hasFollowers()) {
        return;
    }
    SparseMatrix sum = pattern_.zeroMatrix();
    force_.visitFollowerTangents(time, frames_.displacements(displacement),
                                 [&](int element, const MatrixXd& matrix) {
                                     pattern_.add(nodesOf(element), -matrix, sum.valuePtr());
                                 });
    tangent += frames_.matrix(sum);
}

bool Beam::hasSymmetricTangent() const {
    if (!hasFollowers() || !force_.hasPressure()) {
        return true;
    }
    const std::vector<bool>& fixed = frames_.fixed();
    const std::size_t last = fixed.size() - 2;
    return force_.hasUniformPressure() && (fixed[0] || fixed[1]) &&
           (fixed[last] || fixed[last + 1]);
}

std::vector<std::string> Beam::freeRigidMotions() const {
    return frames_.freeRigidMotions();
}

double Beam::size() const {
    const geometry::Points& points = curve_.controlPoints();
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

double Beam::length() const {
    double length = 0;
    for (const BeamPoint& point : points_) {
        length += point.length;
    }
    return length;
}

BeamState Beam::stateAt(double xi, const VectorXd& displacement) const {
    const VectorXd all = frames_.displacements(displacement);
    const geometry::CurveBasis basis = curve_.basis(xi, 3);
    const geometry::Points X = curve_.derivatives(xi, 3);
    Eigen::Matrix3d u = Eigen::Matrix3d::Zero(); // rows: derivatives
    for (int a = 0; a < basis.N.cols(); ++a) {
        u.leftCols(dimension_) +=
            basis.N.col(a).tail<3>() *
            all.segment(dimension_ * (basis.first + a), dimension_).transpose();
    }
    const BeamDerivatives reference{X.row(1), X.row(2)};
    const BeamDerivatives motion{u.row(0), u.row(1)};
    const BeamStrain strain(reference, motion, strains_);
    if (!section_.bends()) {
        return {normalForce(strain), 0, 0};
    }
    const double stretch = isLinear() ? 1 : std::sqrt(1 + 2 * strain.axial);
    const Eigen::Vector3d moment = bendingMoment(strain);
    const Eigen::Vector3d momentSlope =
        section_.bendingStiffness / stretch *
        curvatureSlope(reference, X.row(3), motion, u.row(2), strains_);
    return dimension_ == 2 ? BeamState{normalForce(strain), moment[2], -momentSlope[2]}
                           : BeamState{normalForce(strain), moment.norm(), momentSlope.norm()};
}

} // namespace tokay::structure
