#pragma once

#include "igaStructure/model/PlaneSolid.hpp"
#include "igaStructure/output/ResultField.hpp"
#include "igaStructure/timeIntegration/TimeIntegrator.hpp"

namespace tokay::structure {

/// Evaluates fields of a plane body.
/// @param names  displacement, velocity, acceleration: 3 components; stress:
///               Cauchy's, in the order xx yy zz xy yz xz; vonMisesStress: 1
std::vector<ResultField> sampleFields(const PlaneSolid& solid, const MotionState& state,
                                      const std::vector<std::string>& names,
                                      const std::vector<Parameters>& points);

/// Value of a vector field given by control points (2 unknowns each).
Eigen::Vector2d evaluateField(const geometry::SurfaceBasis& basis, const Eigen::VectorXd& field);

} // namespace tokay::structure
