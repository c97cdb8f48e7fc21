#include "igaStructure/output/ResultSeries.hpp"

#include "common/OutputFile.hpp"
#include "igaStructure/output/chosenFields.hpp"
#include "igaStructure/output/writeVtu.hpp"

#include <fmt/format.h>

namespace tokay::structure {

ResultSeries::ResultSeries(const Body& body, const OutputOptions& options, std::string name,
                           const MotionState& start)
    : body_(body), directory_(options.directory), fields_(chosenFields(body, options)),
      name_(std::move(name)), meshes_(body.meshes(options)), start_(start) {}

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
    std::vector<VtuPiece> pieces;
    for (const VtuMesh& mesh : meshes_) {
        VtuPiece piece{mesh,
                       body_.positions(mesh.points) +
                           body_.displacements(state.displacement, mesh.points),
                       {}};
        for (const std::string& field : fields_) {
            piece.fields.push_back({field, body_.field(field, state, mesh.points)});
        }
        pieces.push_back(std::move(piece));
    }
    writeVtu(directory_ + "/" + file, pieces);
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
    OutputFile file(directory_ + "/" + name_ + ".pvd");
    file.write(text + "  </Collection>\n</VTKFile>\n");
    file.publish();
}

} // namespace tokay::structure
