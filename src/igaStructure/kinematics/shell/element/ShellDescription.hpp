// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/brep/BrepModel.hpp"
#include "geometry/trimming/PatchQuadrature.hpp"
#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/Field.hpp"
#include "igaStructure/assembly/SupportTrace.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tokay::structure {

using ShellMaterial = ElasticMaterial;

/// Support of an edge.
struct EdgeSupport {
    /// The edge: trimming curves of faces.
    std::vector<geometry::BrepTrim> trims;
    std::array<bool, 3> fixed = {false, false, false};
    /// True if the surface cannot turn about the edge.
    bool clamped = false;
    /// By penalty even where the basis could do it exactly.
    bool weak = false;
    SupportMotion motion = nullptr;
    std::string name = {};
};

/// Support of a point of a face.
struct PointSupport {
    int face = 0;
    geometry::Parameters at;
    std::array<bool, 3> fixed = {false, false, false};
    SupportMotion motion = nullptr;
    std::string name = {};
};

/// Loads of a shell; those that follow the deformation are pressure and moment.
struct ShellLoads {
    struct Traction {
        int face;
        VectorField traction; ///< per reference area [Pa]
    };
    struct Pressure {
        std::vector<int> faces;
        ScalarField pressure; ///< along a1 x a2, on the current area [Pa]
    };
    struct EdgeForce {
        geometry::BrepTrim trim;
        VectorField force; ///< per reference length [N/m]
    };
    struct EdgeMoment {
        geometry::BrepTrim trim;
        ScalarField moment; ///< turns a1 x a2 outwards across the edge [N]
    };
    struct PointForce {
        int face;
        geometry::Parameters at;
        VectorField force; ///< [N]
    };

    std::vector<Traction> tractions;
    std::vector<Pressure> pressures;
    std::vector<VectorField> gravities; ///< acceleration [m/s^2]
    std::vector<EdgeForce> edgeForces;
    std::vector<EdgeMoment> edgeMoments;
    std::vector<PointForce> pointForces;
};

/// How patches are joined along edges, and edges held weakly.
enum class EdgeMethod {
    penalty,
    nitsche,  ///< linear strains; St. Venant-Kirchhoff material if there is bending
    lagrange, ///< multipliers with a small compliance
    egm ///< extended gradient method: supports of trimming curves are strong, all else as usual
};

/// The strong form in the extended gradient method's functional.
enum class EgmResidual {
    none,     ///< whatever the physics
    physical, ///< on what trimming leaves of elements
    whole     ///< on whole elements, where loads are formulas that go on
};

/// What makes control values next to a supported trimming curve go on from the others.
enum class EgmContinuation {
    jumps,   ///< gamma sum_F h^2p int_F [d^p u]^2 over faces between elements
    gradient ///< h int (d_n u - g)^2 over cut elements, g by moving least squares
};

/// Whether that is solved for at once or by iteration.
enum class EgmForm { closed, iterated };

/// The extended gradient method: how control values next to a supported trimming curve
/// follow from the others. They minimise
///   int_Gamma (u - uBar)^2 + continuation + delta / h int (r / s)^2,
/// r being the residual of the strong form and s the stiffness that makes it a displacement.
struct EgmOptions {
    EgmContinuation continuation = EgmContinuation::jumps;
    EgmForm form = EgmForm::closed;
    /// With jumps. Not given: whole for linear strains, else none.
    std::optional<EgmResidual> residual = std::nullopt;
    /// Not given: 0.5 at degree 1, else 0.01.
    std::optional<double> gamma = std::nullopt;
    double delta = 1;
    double tolerance = 1e-6; ///< iterated: relative change of the displacement
    int maxIterations = 100;
};

/// Treatment of elements of which trimming leaves a sliver.
enum class SliverTreatment {
    scaling,  ///< unknowns are scaled, as always
    extension ///< their functions are tied to those of whole elements, too
};

/// Description of a shell or membrane: model, material, supports, loads and joints.
struct ShellDescription {
    /// Faces in the basis of the displacement; they are joined at edges of two or
    /// more trims, displacement and angle.
    geometry::BrepModel model;
    std::vector<double> thickness; ///< of each face [m]
    ShellMaterial material = {};
    /// Material of each face; empty: material. Damping and law are those of material.
    std::vector<ShellMaterial> faceMaterial = {};
    const ShellMaterial& materialOf(int face) const {
        return faceMaterial.empty() ? material : faceMaterial[face];
    }
    Strains strains = Strains::nonlinear;
    bool bending = true; ///< false: a membrane
    /// Prestress of a membrane: 11, 22, 12 in the frame of the first parameter line [Pa].
    Eigen::Vector3d prestress = Eigen::Vector3d::Zero();
    std::vector<EdgeSupport> edgeSupports = {};
    std::vector<PointSupport> pointSupports = {};
    ShellLoads loads = {};
    /// If not given: penalty if its springs are given below. Else, as measured best
    /// (benchmarks/shells), nitsche for linear strains, lagrange for nonlinear ones.
    std::optional<EdgeMethod> edgeMethod = std::nullopt;
    EdgeMethod chosenEdgeMethod() const { return edgeMethod.value_or(usualEdgeMethod()); }
    /// The method where egm does not apply: joints, points, curves within a patch.
    EdgeMethod weakEdgeMethod() const {
        return chosenEdgeMethod() == EdgeMethod::egm ? usualEdgeMethod() : chosenEdgeMethod();
    }
    EdgeMethod usualEdgeMethod() const {
        const bool canNitsche = strains == Strains::linear &&
                                (!bending || material.law == MaterialLaw::stVenantKirchhoff);
        const EdgeMethod best = canNitsche ? EdgeMethod::nitsche : EdgeMethod::lagrange;
        return penalty ? EdgeMethod::penalty : best;
    }
    /// penalty, lagrange: stiffness of springs that hold weakly, over
    /// E t / ((1 - nu^2) h) and E t^3 / (12 (1 - nu^2) h), h being the size of an element;
    /// 1e3 and 1e6 if not given. nitsche: factor on the stabilisation, 1 if not given.
    std::optional<double> penalty = std::nullopt;
    EgmOptions egm = {};
    SliverTreatment sliverTreatment = SliverTreatment::extension;
    /// A membrane in the plane z = 0 that stays there: a plane solid.
    bool isPlane = false;
    geometry::QuadratureOptions cutRule = {};
};

} // namespace tokay::structure
