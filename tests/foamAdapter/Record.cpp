// SPDX-License-Identifier: GPL-3.0-or-later
#include "Record.hpp"

#include <limits>

namespace tokay::channel {

Record::Record(const std::string& fileName) {
    if (!fileName.empty()) {
        file_.open(fileName);
    }
    file_.precision(std::numeric_limits<double>::max_digits10);
}

template <class Values>
void Record::row(const std::string& name, const Values& values) {
    file_ << name;
    for (const auto value : values) {
        file_ << ' ' << value;
    }
    file_ << std::endl; // what was said stays readable however this program ends
}

void Record::add(const Interface& interface) {
    file_ << "dimension " << interface.dimension << '\n';
    row("points", interface.points);
    row("faceOffsets", interface.faceOffsets);
    row("facePoints", interface.facePoints);
    row("displacements", interface.displacements);
    file_ << "tolerance " << interface.tolerance << '\n';
    file_ << "times " << interface.startTime << ' ' << interface.endTime << std::endl;
}

void Record::add(const BeginStep& step) {
    time_ = step.time;
    file_ << "step " << step.step << ' ' << time_ << ' ' << step.deltaT << std::endl;
}

void Record::add(const Forces& forces) {
    file_ << "forces " << time_ << ' ' << forces.final << ' ' << forces.write << ' '
          << forces.fluidResidual.value_or(0);
    row("", forces.values);
}

void Record::add(const Displacements& answer) {
    file_ << "answer " << time_ << ' ' << static_cast<int>(answer.state);
    row("", answer.values);
}

void Record::add(const RejectStep& rejection) {
    file_ << "rejected " << time_ << ' ' << rejection.reason << std::endl;
}

} // namespace tokay::channel
