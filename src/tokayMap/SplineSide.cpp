// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJson.hpp"
#include "geometry/trimming/patchTriangles.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "tokayMap/Side.hpp"
#include "tokayMap/files/writeField.hpp"
#include "tokayMap/splineProjection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace tokay::tool {

namespace {

using geometry::TrimmedPatch;
using mapper::ValuesAt;

TrimmedPatch scaled(const TrimmedPatch& patch, double scale) {
    const geometry::NurbsSurface& surface = patch.surface();
    return TrimmedPatch(surface.withControlPoints(scale * surface.controlPoints()), patch.loops(),
                        patch.name());
}

TrimmedPatch refined(const TrimmedPatch& patch, const SideOptions& options) {
    const geometry::NurbsSurface& basis = patch.basis();
    return patch.refined(std::max(basis.u().degree(), options.degree),
                         std::max(basis.v().degree(), options.degree), options.nDivisions,
                         options.nDivisions);
}

/// Patches with control points of their own, one after the other.
mapper::SurfaceInterface interfaceOf(const geometry::BrepModel& model, const SideOptions& options) {
    std::vector<mapper::SurfacePiece> pieces;
    int nControlPoints = 0;
    for (const geometry::BrepFace& face : model.faces()) {
        TrimmedPatch patch = refined(scaled(face.patch, options.scale), options);
        std::vector<int> numbers(patch.basis().nControlPoints());
        std::iota(numbers.begin(), numbers.end(), nControlPoints);
        nControlPoints += static_cast<int>(numbers.size());
        const std::string name = patch.name();
        pieces.push_back({std::move(patch), std::move(numbers), name});
    }
    return mapper::SurfaceInterface(std::move(pieces), nControlPoints);
}

class SplineSide : public Side {
  public:
    SplineSide(const std::string& path, const SideOptions& options)
        : path_(path), splines_(interfaceOf(geometry::readCadJson(path), options)) {
        for (int piece = 0; piece < splines_.nPieces(); ++piece) {
            addSamples(piece);
        }
    }

    std::string description() const override {
        return fmt::format("{}: {} patches, {} elements, {} control points, size {:.4g} m", path_,
                           splines_.nPieces(), splines_.nElements(), splines_.nValues(),
                           splines_.size());
    }

    const mapper::Discretisation& discretisation() const override { return splines_; }
    bool hasSplines() const override { return true; }
    const Points& samplePoints() const override { return points_; }

    Eigen::MatrixXd sampled(const Eigen::MatrixXd& values) const override {
        Eigen::MatrixXd samples(points_.rows(), values.cols());
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const Place& at = places_[i];
            const mapper::Functions f =
                splines_.functions(at.piece, at.parameters[0], at.parameters[1]);
            samples.row(static_cast<Eigen::Index>(i)) =
                f.weights.transpose() * values(f.values, Eigen::all);
        }
        return samples;
    }

    Eigen::VectorXd valuesOf(const ScalarFunction& function) const override {
        return splineProjection(splines_, function);
    }

    void writeSamples(const std::string& path, const std::string& field,
                      const Eigen::MatrixXd& samples) const override {
        writeField(path, {points_, triangles_, ValuesAt::vertices}, field, samples);
    }
    void writeForces(const std::string& path, const std::string& field,
                     const Eigen::MatrixXd& forces) const override {
        std::vector<std::vector<int>> controlPoints(splines_.nValues());
        for (std::size_t i = 0; i < controlPoints.size(); ++i) {
            controlPoints[i] = {static_cast<int>(i)};
        }
        writeField(path, {splines_.coordinates(), controlPoints, ValuesAt::vertices}, field,
                   forces);
    }

  private:
    struct Place {
        int piece;
        geometry::Parameters parameters;
    };

    /// Triangles of a basis twice as fine, so that fields within elements show.
    void addSamples(int piece) {
        const TrimmedPatch& patch = splines_.piece(piece).patch;
        const geometry::NurbsSurface& basis = patch.basis();
        const geometry::PatchTriangles mesh = patchTriangles(
            patch.refined(basis.u().degree(), basis.v().degree(), 2, 2), 1e-3 * splines_.size());
        const auto first = static_cast<int>(places_.size());
        for (const geometry::Parameters& parameters : mesh.parameters) {
            places_.push_back({piece, parameters});
        }
        for (const auto& corners : mesh.triangles) {
            triangles_.push_back({first + corners[0], first + corners[1], first + corners[2]});
        }
        points_.conservativeResize(first + mesh.points.rows(), 3);
        points_.bottomRows(mesh.points.rows()) = mesh.points;
    }

    std::string path_;
    mapper::SurfaceInterface splines_;
    std::vector<Place> places_;
    Points points_;
    std::vector<std::vector<int>> triangles_;
};

} // namespace

std::unique_ptr<Side> splineSide(const std::string& path, const SideOptions& options) {
    return std::make_unique<SplineSide>(path, options);
}

} // namespace tokay::tool
