// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/step/ConvergenceCriteria.hpp"
#include "coupling/step/Predictor.hpp"

#include <any>
#include <map>
#include <string>
#include <typeindex>

namespace tokay::coupling {

/// A coupling method by its name, and the options that methods have of their own: each
/// declares a type of its own, with its schema.
class AccelerationOptions {
  public:
    std::string type = "block"; ///< as in the table couplingMethods()

    /// Options of one type, to be changed; they begin with their defaults.
    template <class Own>
    Own& of() {
        std::any& own = own_[typeid(Own)];
        return own.has_value() ? *std::any_cast<Own>(&own) : own.emplace<Own>();
    }

    /// Options of one type; their defaults where none were set.
    template <class Own>
    Own of() const {
        const auto own = own_.find(typeid(Own));
        return own == own_.end() ? Own() : std::any_cast<Own>(own->second);
    }

  private:
    std::map<std::type_index, std::any> own_;
};

/// Everything the user may choose about the coupling, with its default; entries of
/// `coupling` in the case file. @see couplingSchema
struct CouplingOptions {
    Extrapolation predictor = Extrapolation::quadratic;
    AccelerationOptions acceleration;
    ConvergenceOptions convergence;
};

} // namespace tokay::coupling
