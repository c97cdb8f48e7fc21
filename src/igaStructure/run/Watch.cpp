// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/Watch.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

namespace tokay::structure {

namespace {

// A coordinate typed by a person has some digits only.
constexpr double watchTolerance = 1e-6;

std::string coordinates(const Eigen::VectorXd& x) {
    return fmt::format("{:.6g}", fmt::join(x.begin(), x.end(), ", "));
}

} // namespace

Watch::Watch(const Body& body, const std::vector<WatchPoint>& points) : body_(body) {
    for (const WatchPoint& point : points) {
        const Body::Closest found = body.closest(point.point());
        if (found.distance > watchTolerance * body.model().size()) {
            const Eigen::VectorXd nearest = body.positions({found.location}).col(0);
            throw InputError(
                fmt::format("output.watchPoints: '{}' at [{}] lies {:.4g} m "
                            "outside the body; its nearest point is [{}]",
                            point.name, coordinates(point.point().head(body.dimension())),
                            found.distance, coordinates(nearest.head(body.dimension()))));
        }
        names_.push_back(point.name);
        locations_.push_back(found.location);
    }
}

std::vector<std::string> Watch::columns() const {
    std::vector<std::string> columns;
    for (const std::string& name : names_) {
        for (int c = 0; c < body_.dimension(); ++c) {
            columns.push_back(fmt::format("{}.{}[m]", name, "xyz"[c]));
        }
    }
    return columns;
}

std::vector<double> Watch::values(const Eigen::VectorXd& displacement) const {
    const Eigen::MatrixXd all = body_.displacements(displacement, locations_);
    std::vector<double> values;
    for (Eigen::Index k = 0; k < all.cols(); ++k) {
        values.insert(values.end(), all.col(k).data(), all.col(k).data() + body_.dimension());
    }
    return values;
}

std::string Watch::text(const Eigen::VectorXd& displacement) const {
    if (isEmpty()) {
        return "";
    }
    const Eigen::VectorXd u = body_.displacements(displacement, {locations_[0]}).col(0);
    return fmt::format("{} ({}) m", names_[0], coordinates(u.head(body_.dimension())));
}

} // namespace tokay::structure
