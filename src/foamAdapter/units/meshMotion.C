// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled together, because reading OpenFOAM's headers takes most of the time
#include "harmonicBasis.C"
#include "interfaceFunctions.C"
#include "harmonicExtension.C"
#include "harmonicBasisMotionSolver.C"
#include "laplacianMotion.C"
#include "limitedDiffusivity.C"
#include "powerDiffusivity.C"
#include "motionFallback.C"
#include "motionConstraints.C"
#include "movingBoundary.C"
#include "coupledMotionSolverFvMesh.C"
