#include "igaStructure/run/Watch.hpp"

#include "common/errors.hpp"
#include "geometry/SurfaceProjector.hpp"
#include "igaStructure/output/sampleFields.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

// A coordinate typed by a person has some digits only.
constexpr double relativeTolerance = 1e-6;

} // namespace

Watch::Watch(const PlaneSolid& solid, const std::vector<WatchPoint>& points) {
    if (points.empty()) {
        return;
    }
    const geometry::SurfaceProjector projector(solid.surface());
    for (const WatchPoint& point : points) {
        const geometry::SurfaceProjection place = projector.closest({point.at[0], point.at[1], 0});
        if (place.distance > relativeTolerance * solid.size()) {
            const geometry::Point nearest = solid.surface().point(place.xi, place.eta);
            throw InputError(fmt::format("output.watchPoints: '{}' at [{}, {}] lies {:.4g} m "
                                         "outside the body; its nearest point is [{:.6g}, {:.6g}]",
                                         point.name, point.at[0], point.at[1], place.distance,
                                         nearest[0], nearest[1]));
        }
        names_.push_back(point.name);
        bases_.push_back(solid.surface().basis(place.xi, place.eta, 0));
    }
}

std::vector<std::string> Watch::columns() const {
    std::vector<std::string> columns;
    for (const std::string& name : names_) {
        columns.push_back(name + ".x[m]");
        columns.push_back(name + ".y[m]");
    }
    return columns;
}

std::vector<double> Watch::values(const Eigen::VectorXd& displacement) const {
    std::vector<double> values;
    for (const geometry::SurfaceBasis& basis : bases_) {
        const Eigen::Vector2d u = evaluateField(basis, displacement);
        values.insert(values.end(), {u[0], u[1]});
    }
    return values;
}

std::string Watch::text(const Eigen::VectorXd& displacement) const {
    if (isEmpty()) {
        return "";
    }
    const Eigen::Vector2d u = evaluateField(bases_[0], displacement);
    return fmt::format("{} ({:.6g}, {:.6g}) m", names_[0], u[0], u[1]);
}

} // namespace tokay::structure
