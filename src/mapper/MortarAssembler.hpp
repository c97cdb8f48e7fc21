#pragma once

#include "mapper/Discretisation.hpp"
#include "mapper/SparseMatrix.hpp"

namespace tokay::mapper {

/// Test functions of the mortar condition: the destination's own, or functions
/// biorthogonal to them element by element, for which the mass matrix is diagonal.
enum class MortarBasis { standard, dual };

/// Sums M_DD = integral of N_D N_D^T and M_DO = integral of N_D N_O^T over the
/// intersection of the two sides, destination element by destination element.
class MortarAssembler {
  public:
    MortarAssembler(int nTo, int nFrom, MortarBasis basis);

    /// A quadrature point of the current destination element.
    void add(double weight, const Functions& to, const Functions& from);

    /// A quadrature point with no partner: its functions exist, but get nothing.
    void addUnmatched(const Functions& to);

    /// Closes the element.
    /// Source of the dual basis: Wohlmuth, SIAM J. Numer. Anal. 38, 2000
    void endElement();

    SparseMatrix massMatrix() const;
    SparseMatrix crossMatrix() const;
    /// Values on the destination's interface that got nothing.
    int nUncovered() const;

  private:
    int column(int fromValue);

    int nTo_, nFrom_;
    MortarBasis basis_;
    std::vector<Eigen::Triplet<double>> mass_, cross_;
    std::vector<char> isOnInterface_, isCovered_;

    // The current element: destination values, source values, local matrices.
    std::vector<int> toValues_, fromValues_;
    Eigen::MatrixXd localMass_, localCross_;
};

} // namespace tokay::mapper
