// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/InterfaceTransfer.hpp"

#include "mapper/LinearisedMapping.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/offset/OffsetMapping.hpp"

namespace tokay::structure {

using Eigen::VectorXd;
using geometry::Points;
using mapper::Mapping;

namespace {

// A control point's components one after the other, as unknowns are numbered.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

} // namespace

std::unique_ptr<const Mapping> makeMapping(TransferMethod method, const WetSurface& from,
                                           const Points& to, double gapLimit, bool isLinear) {
    const mapper::GapLimit limit{gapLimit, true};
    return std::visit(
        [&](const auto& surface) -> std::unique_ptr<const Mapping> {
            if (method == TransferMethod::nearestElement) {
                return std::make_unique<mapper::NearestElementMapping>(surface, to, limit);
            }
            auto offset = std::make_unique<mapper::OffsetMapping>(surface, to, limit);
            if (isLinear) {
                return std::make_unique<mapper::LinearisedMapping>(std::move(offset));
            }
            return offset;
        },
        from);
}

InterfaceTransfer::InterfaceTransfer(const StructuralModel& model, Points controlPoints,
                                     std::unique_ptr<const Mapping> displacements,
                                     std::unique_ptr<const Mapping> loads, double depth)
    : model_(model), controlPoints_(std::move(controlPoints)),
      displacements_(std::move(displacements)), loads_(std::move(loads)), depth_(depth) {}

Points InterfaceTransfer::controlDisplacements(const VectorXd& unknowns) const {
    const VectorXd flat = model_.controlDisplacements(unknowns);
    const int n = model_.nComponents();
    Points values = Points::Zero(flat.size() / n, 3);
    values.leftCols(n) = Eigen::Map<const Rows>(flat.data(), flat.size() / n, n);
    return values;
}

Points InterfaceTransfer::displacements(const VectorXd& displacement) const {
    return displacements_->moved(controlDisplacements(displacement));
}

Points InterfaceTransfer::variation(const VectorXd& displacement, const VectorXd& variation) const {
    return displacements_->variation(controlDisplacements(displacement),
                                     controlDisplacements(variation));
}

Points InterfaceTransfer::controlForces(const VectorXd& displacement,
                                        const Points& onPoints) const {
    const Mapping& mapping = loads_ ? *loads_ : *displacements_;
    return mapping.forces(controlDisplacements(displacement), onPoints);
}

VectorXd InterfaceTransfer::forces(const VectorXd& displacement, const Points& onPoints) const {
    const Rows values =
        depth_ * controlForces(displacement, onPoints).leftCols(model_.nComponents());
    return model_.onUnknowns(Eigen::Map<const VectorXd>(values.data(), values.size()));
}

std::string InterfaceTransfer::report() const {
    std::string text = "displacements of the fluid's points, " + displacements_->report().text();
    if (loads_) {
        text += "\nforces of the fluid's points, " + loads_->report().text();
    }
    return text;
}

} // namespace tokay::structure
