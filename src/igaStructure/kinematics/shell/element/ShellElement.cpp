// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/kinematics/shell/element/ShellElement.hpp"

#include "igaStructure/kinematics/shell/element/ShellPatch.hpp"

namespace tokay::structure {

void ShellElement::moveTo(const ShellPatch& patch, int i, int j) {
    const geometry::NurbsSurface& surface = patch.surface();
    if (patch_ != &patch) {
        patch_ = &patch;
        nodes_.resize(patch.nFunctions());
        coordinates_.resize(3, patch.nFunctions());
        weights_.resize(surface.isRational() ? patch.nFunctions() : 0);
        functions_.emplace(patch.nFunctions());
    }
    i_ = i;
    j_ = j;
    const int nU = patch.u().nFunctions();
    for (int b = 0; b < patch.v().nFunctions(); ++b) {
        const int first =
            patch.u().firstFunction(i) + surface.u().nBasis() * (patch.v().firstFunction(j) + b);
        for (int a = 0; a < nU; ++a) {
            nodes_[a + nU * b] = patch.nodes()[first + a];
            coordinates_.col(a + nU * b) = surface.controlPoints().row(first + a).transpose();
        }
        if (surface.isRational()) {
            weights_.segment(nU * b, nU) = surface.weights().segment(first, nU);
        }
    }
    const int element = patch.patch().elementNumber(i, j);
    const geometry::ElementState state = patch.patch().state(element);
    isCut_ = state == geometry::ElementState::cut;
    nPoints_ = isCut_ ? static_cast<int>(patch.cutPoints(element).size())
                      : patch.u().nPointsPerSpan() * patch.v().nPointsPerSpan();
    if (state == geometry::ElementState::empty) {
        nPoints_ = 0;
    }
}

void ShellElement::moveToPoint(int point) {
    double weight = 0;
    if (isCut_) {
        const auto& cut = patch_->cutPoints(patch_->patch().elementNumber(i_, j_))[point];
        functions_->set(cut.functions);
        weight = cut.weight;
    } else {
        const TabulatedBasis& u = patch_->u();
        const TabulatedBasis& v = patch_->v();
        const int pointU = point % u.nPointsPerSpan();
        const int pointV = point / u.nPointsPerSpan();
        functions_->setProducts(u.at(i_, pointU), v.at(j_, pointV), weights_);
        weight = u.weight(i_, pointU) * v.weight(j_, pointV);
    }
    reference_.emplace(functions_->derivatives(coordinates_));
    area_ = weight * reference_->normal.area();
}

void ShellElement::moveToPlace(const Eigen::Vector2d& parameters) {
    const geometry::KnotVector& u = patch_->surface().u();
    const geometry::KnotVector& v = patch_->surface().v();
    functions_->setProducts(u.basisDerivatives(u.findSpan(u.breakpoints()[i_]), parameters[0], 2),
                            v.basisDerivatives(v.findSpan(v.breakpoints()[j_]), parameters[1], 2),
                            weights_);
    reference_.emplace(functions_->derivatives(coordinates_));
}

void ShellElement::gather(const Eigen::VectorXd& values, Coefficients& local) const {
    local.resize(3, nFunctions());
    for (int k = 0; k < nFunctions(); ++k) {
        local.col(k) = values.segment<3>(3 * nodes_[k]);
    }
}

void ShellElement::scatter(const Coefficients& local, Eigen::VectorXd& values) const {
    for (int k = 0; k < nFunctions(); ++k) {
        values.segment<3>(3 * nodes_[k]) += local.col(k);
    }
}

} // namespace tokay::structure
