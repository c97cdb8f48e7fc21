#include "igaStructure/body/LineTransfer.hpp"

#include <numeric>

namespace tokay::structure {

using geometry::Points;

namespace {

using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

mapper::SplineInterface axisOf(const PlaneLine& line) {
    std::vector<int> numbers(line.curve().nControlPoints());
    std::iota(numbers.begin(), numbers.end(), 0);
    return {{{line.curve(), numbers, "axis"}}, line.curve().nControlPoints()};
}

} // namespace

LineTransfer::LineTransfer(const PlaneLine& line, const Coupling& coupling, const Points& points,
                           const Points& faceCentres)
    : line_(line), axis_(axisOf(line)), toPoints_(axis_, points, {coupling.gapLimit, true}),
      toFaces_(axis_, faceCentres, {coupling.gapLimit, true}) {}

Points LineTransfer::ofControlPoints(const Eigen::VectorXd& displacement) const {
    const Eigen::VectorXd flat = line_.controlDisplacements(displacement);
    Points values = Points::Zero(flat.size() / 2, 3);
    values.leftCols<2>() = Eigen::Map<const Pairs>(flat.data(), flat.size() / 2, 2);
    return values;
}

Points LineTransfer::displacements(const Eigen::VectorXd& displacement) const {
    const Points values = ofControlPoints(displacement);
    return line_.isLinear() ? Points(toPoints_.apply(values)) : toPoints_.moved(values);
}

Eigen::VectorXd LineTransfer::forces(const Eigen::VectorXd& displacement,
                                     const Points& onFaces) const {
    const Points forces = line_.isLinear()
                              ? Points(toFaces_.applyTransposed(onFaces))
                              : toFaces_.forces(ofControlPoints(displacement), onFaces);
    const Pairs pairs = line_.section().width * forces.leftCols<2>();
    return line_.onUnknowns(Eigen::Map<const Eigen::VectorXd>(pairs.data(), pairs.size()));
}

std::string LineTransfer::report() const {
    return "displacements at the fluid's points, " + toPoints_.report().text() +
           "forces from the fluid's faces, " + toFaces_.report().text();
}

} // namespace tokay::structure
