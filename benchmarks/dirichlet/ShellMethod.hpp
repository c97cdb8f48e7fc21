// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Method.hpp"

namespace tokay::structure {

/// A membrane whose supports are held by one of the program's own methods.
class ShellMethod : public Method {
  public:
    ShellMethod(std::string name, EdgeMethod method, const EgmOptions& egm = {})
        : Method(std::move(name)), method_(method), egm_(egm) {}

    /// The iterated form is published for degrees 1 and 2.
    int maxDegree() const override { return egm_.form == EgmForm::iterated ? 2 : 4; }
    PoissonResult solve(const PoissonSquare& square, int degree, int n) const override;
    Eigen::MatrixXd matrix(const PoissonSquare& square, int degree, int n) const override;
    double stableStep(const PoissonSquare& square, int degree, int n) const override;

    /// Lets a shell's supports be held so.
    void choose(ShellDescription& shell) const;

  private:
    EdgeMethod method_;
    EgmOptions egm_;
};

/// The extended gradient method as it was published.
/// @param tolerance  of its iteration; 1e-6 is the published one
ShellMethod publishedMethod(double tolerance);

/// In the order of the tables.
const std::vector<ShellMethod>& shellMethods();

/// Stable step on the whole square, without the disc [s].
double stableStepOfWhole(int degree, int n);

} // namespace tokay::structure
