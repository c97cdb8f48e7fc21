// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mapper/GapStatistics.hpp"
#include "mapper/Mapping.hpp"
#include "mapper/interface/CurveInterface.hpp"
#include "mapper/interface/SurfaceInterface.hpp"
#include "mapper/interface/SurfaceMesh.hpp"
#include "mapper/intersection/MortarAssembler.hpp"
#include "mapper/mortar/GradientTerm.hpp"
#include "mapper/mortar/MassInverse.hpp"

#include <optional>
#include <vector>

namespace tokay::mapper {

struct MortarOptions {
    MortarBasis basis = MortarBasis::standard;
    /// The gradient term is there for trimmed patches and their edges.
    SingularMass singular = SingularMass::refuse;
    GapLimit gapLimit;
    /// Gauss points an interval beyond those that integrate straight elements
    /// exactly: for curved and rational ones.
    int nExtraPoints = 2;
    /// Degree of the quadrature on the pieces into which mesh faces and knot spans
    /// of patches cut each other; 0: the sum of the patch's degrees.
    int patchQuadratureDegree = 0;
    /// Values of the destination that are the source's at their coordinates; the others are
    /// projected with these given. For the rim of an interface where walls constrain its points,
    /// which a projection would move.
    /// Source: Bernardi, Maday & Patera, 1994 (a mortar's values at its ends)
    std::vector<int> interpolated;
};

/// L2 projection: M_DD phi_D = M_DO phi_O, integrated on the intersection of the
/// two sides. Quadrature points beyond a gap limit that does not refuse are left
/// out on both sides, so a partly covered destination still takes constants exactly.
class MortarMapping : public Mapping {
  public:
    /// Between interfaces of curves: finite elements (lineMesh), splines, edges
    /// of trimmed patches, in any combination.
    /// @throws InputError for a gap beyond the limit
    /// @throws SolverError for a singular M_DD that is not to be regularised
    MortarMapping(const CurveInterface& from, const CurveInterface& to,
                  const MortarOptions& options = {});

    /// Between meshes of a surface, values at vertices or on faces on either side.
    /// Parts of the destination that no source face projects onto are left out
    /// and counted in the coverage.
    MortarMapping(const SurfaceMesh& from, const SurfaceMesh& to,
                  const MortarOptions& options = {});

    /// Maps from a mesh onto trimmed patches, integrated over the patches. Faces and
    /// parts of patches without a partner are left out.
    /// @throws InputError for the dual basis, which splines on patches do not have
    MortarMapping(const SurfaceMesh& from, const SurfaceInterface& to,
                  const MortarOptions& options = {});

    /// Maps from trimmed patches onto a mesh.
    MortarMapping(const SurfaceInterface& from, const SurfaceMesh& to,
                  const MortarOptions& options = {});

    /// Between trimmed patches on either side, integrated over the destination. The
    /// source's trimmed knot spans are cut into triangles whose chords leave them
    /// by 1e-3 of a span; these are projected into the destination's parameters and
    /// clipped there with its knot spans and loops. Each quadrature point lies on the
    /// destination, and its partner is the closest point of the source's surface, so
    /// fields that both sides hold are exact. What the chords cut off along a curved
    /// rim, about 1e-3 of a span wide, is left out on both sides.
    /// @throws InputError for the dual basis
    MortarMapping(const SurfaceInterface& from, const SurfaceInterface& to,
                  const MortarOptions& options = {});

    Eigen::MatrixXd apply(const Eigen::MatrixXd& values) const override;
    Eigen::MatrixXd applyTransposed(const Eigen::MatrixXd& forces) const override;

    /// M_DD, nTo x nTo (diagonal for the dual basis); of an interpolated value the diagonal only.
    const RowSparseMatrix& massMatrix() const { return mass_; }
    /// M_DO, nTo x nFrom, less what interpolated values contribute.
    const RowSparseMatrix& crossMatrix() const { return cross_; }

  private:
    /// Common part of the constructors, around their way to integrate.
    /// @param integrate  (MortarAssembler&, GapStatistics&)
    template <class From, class To, class Integrate>
    void build(const From& from, const To& to, const MortarOptions& options,
               MortarAssembler assembler, Integrate integrate, GradientTerm gradientTerm = {});
    void interpolate(const std::vector<int>& values, const Discretisation& from,
                     const Discretisation& to);
    void finish(MortarAssembler& assembler, const MortarOptions& options,
                const Discretisation& from, const Discretisation& to,
                const RowSparseMatrix& gradientTerm);

    RowSparseMatrix mass_, cross_;
    /// Source's slopes in the gradient term, nTo x nFrom; empty: there is none.
    RowSparseMatrix slopes_;
    std::optional<MassInverse> inverse_;
};

} // namespace tokay::mapper
