// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Formula.hpp"
#include "common/Schema.hpp"
#include "igaStructure/assembly/ElasticMaterial.hpp"
#include "igaStructure/assembly/Field.hpp"
#include "igaStructure/assembly/SupportTrace.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace tokay::structure {

inline const Choices<Strains>& strainChoices() {
    static const Choices<Strains> choices = {
        {"linear", Strains::linear, "small strains and rotations."},
        {"nonlinear", Strains::nonlinear,
         "Green-Lagrange strains, any rotation (total Lagrangian)."}};
    return choices;
}

/// Entries of `model` that every kinematics has.
struct ModelEntries : Located {
    std::string kinematics;
    Strains strains = Strains::linear;

    static SchemaOf<ModelEntries> schema() {
        return {
            {"kinematics", &ModelEntries::kinematics, "The kinematics of this table.", required},
            {"strains", &ModelEntries::strains, strainChoices(), "Strain measure.", required}};
    }
};

/// Entry `model.thickness` [m] of the kinematics that have one.
template <class Model>
EntryOf<Model> thicknessEntry(const std::string& whose) {
    return {"thickness", &Model::thickness, "(0, inf)", "m", "Thickness of the " + whose + ".",
            required};
}

/// Material laws that a kinematics can use.
enum class Laws { linear, compressible, all };

/// Entries of `material`.
SchemaOf<ElasticMaterial> materialSchema(Laws laws);

template <Laws laws>
struct MaterialEntries : ElasticMaterial {
    static const SchemaOf<MaterialEntries>& schema() {
        static const SchemaOf<MaterialEntries> schema =
            SchemaOf<MaterialEntries>().with(materialSchema(laws));
        return schema;
    }

    ElasticMaterial material() const {
        ElasticMaterial material = *this;
        if (law == MaterialLaw::incompressibleNeoHookean) {
            material.poissonsRatio = 0.5;
        }
        return material;
    }
};

/// What a support fixes: a displacement component, or the rotation of an edge or end.
enum class Fixed { x, y, z, rotation };

/// Choices of `fix`.
const Choices<Fixed>& planeComponents();       ///< x, y
const Choices<Fixed>& spatialComponents();     ///< x, y, z
const Choices<Fixed>& componentsAndRotation(); ///< x, y, z, rotation

template <std::size_t nComponents>
std::array<bool, nComponents> fixedComponents(const std::vector<Fixed>& fix) {
    std::array<bool, nComponents> fixed;
    for (std::size_t c = 0; c < nComponents; ++c) {
        fixed[c] = std::find(fix.begin(), fix.end(), static_cast<Fixed>(c)) != fix.end();
    }
    return fixed;
}

constexpr auto supportDisplacementMeaning =
    "Displacement there of the components in `fix`, along all axes; 0 for a component that is not "
    "in `fix`. The body follows it exactly where its basis can, else as closely. Time integration "
    "makes velocity and acceleration of it.";

/// The motion that an entry `displacement` prescribes; none: at rest.
/// @param support  for messages
/// @param fixed    components that the support holds
/// @throws InputError if another component has a formula
SupportMotion supportMotion(const Located& support, const std::vector<Formula>& displacement,
                            const std::vector<bool>& fixed);

/// @param displacement  an optional list of formulas
template <class Displacement, std::size_t nComponents>
SupportMotion supportMotion(const Located& support, const Displacement& displacement,
                            const std::array<bool, nComponents>& fixed) {
    if (!displacement) {
        return nullptr;
    }
    return supportMotion(support, std::vector<Formula>(displacement->begin(), displacement->end()),
                         std::vector<bool>(fixed.begin(), fixed.end()));
}

/// Fields of place and time.
VectorField vectorField(const std::array<Formula, 3>& components);
ScalarField scalarField(const Formula& formula);

} // namespace tokay::structure
