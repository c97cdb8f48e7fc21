// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/BrepModel.hpp"

#include "common/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace tokay::geometry {

namespace {

void requireUnique(const std::vector<std::string>& names, const char* kind) {
    std::set<std::string> seen;
    for (const std::string& name : names) {
        if (!seen.insert(name).second) {
            throw InputError(fmt::format("two {}s of the model are named \"{}\": give each its own "
                                         "name",
                                         kind, name));
        }
    }
}

int numberOf(const std::string& name, const std::vector<std::string>& names, const char* kind) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        throw InputError(
            fmt::format("the model has no {} \"{}\"; it has {}", kind, name,
                        names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    }
    return static_cast<int>(found - names.begin());
}

std::vector<std::string> namesOf(const std::vector<BrepFace>& faces) {
    std::vector<std::string> names;
    for (const BrepFace& face : faces) {
        names.push_back(face.patch.name());
    }
    return names;
}

std::vector<std::string> namesOf(const std::vector<BrepEdge>& edges) {
    std::vector<std::string> names;
    for (const BrepEdge& edge : edges) {
        names.push_back(edge.name);
    }
    return names;
}

} // namespace

BrepModel::BrepModel(std::vector<BrepFace> faces, std::vector<BrepEdge> edges, double tolerance,
                     std::vector<std::string> remarks)
    : faces_(std::move(faces)), edges_(std::move(edges)), tolerance_(tolerance),
      remarks_(std::move(remarks)) {
    if (faces_.empty()) {
        throw InputError("the model has no face: give it at least one");
    }
    requireUnique(namesOf(faces_), "face");
    requireUnique(namesOf(edges_), "edge");
    for (const BrepEdge& edge : edges_) {
        for (const BrepTrim& trim : edge.trims) {
            if (trim.face < 0 || trim.face >= static_cast<int>(faces_.size())) {
                throw InputError(
                    fmt::format("edge \"{}\" names face {}, but the model has {} (indices "
                                "start at 0)",
                                edge.name, trim.face, faces_.size()));
            }
            if (trim.curve < 0 || trim.curve >= nCurves(trim.face)) {
                throw InputError(fmt::format(
                    "edge \"{}\" names curve {} of face \"{}\", which has {} "
                    "(indices start at 0)",
                    edge.name, trim.curve, patch(trim.face).name(), nCurves(trim.face)));
            }
        }
    }
}

double BrepModel::size() const {
    Box box = Box::empty();
    for (const BrepFace& face : faces_) {
        box.include(Box::around(face.patch.surface().controlPoints()));
    }
    return box.diagonal();
}

int BrepModel::faceNumber(const std::string& name) const {
    return numberOf(name, namesOf(faces_), "face");
}

int BrepModel::edgeNumber(const std::string& name) const {
    return numberOf(name, namesOf(edges_), "edge");
}

int BrepModel::nCurves(int face) const {
    std::size_t n = faces_[face].embeddedCurves.size();
    for (const TrimmingLoop& loop : patch(face).loops()) {
        n += loop.curves().size();
    }
    return static_cast<int>(n);
}

const NurbsCurve& BrepModel::curve(int face, int number) const {
    std::size_t left = number;
    for (const TrimmingLoop& loop : patch(face).loops()) {
        if (left < loop.curves().size()) {
            return loop.curves()[left];
        }
        left -= loop.curves().size();
    }
    return faces_[face].embeddedCurves[left];
}

CurveOnSurface BrepModel::curveInSpace(const BrepTrim& trim) const {
    return CurveOnSurface(curve(trim.face, trim.curve), patch(trim.face).surface());
}

BrepModel BrepModel::refined(int degreeU, int degreeV, int nDivisionsU, int nDivisionsV) const {
    std::vector<BrepFace> faces;
    for (const BrepFace& face : faces_) {
        faces.push_back(
            {face.patch.refined(degreeU, degreeV, nDivisionsU, nDivisionsV), face.embeddedCurves});
    }
    return BrepModel(std::move(faces), edges_, tolerance_, remarks_);
}

} // namespace tokay::geometry
