// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/Accelerator.hpp"
#include "coupling/Aitken.hpp"
#include "coupling/ConstantRelaxation.hpp"
#include "coupling/CouplingOptions.hpp"
#include "coupling/IqnIls.hpp"
#include "coupling/Mvqn.hpp"

#include <cassert>

namespace tokay::coupling {

std::unique_ptr<Accelerator> makeAccelerator(const CouplingOptions& options) {
    requireValid(options);
    switch (options.acceleration) {
    case Acceleration::explicitCoupling:
        return nullptr;
    case Acceleration::constant:
        return std::make_unique<ConstantRelaxation>(options.relaxation);
    case Acceleration::aitken:
        return std::make_unique<Aitken>(options);
    case Acceleration::iqnIls:
        return std::make_unique<IqnIls>(options);
    case Acceleration::mvqn:
        return std::make_unique<Mvqn>(options);
    case Acceleration::block:
        assert(!"BlockQuasiNewton takes the place of driver and accelerator");
    }
    return nullptr;
}

} // namespace tokay::coupling
