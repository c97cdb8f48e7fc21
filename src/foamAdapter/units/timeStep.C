// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled together, because reading OpenFOAM's headers takes most of the time
#include "crankNicolsonRates.C"
#include "fluidSnapshot.C"
#include "fluidPredictor.C"
#include "stepRetry.C"
#include "displacementSource.C"
#include "couplingFvOption.C"
#include "structureCoupling.C"
#include "structureDisplacementPointPatchVectorField.C"
