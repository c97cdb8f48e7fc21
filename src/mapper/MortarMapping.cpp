#include "mapper/MortarMapping.hpp"

#include "mapper/Stopwatch.hpp"
#include "mapper/conservation.hpp"
#include "mapper/curveIntersection.hpp"
#include "mapper/meshIntersection.hpp"

namespace tokay::mapper {

MortarMapping::MortarMapping(const CurveInterface& from, const CurveInterface& to,
                             const MortarOptions& options) {
    const Stopwatch watch;
    MortarAssembler assembler(to.nValues(), from.nValues(), options.basis);
    GapStatistics gaps(options.gapLimit, from.size());
    integrateIntersection(from, to, options.gapLimit, options.nExtraPoints, assembler, gaps);
    gaps.enter(report_);
    finish(assembler, options, from, to);
    report_.seconds = watch.seconds();
}

MortarMapping::MortarMapping(const SurfaceMesh& from, const SurfaceMesh& to,
                             const MortarOptions& options) {
    const Stopwatch watch;
    MortarAssembler assembler(to.nValues(), from.nValues(), options.basis);
    GapStatistics gaps(options.gapLimit, from.size());
    integrateIntersection(from, to, options.gapLimit, assembler, gaps);
    gaps.enter(report_);
    finish(assembler, options, from, to);
    report_.seconds = watch.seconds();
}

void MortarMapping::finish(const MortarAssembler& assembler, const MortarOptions& options,
                           const Discretisation& from, const Discretisation& to) {
    report_.method = options.basis == MortarBasis::dual ? "mortar, dual basis" : "mortar";
    mass_ = assembler.massMatrix();
    cross_ = assembler.crossMatrix();
    inverse_.emplace(mass_, options.singular);
    report_.nUncovered = assembler.nUncovered();
    report_.nInverted = inverse_->nActive();
    report_.rank = inverse_->rank();
    report_.condition = inverse_->conditionOnRange();

    // A singular mass matrix leaves values open, but not the field: errors are
    // measured in the field, by test tractions.
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(to.nValues());
    const Eigen::VectorXd mapped = apply(Eigen::VectorXd::Ones(from.nValues()));
    report_.rowSumError = (mass_ * (mapped - ones)).norm() / (mass_ * ones).norm();
    const Points forces = mass_ * testForces(to.nValues());
    measureConservation(*this, forces, from.coordinates(), to.coordinates(), report_);
    report_.bytes = bytesOf(mass_) + bytesOf(cross_);
}

Eigen::MatrixXd MortarMapping::apply(const Eigen::MatrixXd& values) const {
    return inverse_->solve(cross_ * values);
}

Eigen::MatrixXd MortarMapping::applyTransposed(const Eigen::MatrixXd& forces) const {
    return cross_.transpose() * inverse_->solve(forces);
}

} // namespace tokay::mapper
