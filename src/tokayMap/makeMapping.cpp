// SPDX-License-Identifier: GPL-3.0-or-later
#include "tokayMap/makeMapping.hpp"

#include "common/errors.hpp"
#include "mapper/interface/PointCloud.hpp"
#include "mapper/nearest/NearestElementMapping.hpp"

#include <fmt/format.h>

namespace tokay::tool {

namespace {

using mapper::CurveInterface;
using mapper::Discretisation;
using mapper::Mapping;
using mapper::MortarMapping;
using mapper::MortarOptions;
using mapper::SurfaceInterface;
using mapper::SurfaceMesh;

mapper::GapLimit limited(mapper::GapLimit limit, const OperatorOptions& options) {
    limit.relative = options.gapLimit.value_or(limit.relative);
    limit.refuse = !options.allowGaps;
    return limit;
}

void requireValuesAtPoints(const Side& from, const char* name) {
    if (from.hasSplines()) {
        throw InputError(fmt::format("{}: the values of control points are coefficients, not "
                                     "values at points, so {} cannot map from them; choose "
                                     "nearestElement or mortar",
                                     from.description(), name));
    }
}

/// Mortar mapping between sides of these kinds; null if they are of others.
template <class From, class To>
std::unique_ptr<Mapping> mortarBetween(const Discretisation& from, const Discretisation& to,
                                       const MortarOptions& options) {
    const auto* first = dynamic_cast<const From*>(&from);
    const auto* second = dynamic_cast<const To*>(&to);
    if (!first || !second) {
        return nullptr;
    }
    return std::make_unique<MortarMapping>(*first, *second, options);
}

std::unique_ptr<Mapping> mortar(const Side& from, const Side& to, const OperatorOptions& options) {
    MortarOptions mortarOptions = options.mortar;
    mortarOptions.gapLimit = limited(mortarOptions.gapLimit, options);
    for (const auto make :
         {mortarBetween<CurveInterface, CurveInterface>, mortarBetween<SurfaceMesh, SurfaceMesh>,
          mortarBetween<SurfaceMesh, SurfaceInterface>,
          mortarBetween<SurfaceInterface, SurfaceMesh>,
          mortarBetween<SurfaceInterface, SurfaceInterface>}) {
        if (auto mapping = make(from.discretisation(), to.discretisation(), mortarOptions)) {
            return mapping;
        }
    }
    throw InputError(fmt::format("mortar does not map between lines and surfaces:\n  {}\n  "
                                 "{}\nchoose nearestElement",
                                 from.description(), to.description()));
}

std::unique_ptr<Mapping> radial(const Side& from, const Side& to, const OperatorOptions& options) {
    requireValuesAtPoints(from, "rbf");
    mapper::RbfOptions rbfOptions = options.rbf;
    rbfOptions.gapLimit = limited(rbfOptions.gapLimit, options);
    return std::make_unique<mapper::RbfMapping>(from.discretisation().coordinates(),
                                                to.samplePoints(), rbfOptions);
}

std::unique_ptr<Mapping> nearest(const Discretisation& from, const Side& to,
                                 const OperatorOptions& options) {
    return std::make_unique<mapper::NearestElementMapping>(from, to.samplePoints(),
                                                           limited(mapper::GapLimit{}, options));
}

} // namespace

bool givesValues(Operator kind) {
    return kind == Operator::mortar;
}

std::unique_ptr<Mapping> makeMapping(const Side& from, const Side& to,
                                     const OperatorOptions& options) {
    switch (options.kind) {
    case Operator::mortar:
        return mortar(from, to, options);
    case Operator::rbf:
        return radial(from, to, options);
    case Operator::nearestNeighbour:
        requireValuesAtPoints(from, "nearestNeighbour");
        return nearest(mapper::PointCloud(from.discretisation().coordinates()), to, options);
    case Operator::nearestElement:
        return nearest(from.discretisation(), to, options);
    }
    throw InputError("no such operator");
}

} // namespace tokay::tool
