#include "igaStructure/output/ResultSeries.hpp"

#include "igaStructure/output/OutputFile.hpp"
#include "igaStructure/output/sampleFields.hpp"
#include "igaStructure/output/writeVtu.hpp"

#include <fmt/format.h>

namespace tokay::structure {

ResultSeries::ResultSeries(const PlaneSolid& solid, const OutputOptions& options, std::string name,
                           const MotionState& start)
    : solid_(solid), options_(options), name_(std::move(name)),
      mesh_(options.cells == CellShape::bezier ? bezierMesh(solid.surface())
                                               : quadMesh(solid.surface(), options.subdivision)),
      referencePositions_(3, mesh_.points.size()), start_(start) {
    for (std::size_t k = 0; k < mesh_.points.size(); ++k) {
        referencePositions_.col(k) = solid.surface().point(mesh_.points[k][0], mesh_.points[k][1]);
    }
}

void ResultSeries::add(const MotionState& state) {
    if (start_ && start_->time < state.time) {
        addFile(*start_);
    }
    start_.reset();
    addFile(state);
    writePvd();
}

void ResultSeries::addFile(const MotionState& state) {
    const std::string file = fmt::format("{}_{:05}.vtu", name_, entries_.size());
    // The body's shape needs the displacement, whether it is a wanted field or not.
    const Eigen::MatrixXd displacement =
        sampleFields(solid_, state, {"displacement"}, mesh_.points)[0].values;
    writeVtu(options_.directory + "/" + file, mesh_, referencePositions_ + displacement,
             sampleFields(solid_, state, options_.fields, mesh_.points));
    entries_.push_back({state.time, file});
}

void ResultSeries::writePvd() const {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n  <Collection>\n";
    for (const Entry& entry : entries_) {
        text += fmt::format("    <DataSet timestep=\"{:.12g}\" file=\"{}\"/>\n", entry.time,
                            entry.file);
    }
    OutputFile file(options_.directory + "/" + name_ + ".pvd");
    file.write(text + "  </Collection>\n</VTKFile>\n");
    file.publish();
}

} // namespace tokay::structure
