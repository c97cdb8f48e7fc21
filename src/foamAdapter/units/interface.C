// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled together, because reading OpenFOAM's headers takes most of the time
#include "couplingInterface.C"
#include "correctedPressure.C"
#include "interfaceForce.C"
#include "conservationAudit.C"
