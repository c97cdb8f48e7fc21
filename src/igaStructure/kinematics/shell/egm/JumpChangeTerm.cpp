// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/egm/JumpChangeTerm.hpp"

#include "geometry/quadrature/gaussLegendre.hpp"
#include "igaStructure/kinematics/shell/egm/FaceJump.hpp"

#include <cmath>

namespace tokay::structure {

void JumpChangeTerm::add(ExtensionFunctional& functional) const {
    for (int element = 0; element < patch_.patch().nElements(); ++element) {
        if (elements_.hasBody(face_, element)) {
            addElement(element, functional);
        }
    }
}

void JumpChangeTerm::addElement(int element, ExtensionFunctional& functional) const {
    const auto [before, after] = neighboursAlong(patch_.patch(), element, axis_);
    if (before < 0 || after < 0) {
        return;
    }
    std::array<bool, 3> components{};
    for (const int each : {before, element, after}) {
        const std::array<bool, 3> depends = elements_.dependsIn(face_, each);
        for (int c = 0; c < 3; ++c) {
            components[c] = components[c] || depends[c];
        }
    }
    if (!components[0] && !components[1] && !components[2]) {
        return;
    }
    const FaceJump first(patch_, axis_, {before, element});
    const FaceJump second(patch_, axis_, {element, after});
    if (!first.isSmooth() || !second.isSmooth()) {
        return;
    }
    const geometry::ParameterBox box = patch_.patch().elementBox(element);
    const auto& rule = geometry::gaussLegendre(4);
    for (std::size_t g = 0; g < rule.points.size(); ++g) {
        const geometry::Parameters at = box.lower + rule.points[g] * box.size();
        NodeUnion nodes;
        Eigen::RowVectorXd change;
        second.add(at, 3, 1, nodes, change);
        first.add(at, 3, -1, nodes, change);
        const double length = rule.weights[g] * box.size()[1 - axis_] *
                              patch_.surface().derivatives(at[0], at[1], 1).row(2 - axis_).norm();
        functional.add(nodes.nodes(), components, change,
                       gamma_ * std::pow(box.size()[axis_], 6) * length);
    }
}

} // namespace tokay::structure
