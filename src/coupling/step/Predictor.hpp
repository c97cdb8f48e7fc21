// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Schema.hpp"

#include <Eigen/Core>

#include <deque>

namespace tokay::coupling {

class StateReader;
class StateWriter;

/// Polynomial through the last accepted steps that starts the next one.
enum class Extrapolation { constant, linear, quadratic, cubic };

const Choices<Extrapolation>& extrapolations();

/// Extrapolates the accepted displacements by a polynomial in time, whatever
/// the time steps were; as long as there are too few of them, by a polynomial
/// of lower degree.
class Predictor {
  public:
    Predictor(Extrapolation extrapolation, const Eigen::VectorXd& initial);

    /// @param deltaT  length of the step to come [s]
    Eigen::VectorXd predict(double deltaT) const;

    /// @param x       accepted displacement at the end of the step
    /// @param deltaT  length of that step [s]
    void accept(const Eigen::VectorXd& x, double deltaT);

    void save(StateWriter& state) const;
    /// @param values  of the interface, or of the structure's unknowns
    enum class Values { ofInterface, ofStructure };
    void restore(StateReader& state, Values values = Values::ofInterface);

  private:
    struct Accepted {
        double time; ///< since the beginning [s]
        Eigen::VectorXd x;
    };

    std::size_t nPoints_;           ///< that the polynomial passes through
    std::deque<Accepted> accepted_; ///< newest first
};

} // namespace tokay::coupling
