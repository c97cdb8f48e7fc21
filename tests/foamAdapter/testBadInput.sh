#!/usr/bin/env bash
# A mistake in the input ends the run at its start: one message that says what is
# wrong, where, and what to change.
source "$(dirname "$0")/harness.sh"

# expectRefusal TEXT...: the run does not start, and says this
expectRefusal()
{
    runFaultyFluid
    expectText log.pimpleFoam "$@"
    expectNoText log.pimpleFoam "Time = "
    [ ! -s log.igaStructure ] || fail "the structure was started in vain"
}

property library "without the adapter's library the run does not go on uncoupled"
library()
{
    makeCase fluid
    useLaplacian
    FOAM_USER_LIBBIN=$PWD LD_LIBRARY_PATH= expectRefusal \
        'libtokayFoamAdapter.so: cannot open shared object file' "Unknown patchField type structureDisplacement"
}

property libraryNotNamed "without its name in controlDict the run does not go on uncoupled"
libraryNotNamed()
{
    makeCase fluid
    useLaplacian
    removeEntry system/controlDict libs
    expectRefusal "Unknown patchField type structureDisplacement" "0/pointDisplacement"
}

property program "a structure program that is not there is named"
program()
{
    makeCase fluid
    coupling structure.program '"noSuchProgram"'
    expectRefusal "the structure's program 'noSuchProgram' cannot be started: No such file or directory" \
        "Source Tokay's bin/environment" "controlDict.functions.structure"
}

property notExecutable "a structure program that is no program is named"
notExecutable()
{
    makeCase fluid
    printf 'text\n' > noProgram
    coupling structure.program "\"$PWD/noProgram\""
    expectRefusal "noProgram' cannot be started: Permission denied"
}

property caseFolder "a case file in a folder that is not there is named"
caseFolder()
{
    makeCase fluid
    coupling structure.case '"nowhere/case.yaml"'
    expectRefusal "fluid/nowhere/log.igaStructure' cannot be written: No such file or directory" \
        "Does the folder of the entry 'case' exist?"
}

property patch "an unknown patch is refused, and the patches are listed"
patch()
{
    makeCase fluid
    coupling patches '(flap falp)'
    expectRefusal "no patch matches 'falp' of the entry 'patches'" \
        "(inlet outlet flap upperWall lowerWall frontAndBack)" "controlDict.functions.structure"
}

property noPatch "an interface without a face is refused"
noPatch()
{
    makeCase fluid
    coupling patches '()'
    expectRefusal "the entry 'patches' names no patch with faces" "controlDict.functions.structure"
}

property emptyPatch "a patch of the empty direction is refused"
emptyPatch()
{
    makeCase fluid
    coupling patches '(flap frontAndBack)'
    expectRefusal "patch 'frontAndBack' of the entry 'patches' is of type empty: a structure needs a wall"
}

property condition "a coupled patch with another condition on pointDisplacement is refused"
condition()
{
    makeCase fluid
    useLaplacian
    entry 0/pointDisplacement boundaryField.flap.type fixedValue
    expectRefusal "pointDisplacement has 'fixedValue' on the coupled patch 'flap'" \
        "it must be 'structureDisplacement'"
}

property uncoupledPatch "a patch with the condition that no coupling has is refused"
uncoupledPatch()
{
    makeCase fluid
    sed -i 's/^    flap$/    "(flap|upperWall)"/; s/|upperWall|/|/' 0/pointDisplacement
    runFaultyFluid
    expectText log.pimpleFoam "patch 'upperWall' has the condition 'structureDisplacement' but no function object 'structureCoupling' couples it"
}

property noCoupling "the condition without the function object is refused"
noCoupling()
{
    makeCase fluid
    removeEntry system/controlDict functions.structure
    runFaultyFluid
    expectText log.pimpleFoam "patch 'flap' has the condition 'structureDisplacement' but no function object 'structureCoupling' couples it"
}

property wallVelocity "a coupled wall that does not move the fluid is warned of"
wallVelocity()
{
    makeCase fluid
    entry 0/U boundaryField.flap.type noSlip
    runFluid
    expectText log.pimpleFoam "U has 'noSlip' on the coupled patch 'flap': a wall that moves with the structure has 'movingWallVelocity'"
}

property residualControl "residualControl without the coupling's entry is refused"
residualControl()
{
    makeCase fluid
    removeEntry system/fvSolution PIMPLE.residualControl.structure
    expectRefusal "residualControl has no entry 'structure'" \
        "add 'structure { tolerance 1e-4; relTol 0; }'" "fvSolution.PIMPLE"
}

property tolerance "a tolerance that no residual can meet is refused"
tolerance()
{
    makeCase fluid
    entry system/fvSolution PIMPLE.residualControl.structure.tolerance 0
    expectRefusal "the tolerance is 0: it must lie between 0 and 1" "fvSolution.PIMPLE.residualControl.structure"
}

property relTol "a relTol for the coupling is refused"
relTol()
{
    makeCase fluid
    entry system/fvSolution PIMPLE.residualControl.structure.relTol 0.1
    expectRefusal "'relTol' is not 0: the coupling residual is relative already"
}

property moveMesh "a mesh that does not move in each outer corrector is refused"
moveMesh()
{
    makeCase fluid
    entry system/fvSolution PIMPLE.moveMeshOuterCorrectors no
    expectRefusal "'moveMeshOuterCorrectors' is off" "add 'moveMeshOuterCorrectors yes;'" "fvSolution.PIMPLE"
}

property staticMesh "a mesh that cannot move is refused"
staticMesh()
{
    makeCase fluid
    entry constant/dynamicMeshDict dynamicFvMesh staticFvMesh
    expectRefusal "no field 'pointDisplacement': the mesh does not move by displacement" "constant/dynamicMeshDict"
}

property density "a missing density is asked for"
density()
{
    makeCase fluid
    removeEntry system/controlDict functions.structure.rho
    expectRefusal "'rho' not found in dictionary" "controlDict.functions.structure"
}

property negativeDensity "a density that is not positive is refused"
negativeDensity()
{
    makeCase fluid
    coupling rho -1
    expectRefusal "the density 'rho' is -1 kg/m3: it must be positive"
}

property fields "fields of other names are asked for"
fields()
{
    makeCase fluid
    coupling p pressure
    expectRefusal "no pressure field 'pressure' or no velocity field 'U' in this solver; name them by the entries 'p' and 'U'"
}

property policy "an unknown policy is refused, and the policies are listed"
policy()
{
    makeCase fluid
    coupling onUnconverged ignore
    expectRefusal "onUnconverged: ignore; allowed: abort, warn, retry" "controlDict.functions.structure"
}

property enclosedFluid "an unknown policy of an enclosed fluid is refused"
enclosedFluid()
{
    makeCase fluid
    coupling enclosedFluid perhaps
    expectRefusal "enclosedFluid: perhaps; allowed: refuse, accept" "controlDict.functions.structure"
}

property couplingInterval "a coupling interval that cannot be followed is refused"
couplingInterval()
{
    makeCase fluid
    coupling couplingInterval 0
    expectRefusal "couplingInterval: 0; allowed: a number of outer correctors, at least 1, or fluidConverged" \
        "controlDict.functions.structure"
    coupling couplingInterval everyCorrector
    expectRefusal "couplingInterval: everyCorrector; allowed"
    coupling couplingInterval fluidConverged
    removeEntry system/fvSolution PIMPLE.residualControl.U
    expectRefusal "residualControl has no entry for the velocity" "add 'U { tolerance 1e-4; relTol 0; }'"
}

property fluidPredictor "an unknown predictor of the flow is refused"
fluidPredictor()
{
    makeCase fluid
    coupling fluidPredictor cubic
    expectRefusal "fluidPredictor: cubic; allowed: none, linear" "controlDict.functions.structure"
}

property pressureTolerance "an unknown choice of the pressure's tolerance is refused"
pressureTolerance()
{
    makeCase fluid
    coupling pressureTolerance loose
    expectRefusal "pressureTolerance: loose; allowed: fixed, relaxed" "controlDict.functions.structure"
}

property timeControl "a time control of the function object is refused"
timeControl()
{
    makeCase fluid
    coupling writeControl writeTime
    expectRefusal "the coupling acts in every time step: remove the entries that control when it executes or writes"
}

property unknownEntry "an unknown entry is refused, and the entries are listed"
unknownEntry()
{
    makeCase fluid
    coupling onUncoverged warn
    expectRefusal "unknown entry 'onUncoverged'" "onUnconverged" "controlDict.functions.structure"
    cd ..
    rm -r fluid
    makeCase fluid
    coupling structure.silenceIntervall 5
    expectRefusal "unknown entry 'silenceIntervall'" "silenceInterval" "controlDict.functions.structure.structure"
}

property launchAndConnect "launch and connect exclude each other"
launchAndConnect()
{
    makeCase fluid
    coupling structure.launch yes
    coupling structure.connect '"tcp://127.0.0.1:1"'
    expectRefusal "'launch yes' and 'connect' exclude each other"
}

property neither "a coupling without a case file or an address is refused"
neither()
{
    makeCase fluid
    removeEntry system/controlDict functions.structure.structure.case
    expectRefusal "'case' not found in dictionary" "controlDict.functions.structure.structure"
}

property steadySolver "a solver without a PIMPLE loop is refused"
steadySolver()
{
    makeCase fluid
    entry system/fvSolution SIMPLE '{}'
    solver=simpleFoam
    runFaultyFluid
    expectText log.pimpleFoam "this solver has no PIMPLE loop to couple in: use one like pimpleFoam"
}

property parallel "in parallel a mistake is reported once, and all ranks end"
parallel()
{
    makeCase fluid
    coupling structure.program '"noSuchProgram"'
    decompose 2
    runFaultyFluid 2
    expectText log.pimpleFoam "the structure's program 'noSuchProgram' cannot be started"
    expectOneMessage
}

runProperties "$@"
