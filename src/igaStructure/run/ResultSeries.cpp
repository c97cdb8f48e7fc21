// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/run/ResultSeries.hpp"

#include "igaStructure/output/writeVtu.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace tokay::structure {

ResultSeries::ResultSeries(const Body& body, const OutputOptions& options, std::string name,
                           const MotionState& start)
    : body_(body), directory_(options.directory), fields_(body.fields(options.fields)),
      name_(std::move(name)), meshes_(body.meshes(options)), start_(start) {}

void ResultSeries::continueEarlier() {
    constexpr double tolerance = 1e-9; // times in the file have 12 digits
    const double limit = start_->time + tolerance * std::abs(start_->time);
    for (PvdEntry& entry : readPvd(pvdPath())) {
        if (entry.time <= limit) {
            entries_.push_back(std::move(entry));
        }
    }
    if (!entries_.empty()) {
        start_.reset();
    }
}

void ResultSeries::add(const MotionState& state) {
    if (start_ && start_->time < state.time) {
        addFile(*start_);
    }
    start_.reset();
    addFile(state);
    writePvd(pvdPath(), entries_);
}

void ResultSeries::addFile(const MotionState& state) {
    const std::string file = fmt::format("{}_{:05}.vtu", name_, entries_.size());
    std::vector<VtuPiece> pieces;
    for (const VtuMesh& mesh : meshes_) {
        VtuPiece piece{mesh,
                       body_.positions(mesh.points) +
                           body_.displacements(state.displacement, mesh.points),
                       {}};
        for (const BodyField& field : fields_) {
            piece.fields.push_back({field.name, field.evaluate(state, mesh.points)});
            assert(piece.fields.back().values.rows() == field.nComponents);
        }
        pieces.push_back(std::move(piece));
    }
    writeVtu(directory_ + "/" + file, pieces);
    entries_.push_back({state.time, file});
}

} // namespace tokay::structure
