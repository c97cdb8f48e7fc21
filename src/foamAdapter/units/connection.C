// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled together, because reading OpenFOAM's headers takes most of the time
#include "dictionaryChecks.C"
#include "abortNotifier.C"
#include "structureProcess.C"
#include "structureConnection.C"
