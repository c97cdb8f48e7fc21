// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled together, because reading OpenFOAM's headers takes most of the time
#include "pressureTolerance.C"
#include "couplingResidual.C"
#include "couplingInterval.C"
#include "sessionSetup.C"
#include "restartFiles.C"
#include "stepController.C"
#include "invertedCells.C"
#include "couplingSession.C"
