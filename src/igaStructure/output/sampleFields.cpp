#include "igaStructure/output/sampleFields.hpp"

#include <cassert>
#include <cmath>

namespace tokay::structure {

namespace {

Eigen::MatrixXd sampleVector(const PlaneSolid& solid, const Eigen::VectorXd& field,
                             const std::vector<Parameters>& points) {
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(3, points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        values.col(k).head<2>() =
            evaluateField(solid.surface().basis(points[k][0], points[k][1], 0), field);
    }
    return values;
}

Eigen::MatrixXd sampleStress(const PlaneSolid& solid, const Eigen::VectorXd& displacement,
                             const std::vector<Parameters>& points) {
    Eigen::MatrixXd values(6, points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Matrix3d s =
            solid.stateAt(points[k][0], points[k][1], displacement).cauchyStress;
        values.col(k) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    }
    return values;
}

Eigen::MatrixXd vonMises(const Eigen::MatrixXd& stress) {
    Eigen::MatrixXd values(1, stress.cols());
    for (Eigen::Index k = 0; k < stress.cols(); ++k) {
        const auto s = stress.col(k);
        const double normal =
            0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2));
        values(0, k) = std::sqrt(normal + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
    }
    return values;
}

} // namespace

Eigen::Vector2d evaluateField(const geometry::SurfaceBasis& basis, const Eigen::VectorXd& field) {
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    for (std::size_t a = 0; a < basis.controlPoints.size(); ++a) {
        value += basis.N(0, a) * field.segment<2>(2 * basis.controlPoints[a]);
    }
    return value;
}

std::vector<ResultField> sampleFields(const PlaneSolid& solid, const MotionState& state,
                                      const std::vector<std::string>& names,
                                      const std::vector<Parameters>& points) {
    std::vector<ResultField> fields;
    for (const std::string& name : names) {
        if (name == "displacement") {
            fields.push_back({name, sampleVector(solid, state.displacement, points)});
        } else if (name == "velocity") {
            fields.push_back({name, sampleVector(solid, state.velocity, points)});
        } else if (name == "acceleration") {
            fields.push_back({name, sampleVector(solid, state.acceleration, points)});
        } else if (name == "stress") {
            fields.push_back({name, sampleStress(solid, state.displacement, points)});
        } else {
            assert(name == "vonMisesStress");
            fields.push_back({name, vonMises(sampleStress(solid, state.displacement, points))});
        }
    }
    return fields;
}

} // namespace tokay::structure
