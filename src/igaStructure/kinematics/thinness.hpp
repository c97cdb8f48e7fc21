// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/spline/NurbsCurve.hpp"
#include "geometry/spline/NurbsSurface.hpp"

#include <string>

namespace tokay::structure {

/// Largest curvature in the middle of an element [1/m].
double largestCurvature(const geometry::NurbsCurve& curve);

/// Largest principal curvature in the middle of an element [1/m].
double largestCurvature(const geometry::NurbsSurface& surface);

/// Advice on a body so thin that its bending stiffness is lost beside its stretching
/// stiffness; empty for others. For the end of a sentence.
/// @param slenderness  size over thickness
std::string tooThinToBend(double slenderness);

/// By how much Euler-Bernoulli theory overestimates the frequency of a cantilever's
/// bending mode, relative: it leaves out shear deformation and rotary inertia. Rayleigh's
/// quotient with its mode, for a rectangular section of shear factor 5/6 and Poisson's
/// ratio 0.3 (Timoshenko 1921; integrals of the modes: Young & Felgar 1949).
/// @param slenderness  length over thickness
/// @param mode  1, 2 or 3
double bendingOverestimate(double slenderness, int mode);

/// How far from supports the bending stiffness of a membrane or cable, which the
/// model leaves out, would matter: t sqrt(stiffness / (12 prestress)), the length
/// over which a stretched strip's deflection leaves a clamp. For the end of a
/// sentence; empty without prestress.
/// @param stiffness  of stretching
/// @param prestress  in the same unit
std::string leftOutBending(double thickness, double stiffness, double prestress);

} // namespace tokay::structure
