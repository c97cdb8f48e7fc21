// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/ReactionColumns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tokay::structure {

namespace {

// Supports of one name are numbered from the second on; columns are separated by blanks.
std::vector<std::string> distinct(std::vector<std::string> names) {
    std::map<std::string, int> counts;
    for (std::string& name : names) {
        std::replace(name.begin(), name.end(), ' ', '_');
        const int number = ++counts[name];
        if (number > 1) {
            name += fmt::format("-{}", number);
        }
    }
    return names;
}

} // namespace

std::vector<std::string> ReactionColumns::names() const {
    std::vector<std::string> columns;
    if (!about_) {
        return columns;
    }
    const bool isPlane = body_.dimension() == 2;
    for (const std::string& name : distinct(body_.model().supportNames())) {
        for (const char* component : {"fx", "fy", "fz", "mx", "my", "mz"}) {
            const std::string text = component;
            if (!isPlane || text == "fx" || text == "fy" || text == "mz") {
                columns.push_back(
                    fmt::format("{}.{}[{}]", name, text, text[0] == 'f' ? "N" : "N.m"));
            }
        }
    }
    return columns;
}

std::vector<double> ReactionColumns::values(const MotionState& state) const {
    const Eigen::Vector3d centre(about_->at[0], about_->at[1], about_->at[2]);
    const bool isPlane = body_.dimension() == 2;
    std::vector<double> values;
    for (const SupportLoad& load :
         body_.model().supportLoads(state.displacement, state.reaction, state.time)) {
        const Eigen::Vector3d moment = load.moment - centre.cross(load.force);
        if (isPlane) {
            values.insert(values.end(), {load.force[0], load.force[1], moment[2]});
        } else {
            values.insert(values.end(), {load.force[0], load.force[1], load.force[2], moment[0],
                                         moment[1], moment[2]});
        }
    }
    return values;
}

} // namespace tokay::structure
