// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/cadJson.hpp"
#include "geometry/trimming/patchTriangles.hpp"
#include "mapper/interface/CurveInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/interface/normalSlopes.hpp"
#include "tokayMap/Side.hpp"
#include "tokayMap/files/writeField.hpp"
#include "tokayMap/splineProjection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

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

/// A trimming curve in the basis of its piece.
struct NamedCurve {
    int piece;
    geometry::CurveOnSurface curve;
};

std::vector<NamedCurve> namedCurves(const geometry::BrepModel& model,
                                    const mapper::SurfaceInterface& splines,
                                    const std::vector<std::string>& edges) {
    std::vector<NamedCurve> curves;
    for (const std::string& name : edges) {
        for (const geometry::BrepTrim& trim : model.edges()[model.edgeNumber(name)].trims) {
            curves.push_back(
                {trim.face, geometry::CurveOnSurface(model.curve(trim.face, trim.curve),
                                                     splines.piece(trim.face).patch.basis())});
        }
    }
    return curves;
}

class SplineSide : public Side {
  public:
    SplineSide(const std::string& path, const geometry::BrepModel& model,
               const SideOptions& options)
        : path_(path), splines_(interfaceOf(model, options)) {
        for (int piece = 0; options.edges.empty() && piece < splines_.nPieces(); ++piece) {
            addSamples(piece);
        }
        if (!options.edges.empty()) {
            setEdges(namedCurves(model, splines_, options.edges));
        }
    }

    std::string description() const override {
        return fmt::format("{}: {} patches, {} elements, {} control points, size {:.4g} m{}", path_,
                           splines_.nPieces(), splines_.nElements(), splines_.nValues(),
                           discretisation().size(),
                           edges_ ? fmt::format(", {} edges", edges_->nCurves()) : "");
    }

    const mapper::Discretisation& discretisation() const override {
        return edges_ ? static_cast<const mapper::Discretisation&>(*edges_) : splines_;
    }
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
        writeField(path, {points_, cells_, ValuesAt::vertices}, field, samples);
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
            cells_.push_back({first + corners[0], first + corners[1], first + corners[2]});
        }
        points_.conservativeResize(first + mesh.points.rows(), 3);
        points_.bottomRows(mesh.points.rows()) = mesh.points;
    }

    void setEdges(std::vector<NamedCurve> curves) {
        std::vector<std::unique_ptr<mapper::InterfaceCurve>> pieces;
        for (NamedCurve& named : curves) {
            for (const geometry::ParameterBox& box : mapper::cutElements(named.curve)) {
                addElement(named.piece, box);
            }
            pieces.push_back(mapper::interfaceCurve(std::move(named.curve),
                                                    splines_.piece(named.piece).controlPoints));
        }
        edges_.emplace(std::move(pieces), splines_.coordinates());
    }

    void addElement(int piece, const geometry::ParameterBox& box) {
        constexpr int n = 4; // parts of an element's side
        const auto first = static_cast<int>(places_.size());
        points_.conservativeResize(first + (n + 1) * (n + 1), 3);
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i <= n; ++i) {
                const geometry::Parameters at(box.lower.x() + i * box.size().x() / n,
                                              box.lower.y() + j * box.size().y() / n);
                points_.row(static_cast<Eigen::Index>(places_.size())) =
                    splines_.piece(piece).patch.basis().point(at[0], at[1]);
                places_.push_back({piece, at});
            }
        }
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const int corner = first + i + (n + 1) * j;
                cells_.push_back({corner, corner + 1, corner + n + 2, corner + n + 1});
            }
        }
    }

    std::string path_;
    mapper::SurfaceInterface splines_;
    std::optional<mapper::CurveInterface> edges_; ///< the side, in place of the surface
    std::vector<Place> places_;
    Points points_;
    std::vector<std::vector<int>> cells_;
};

} // namespace

std::unique_ptr<Side> splineSide(const std::string& path, const SideOptions& options) {
    return std::make_unique<SplineSide>(path, geometry::readCadJson(path), options);
}

} // namespace tokay::tool
