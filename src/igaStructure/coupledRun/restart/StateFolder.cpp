// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/restart/StateFolder.hpp"

#include "common/OutputFile.hpp"
#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace tokay::structure {

namespace {

const std::string extension = ".state";

// Names of two times differ, so that of a time is off by half a step at most.
constexpr double nameTolerance = 0.75;

std::vector<std::uint8_t> readBytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(file), {});
    if (!file) {
        throw InputError("cannot read '" + path + "'");
    }
    return bytes;
}

} // namespace

std::string StateFolder::path(double time) const {
    return fmt::format("{}/{}_{:.12g}{}", directory_, name_, time, extension);
}

void StateFolder::add(const SavedState& state, double deltaT) {
    const std::vector<std::uint8_t> bytes = encodeState(state);
    OutputFile file(path(state.motion.time));
    file.write(bytes.data(), bytes.size());
    file.publish();
    added_.push_back({state.motion.time, deltaT});
}

void StateFolder::removeExcept(const std::vector<double>& fluidTimes) {
    if (added_.empty()) {
        return;
    }
    std::set<double> needed = {added_.back().time};
    for (const double time : fluidTimes) {
        const auto nearest =
            std::min_element(added_.begin(), added_.end(), [time](const Added& a, const Added& b) {
                return std::abs(a.time - time) < std::abs(b.time - time);
            });
        if (std::abs(nearest->time - time) <= nameTolerance * nearest->deltaT) {
            needed.insert(nearest->time);
        }
    }
    const auto isNeeded = [&](const Added& added) { return needed.count(added.time) > 0; };
    const auto rest = std::stable_partition(added_.begin(), added_.end(), isNeeded);
    for (auto added = rest; added != added_.end(); ++added) {
        std::error_code ignored; // one that stays does no harm
        std::filesystem::remove(path(added->time), ignored);
    }
    added_.erase(rest, added_.end());
}

std::optional<SavedState> StateFolder::find(double time, double tolerance) const {
    const std::vector<double> all = times();
    const auto nearest = std::min_element(all.begin(), all.end(), [time](double a, double b) {
        return std::abs(a - time) < std::abs(b - time);
    });
    if (nearest == all.end() || !(std::abs(*nearest - time) <= tolerance)) {
        return std::nullopt;
    }
    return decodeState(readBytes(path(*nearest)), path(*nearest));
}

std::vector<double> StateFolder::times() const {
    std::vector<double> times;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(directory_, none)) {
        const std::string file = entry.path().filename().string();
        if (entry.path().extension() == extension && file.compare(0, name_.size(), name_) == 0) {
            const std::string text = entry.path().stem().string().substr(name_.size());
            char* end = nullptr;
            const double time = text.size() > 1 ? std::strtod(text.c_str() + 1, &end) : 0;
            if (text[0] == '_' && end && *end == '\0') {
                times.push_back(time);
            }
        }
    }
    std::sort(times.begin(), times.end());
    return times;
}

} // namespace tokay::structure
