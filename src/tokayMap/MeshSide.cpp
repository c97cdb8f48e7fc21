// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/errors.hpp"
#include "mapper/interface/CurveInterface.hpp"
#include "tokayMap/Side.hpp"
#include "tokayMap/files/writeField.hpp"

#include <fmt/format.h>

namespace tokay::tool {

namespace {

using mapper::ValuesAt;

std::unique_ptr<mapper::Discretisation> discretisationOf(const MeshFile& mesh, ValuesAt valuesAt) {
    if (!mesh.isLines) {
        return std::make_unique<mapper::SurfaceMesh>(mesh.vertices, mesh.cells, valuesAt);
    }
    std::vector<std::array<int, 2>> lines;
    for (const std::vector<int>& cell : mesh.cells) {
        lines.push_back({cell[0], cell[1]});
    }
    return std::make_unique<mapper::CurveInterface>(
        mapper::lineMesh(mesh.vertices, lines, valuesAt));
}

class MeshSide : public Side {
  public:
    MeshSide(MeshFile mesh, const std::string& path, const SideOptions& options)
        : mesh_(std::move(mesh)), path_(path), valuesAt_(options.valuesAt) {
        mesh_.vertices *= options.scale;
        try {
            discretisation_ = discretisationOf(mesh_, valuesAt_);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", path, error.what()));
        }
    }

    std::string description() const override {
        return fmt::format(
            "{}: {} vertices, {} {}, values at {}, size {:.4g} m", path_, mesh_.vertices.rows(),
            mesh_.cells.size(), mesh_.isLines ? "lines" : "faces",
            valuesAt_ == ValuesAt::vertices ? "vertices" : "faces", discretisation_->size());
    }

    const mapper::Discretisation& discretisation() const override { return *discretisation_; }
    bool hasSplines() const override { return false; }
    const Points& samplePoints() const override { return discretisation_->coordinates(); }
    Eigen::MatrixXd sampled(const Eigen::MatrixXd& values) const override { return values; }

    Eigen::VectorXd valuesOf(const ScalarFunction& function) const override {
        Eigen::VectorXd values(samplePoints().rows());
        for (Eigen::Index i = 0; i < values.size(); ++i) {
            values[i] = function(samplePoints().row(i));
        }
        return values;
    }

    void writeSamples(const std::string& path, const std::string& field,
                      const Eigen::MatrixXd& samples) const override {
        writeField(path, {mesh_.vertices, mesh_.cells, valuesAt_}, field, samples);
    }
    void writeForces(const std::string& path, const std::string& field,
                     const Eigen::MatrixXd& forces) const override {
        writeSamples(path, field, forces);
    }

  private:
    MeshFile mesh_;
    std::string path_;
    ValuesAt valuesAt_;
    std::unique_ptr<mapper::Discretisation> discretisation_;
};

} // namespace

std::unique_ptr<Side> meshSide(MeshFile mesh, const std::string& path, const SideOptions& options) {
    return std::make_unique<MeshSide>(std::move(mesh), path, options);
}

} // namespace tokay::tool
