// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/InterfaceTransfer.hpp"

#include "common/errors.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/mortar/MortarMapping.hpp"
#include "mapper/mortar/rimVertices.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"
#include "mapper/nearest/SampledMapping.hpp"
#include "mapper/offset/LinearisedMapping.hpp"
#include "mapper/offset/OffsetMapping.hpp"
#include "mapper/rbf/RbfMapping.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace tokay::structure {

using Eigen::VectorXd;
using geometry::Points;
using mapper::Mapping;

namespace {

// A control point's components one after the other, as unknowns are numbered.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

using mapper::FaceMesh;
using mapper::SplineInterface;
using mapper::SurfaceInterface;

mapper::CurveInterface meshOf(const SplineInterface&, const FaceMesh& to) {
    std::vector<std::array<int, 2>> edges;
    for (const std::vector<int>& face : to.faces) {
        edges.push_back({face.front(), face.back()});
    }
    return mapper::lineMesh(to.vertices, edges);
}

mapper::SurfaceMesh meshOf(const SurfaceInterface&, const FaceMesh& to) {
    return mapper::SurfaceMesh(to.vertices, to.faces, mapper::ValuesAt::vertices);
}

mapper::LoadPoints integratedOver(const SplineInterface& from, const FaceMesh& faces, double) {
    return mapper::integratedLoads(from, faces);
}

mapper::LoadPoints integratedOver(const SurfaceInterface& from, const FaceMesh& faces,
                                  double gapLimit) {
    return mapper::integratedLoads(from, faces, gapLimit * from.size());
}

template <class Surface>
std::unique_ptr<const Mapping> mortarMapping(const Surface& from, const FaceMesh& to,
                                             mapper::MortarBasis basis,
                                             const mapper::GapLimit& limit) {
    mapper::MortarOptions options;
    options.basis = basis;
    options.gapLimit = limit;
    // Where other patches of the fluid constrain points
    options.interpolated = mapper::rimVertices(to.faces);
    auto mapping = std::make_unique<mapper::MortarMapping>(from, meshOf(from, to), options);
    if (const int n = mapping->report().nUncovered; n > 0) {
        throw InputError(fmt::format(
            "coupling.mapping.type: the structure lies beside none of the faces around {} of the "
            "fluid's {} points, so mortar gives them no displacement; use nearestElement, for a "
            "thin "
            "body offset",
            n, to.vertices.rows()));
    }
    return mapping;
}

// Distances to samples say nothing about gaps.
template <class Surface>
std::unique_ptr<const Mapping> sampledMapping(TransferMethod method, const Surface& from,
                                              const Points& to, const mapper::GapLimit& limit) {
    mapper::GapStatistics gaps(limit, from.size());
    for (Eigen::Index i = 0; i < to.rows(); ++i) {
        const mapper::Location at = from.locate(to.row(i));
        gaps.count(to.row(i), at.gap, at.converged, at.ambiguous);
    }
    mapper::MappingReport unused;
    gaps.enter(unused);
    mapper::SplineSamples samples = mapper::splineSamples(from);
    constexpr mapper::GapLimit everywhere{std::numeric_limits<double>::infinity(), false};
    std::unique_ptr<const Mapping> mapping;
    if (method == TransferMethod::rbf) {
        mapper::RbfOptions options;
        options.gapLimit = everywhere;
        mapping = std::make_unique<mapper::RbfMapping>(samples.points, to, options);
    } else {
        mapping = std::make_unique<mapper::NearestElementMapping>(
            mapper::PointCloud(samples.points), to, everywhere);
    }
    return std::make_unique<mapper::SampledMapping>(std::move(samples), std::move(mapping));
}

template <class Surface>
std::unique_ptr<const Mapping> offsetMapping(const Surface& from, const Points& to,
                                             const mapper::GapLimit& limit, bool isLinear) {
    auto offset = std::make_unique<mapper::OffsetMapping>(from, to, limit);
    if (isLinear) {
        return std::make_unique<mapper::LinearisedMapping>(*offset);
    }
    return offset;
}

// The quadrature points of a body with linear strains are summed up once and for all, to
// a mapping to the faces.
LoadMapping linearLoads(const WetSurface& from, const mapper::LoadPoints& at, const FaceMesh& faces,
                        const mapper::GapLimit& limit) {
    mapper::LoadPoints atCentres{at.shares.transpose() * at.points,
                                 mapper::RowSparseMatrix(faces.nFaces(), faces.nFaces())};
    atCentres.shares.setIdentity();
    auto mapping = std::visit(
        [&](const auto& surface) {
            return std::make_unique<mapper::LinearisedMapping>(
                mapper::OffsetMapping(surface, at.points, limit), at.shares);
        },
        from);
    return {std::move(atCentres), std::move(mapping), false};
}

} // namespace

std::unique_ptr<const Mapping> makeMapping(TransferMethod method, const WetSurface& from,
                                           const FaceMesh& to, const mapper::GapLimit& limit,
                                           bool isLinear) {
    return std::visit(
        [&](const auto& surface) -> std::unique_ptr<const Mapping> {
            switch (method) {
            case TransferMethod::offset:
                return offsetMapping(surface, to.vertices, limit, isLinear);
            case TransferMethod::mortar:
                return mortarMapping(surface, to, mapper::MortarBasis::standard, limit);
            case TransferMethod::dualMortar:
                return mortarMapping(surface, to, mapper::MortarBasis::dual, limit);
            case TransferMethod::nearestNeighbour:
            case TransferMethod::rbf:
                return sampledMapping(method, surface, to.vertices, limit);
            case TransferMethod::nearestElement:
                break;
            }
            return std::make_unique<mapper::NearestElementMapping>(surface, to.vertices, limit);
        },
        from);
}

LoadMapping makeLoadMapping(const Coupling& coupling, const WetSurface& from, const FaceMesh& faces,
                            bool isLinear) {
    if (coupling.loads == LoadTransfer::transposed) {
        const bool isMortar = coupling.method == TransferMethod::mortar ||
                              coupling.method == TransferMethod::dualMortar;
        return {mapper::loadsAtVertices(faces), nullptr, !isMortar};
    }
    mapper::LoadPoints at = std::visit(
        [&](const auto& surface) { return integratedOver(surface, faces, coupling.gapLimit); },
        from);
    // Gaps are those of the fluid's points.
    const mapper::GapLimit limit{coupling.gapLimit, false};
    const bool isOffset = coupling.method == TransferMethod::offset;
    if (isOffset && isLinear) {
        return linearLoads(from, at, faces, limit);
    }
    const TransferMethod method =
        isOffset ? TransferMethod::offset : TransferMethod::nearestElement;
    std::unique_ptr<const Mapping> mapping =
        makeMapping(method, from, {at.points, {}}, limit, isLinear);
    return {std::move(at), std::move(mapping), false};
}

InterfaceTransfer::InterfaceTransfer(const StructuralModel& model, Points controlPoints,
                                     std::unique_ptr<const Mapping> displacements,
                                     LoadMapping loads, mapper::FaceSizes sizes, double depth)
    : model_(model), controlPoints_(std::move(controlPoints)),
      displacements_(std::move(displacements)), loads_(std::move(loads)), sizes_(sizes),
      depth_(depth) {}

Points InterfaceTransfer::controlDisplacements(const VectorXd& unknowns) const {
    const VectorXd flat = model_.controlDisplacements(unknowns);
    const int n = model_.nComponents();
    Points values = Points::Zero(flat.size() / n, 3);
    values.leftCols(n) = Eigen::Map<const Rows>(flat.data(), flat.size() / n, n);
    return values;
}

Points InterfaceTransfer::displacements(const VectorXd& displacement) const {
    return displacements_->moved(controlDisplacements(displacement));
}

Points InterfaceTransfer::variation(const VectorXd& displacement, const VectorXd& variation) const {
    return displacements_->variation(controlDisplacements(displacement),
                                     controlDisplacements(variation));
}

Points InterfaceTransfer::controlForces(const VectorXd& displacement, const Points& onFaces) const {
    const Mapping& mapping = loads_.mapping ? *loads_.mapping : *displacements_;
    return mapping.forces(controlDisplacements(displacement), loads_.at.onPoints(onFaces));
}

VectorXd InterfaceTransfer::forces(const VectorXd& displacement, const Points& onFaces) const {
    return onUnknowns(controlForces(displacement, onFaces));
}

VectorXd InterfaceTransfer::onUnknowns(const Points& controlForces) const {
    const Rows values = depth_ * controlForces.leftCols(model_.nComponents());
    return model_.onUnknowns(Eigen::Map<const VectorXd>(values.data(), values.size()));
}

std::string InterfaceTransfer::report() const {
    std::string text = "displacements of the fluid's points, " + displacements_->report().text();
    if (loads_.mapping) {
        text += "\nforces of the fluid's faces, integrated, " + loads_.mapping->report().text();
    }
    if (sizes_.nFaces > 0) {
        text += fmt::format("  a face measures {:.3g} to {:.3g} knot spans\n", sizes_.smallest,
                            sizes_.largest);
    }
    if (loads_.loadsPoints && sizes_.nOverSpan > 0) {
        text += fmt::format(
            "  WARNING: {} of {} faces are larger than a knot span and load only some of those "
            "that they cover, so the structure sags between the fluid's points: use "
            "coupling.mapping.loads: integrated\n",
            sizes_.nOverSpan, sizes_.nFaces);
    }
    return text;
}

} // namespace tokay::structure
