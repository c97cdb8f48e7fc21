// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapper/intersection/ProjectedCorners.hpp"

namespace tokay::mapper {

ProjectedCorners::ProjectedCorners(const SurfaceMesh& mesh, const SurfaceInterface& splines)
    : mesh_(mesh), splines_(splines), first_(mesh.vertices().rows(), -1) {}

ProjectedCorner ProjectedCorners::at(int triangle, int i, int piece) {
    const int number = mesh_.cornerNumbers(triangle)[i];
    if (number < static_cast<int>(first_.size())) {
        for (int entry = first_[number]; entry >= 0; entry = entries_[entry].next) {
            if (entries_[entry].piece == piece) {
                return entries_[entry].corner;
            }
        }
        entries_.push_back({piece, first_[number], projected(triangle, i, piece)});
        first_[number] = static_cast<int>(entries_.size()) - 1;
        return entries_.back().corner;
    }
    if (centre_ != number) {
        ofCentre_.clear();
    }
    centre_ = number;
    for (const Entry& entry : ofCentre_) {
        if (entry.piece == piece) {
            return entry.corner;
        }
    }
    ofCentre_.push_back({piece, -1, projected(triangle, i, piece)});
    return ofCentre_.back().corner;
}

ProjectedCorner ProjectedCorners::projected(int triangle, int i, int piece) const {
    return projectedCorner(splines_.piece(piece).patch.basis(), splines_.projector(piece),
                           splines_.isClosed(piece), mesh_.triangle(triangle).corner(i));
}

} // namespace tokay::mapper
