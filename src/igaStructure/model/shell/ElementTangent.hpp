#pragma once

#include "igaStructure/model/shell/SurfaceFunctions.hpp"
#include "igaStructure/model/shell/shellStrain.hpp"

#include <optional>
#include <vector>

namespace tokay::structure {

/// Stiffness of an element, summed over its quadrature points: D^T H D with the
/// functions' derivatives D and the Hessian H of the energy at each point. A few
/// points together are one dense product.
class ElementTangent {
  public:
    /// @param nVectors  2: the energy depends on the base vectors only; 5: on second
    ///                  derivatives too
    explicit ElementTangent(int nVectors) : nVectors_(nVectors) {}

    /// Zero, for an element of so many functions.
    void start(int nFunctions);

    /// @param hessian  times quadrature weight and area
    void add(const SurfaceFunctions& functions, const ShellHessian& hessian);

    /// Component c of function k is number 3 k + c.
    const Eigen::MatrixXd& finish();

  private:
    void multiply();

    static constexpr int most_ = 8; ///< points a product: so it stays in the cache
    int nVectors_;
    int nFunctions_ = 0;
    int nPoints_ = 0;
    std::vector<double> hessians_;
    std::vector<const double*> places_; ///< of the points' Hessians
    std::optional<PaddedRows> functions_, right_, sum_;
    Eigen::MatrixXd matrix_;
};

} // namespace tokay::structure
