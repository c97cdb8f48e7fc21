// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>

namespace tokay {

/// Number or formula in x, y, z [m] and t [s], e.g. "100*y*sin(2*pi*t)": one
/// expression. Functions are muParser's: sin, cos, tan, exp, ln, sqrt, abs, min, max,
/// a ? b : c, …; pi and e are constants.
class Formula {
  public:
    /// The formula 0.
    Formula();

    /// @param where  location in the case file or command line, begins messages
    /// @throws InputError if it cannot be read, is not one expression, or is constant
    ///         and not finite
    Formula(const std::string& text, const std::string& where);
    Formula(const Formula&);
    Formula& operator=(const Formula&);
    Formula(Formula&&) noexcept;
    Formula& operator=(Formula&&) noexcept;
    ~Formula();

    /// @throws InputError if the value is not finite; says where and when
    double operator()(const Eigen::Vector3d& at, double t) const;

    bool dependsOnTime() const;
    /// On x, y or z.
    bool dependsOnPlace() const;
    const std::string& text() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tokay
