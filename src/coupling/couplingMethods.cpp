// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/couplingMethods.hpp"

#include "coupling/block/BlockQuasiNewton.hpp"
#include "coupling/fixedPoint/Aitken.hpp"
#include "coupling/fixedPoint/ConstantRelaxation.hpp"
#include "coupling/fixedPoint/ExplicitCoupling.hpp"
#include "coupling/fixedPoint/FixedPoint.hpp"
#include "coupling/fixedPoint/IqnIls.hpp"
#include "coupling/fixedPoint/Mvqn.hpp"

#include <algorithm>
#include <cassert>

namespace tokay::coupling {
namespace {

template <class AcceleratorType>
std::unique_ptr<CouplingMethod> fixedPoint(const CouplingOptions& options, double tolerance,
                                           CoupledStructure& structure) {
    return std::make_unique<FixedPoint>(options, tolerance, structure,
                                        std::make_unique<AcceleratorType>(options));
}

std::unique_ptr<CouplingMethod> block(const CouplingOptions& options, double tolerance,
                                      CoupledStructure& structure) {
    assert(structure.linearised());
    return std::make_unique<BlockQuasiNewton>(options, tolerance, *structure.linearised());
}

} // namespace

const std::vector<CouplingMethodType>& couplingMethods() {
    static const std::vector<CouplingMethodType> types = {
        {Acceleration::explicitCoupling, "explicit", "One coupling iteration per time step.",
         fixedPoint<ExplicitCoupling>},
        {Acceleration::constant, "constant", "Constant relaxation.",
         fixedPoint<ConstantRelaxation>},
        {Acceleration::aitken, "aitken", "Aitken's dynamic relaxation.", fixedPoint<Aitken>},
        {Acceleration::iqnIls, "iqnIls", "Interface quasi-Newton, least squares.",
         fixedPoint<IqnIls>},
        {Acceleration::mvqn, "mvqn", "Interface quasi-Newton, multi-vector (IMVJ).",
         fixedPoint<Mvqn>},
        {Acceleration::block, "block",
         "Block quasi-Newton: the fluid's response learned, the structure's tangent used.", block}};
    return types;
}

std::unique_ptr<CouplingMethod> makeCouplingMethod(const CouplingOptions& options, double tolerance,
                                                   CoupledStructure& structure) {
    requireValid(options);
    const auto& types = couplingMethods();
    const auto type = std::find_if(types.begin(), types.end(), [&](const CouplingMethodType& t) {
        return t.acceleration == options.acceleration;
    });
    assert(type != types.end());
    return type->make(options, tolerance, structure);
}

} // namespace tokay::coupling
