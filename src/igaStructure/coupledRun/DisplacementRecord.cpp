// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/coupledRun/DisplacementRecord.hpp"

#include "common/checksum.hpp"
#include "common/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace tokay::structure {

namespace {

// Times of two runs differ by rounding: a small part of a step is no difference.
constexpr double timeTolerance = 1e-6;

const std::string recordHeader =
    "# time[s], displacement[m] of each interface point, checksum of the file so far";

std::uint32_t headerChecksum() {
    return checksum(recordHeader);
}

/// The lines of a record, none of which is believed before its checksum.
class RecordLines {
  public:
    explicit RecordLines(const std::string& path) : path_(path), file_(path) {
        if (!file_) {
            throw InputError(fmt::format("cannot read the recorded displacements '{}'", path));
        }
        std::string first;
        if (!std::getline(file_, first) || first != recordHeader || file_.eof()) {
            fail("it does not begin as one");
        }
    }

    /// Time and displacements of the next step; none at the end.
    std::optional<std::string> next() {
        std::string line;
        if (!std::getline(file_, line)) {
            return std::nullopt;
        }
        ++number_;
        const std::size_t end = line.rfind(' ');
        const std::string numbers = line.substr(0, end);
        checksum_ = checksum(numbers, checksum_);
        if (end == std::string::npos || file_.eof() ||
            line.substr(end) != fmt::format(" {:08x}", checksum_)) {
            fail("it does not fit its checksum, or is cut off");
        }
        return numbers;
    }

    [[noreturn]] void fail(const std::string& reason) const {
        throw InputError(fmt::format("{}:{}: the recorded displacements are damaged: {}; record "
                                     "the motion again",
                                     path_, number_, reason));
    }

    int number() const { return number_; }

  private:
    std::string path_;
    std::ifstream file_;
    int number_ = 1;
    std::uint32_t checksum_ = headerChecksum();
};

} // namespace

// Begins the file, with the steps of an earlier run until the start.
void DisplacementRecorder::open() {
    std::vector<std::string> kept;
    if (startTime_ > 0 && std::ifstream(path_)) {
        RecordLines lines(path_);
        while (const std::optional<std::string> numbers = lines.next()) {
            if (std::strtod(numbers->c_str(), nullptr) > startTime_ * (1 + timeTolerance)) {
                break;
            }
            kept.push_back(*numbers);
        }
    }
    file_.emplace(path_);
    file_->write(recordHeader + "\n");
    checksum_ = headerChecksum();
    for (const std::string& numbers : kept) {
        write(numbers);
    }
}

void DisplacementRecorder::write(const std::string& numbers) {
    checksum_ = checksum(numbers, checksum_);
    file_->write(fmt::format("{} {:08x}\n", numbers, checksum_));
}

void DisplacementRecorder::add(double time, const Eigen::VectorXd& displacements) {
    const bool isFirst = !file_;
    if (isFirst) {
        open();
    }
    write(fmt::format("{:.17g} {:.17g}", time, fmt::join(displacements, " ")));
    if (isFirst) {
        file_->publish();
    } else {
        file_->flush();
    }
}

DisplacementRecord::DisplacementRecord(const std::string& path, Eigen::Index nValues)
    : path_(path), times_{0}, displacements_{Eigen::VectorXd::Zero(nValues)} {
    RecordLines lines(path);
    while (const std::optional<std::string> numbers = lines.next()) {
        std::istringstream stream(*numbers);
        std::vector<double> row;
        for (double value; stream >> value;) {
            row.push_back(value);
        }
        if (static_cast<Eigen::Index>(row.size()) != nValues + 1 || row[0] <= times_.back()) {
            throw InputError(fmt::format("{}:{}: {} numbers, but a time later than the line "
                                         "before and {} displacements are needed; was it recorded "
                                         "with this fluid mesh?",
                                         path, lines.number(), row.size(), nValues));
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
