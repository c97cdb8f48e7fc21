// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/DisplacementRecord.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace tokay::structure {

namespace {

// Times of two runs differ by rounding: a small part of a step is no difference.
constexpr double timeTolerance = 1e-6;

} // namespace

// Each with its line end.
std::string DisplacementRecorder::keptLines() const {
    std::string lines;
    std::ifstream file(path_);
    for (std::string line; startTime_ > 0 && std::getline(file, line);) {
        if (line[0] != '#' && std::stod(line) <= startTime_ * (1 + timeTolerance)) {
            lines += line + "\n";
        }
    }
    return lines;
}

void DisplacementRecorder::add(double time, const Eigen::VectorXd& displacements) {
    const bool isFirst = !file_;
    if (isFirst) {
        const std::string kept = keptLines();
        file_.emplace(path_);
        file_->write("# time[s] and displacement[m] of each interface point\n" + kept);
    }
    file_->write(fmt::format("{:.17g} {:.17g}\n", time, fmt::join(displacements, " ")));
    if (isFirst) {
        file_->publish();
    } else {
        file_->flush();
    }
}

DisplacementRecord::DisplacementRecord(const std::string& path, Eigen::Index nValues)
    : path_(path), times_{0}, displacements_{Eigen::VectorXd::Zero(nValues)} {
    std::ifstream file(path);
    if (!file) {
        throw InputError(fmt::format("cannot read the recorded displacements '{}'", path));
    }
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        std::istringstream stream(line);
        std::vector<double> row;
        for (double value; stream >> value;) {
            row.push_back(value);
        }
        if (static_cast<Eigen::Index>(row.size()) != nValues + 1 || row[0] <= times_.back()) {
            throw InputError(fmt::format("{}:{}: {} numbers, but a time later than the line "
                                         "before and {} displacements are needed; was it recorded "
                                         "with this fluid mesh?",
                                         path, number, row.size(), nValues));
        }
        times_.push_back(row[0]);
        displacements_.push_back(Eigen::Map<const Eigen::VectorXd>(row.data() + 1, nValues));
    }
}

Eigen::VectorXd DisplacementRecord::at(double time) const {
    const auto next = std::lower_bound(times_.begin(), times_.end(), time);
    const std::size_t k = std::max<std::ptrdiff_t>(1, next - times_.begin());
    const double lastStep = times_.size() > 1 ? times_.back() - times_[times_.size() - 2] : 0;
    if (time > times_.back() + timeTolerance * lastStep) {
        throw InputError(fmt::format("{} ends at {:.9g} s, but the fluid is at {:.9g} s", path_,
                                     times_.back(), time));
    }
    if (k == times_.size()) {
        return displacements_.back();
    }
    const double step = times_[k] - times_[k - 1];
    const double share = (time - times_[k - 1]) / step;
    if (share > 1 - timeTolerance) {
        return displacements_[k];
    }
    return (1 - share) * displacements_[k - 1] + share * displacements_[k];
}

} // namespace tokay::structure
