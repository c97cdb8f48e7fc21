// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/beam/LineTransfer.hpp"

#include <cassert>
#include <numeric>

namespace tokay::structure {

using geometry::Points;

namespace {

using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

mapper::SplineInterface axisOf(const Line& line) {
    std::vector<int> numbers(line.curve().nControlPoints());
    std::iota(numbers.begin(), numbers.end(), 0);
    return {{{line.curve(), numbers, "axis"}}, line.curve().nControlPoints()};
}

} // namespace

LineTransfer::LineTransfer(const Line& line, const Coupling& coupling, const Points& points)
    : line_(line), axis_(axisOf(line)), toPoints_(axis_, points, {coupling.gapLimit, true}) {
    assert(line.dimension() == 2);
}

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

Points LineTransfer::controlForces(const Eigen::VectorXd& displacement,
                                   const Points& onPoints) const {
    return line_.isLinear() ? Points(toPoints_.applyTransposed(onPoints))
                            : toPoints_.forces(ofControlPoints(displacement), onPoints);
}

Points LineTransfer::controlPoints(const Eigen::VectorXd& displacement) const {
    return axis_.coordinates() + ofControlPoints(displacement);
}

Points LineTransfer::variation(const Eigen::VectorXd& displacement,
                               const Eigen::VectorXd& variation) const {
    const Points change = ofControlPoints(variation);
    return line_.isLinear() ? Points(toPoints_.apply(change))
                            : toPoints_.variation(ofControlPoints(displacement), change);
}

Eigen::VectorXd LineTransfer::forces(const Eigen::VectorXd& displacement,
                                     const Points& onPoints) const {
    const Pairs pairs = depth() * controlForces(displacement, onPoints).leftCols<2>();
    return line_.onUnknowns(Eigen::Map<const Eigen::VectorXd>(pairs.data(), pairs.size()));
}

std::string LineTransfer::report() const {
    return "displacements of the fluid's points, " + toPoints_.report().text();
}

} // namespace tokay::structure
