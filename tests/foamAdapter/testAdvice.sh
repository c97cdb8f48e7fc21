#!/usr/bin/env bash
# What is likely to be wrong with a case is told at its start, with the value that shows
# it. Such a run goes on.
source "$(dirname "$0")/harness.sh"

property noForce "neither U nor a force criterion in a strong coupling is warned of, and the residual of an accepted step"
noForce()
{
    makeCase fluid
    removeEntry system/fvSolution PIMPLE.residualControl.U
    entry system/controlDict endTime 0.01
    runFluid
    expectText log.pimpleFoam "residualControl has no entry for U, and the structure's case file has 'force: none'" \
        "ten times the error at a tolerance of 5e-3" "add 'U { tolerance 1e-4; relTol 0; }' to residualControl" \
        "the time step ending at 0.01 s is accepted with a momentum residual of"
}

property forceCriterion "the criterion on the force that the structure has by default is enough; without it there is a warning"
forceCriterion()
{
    makeFlap fluid
    removeEntry system/fvSolution PIMPLE.residualControl.U
    entry system/controlDict endTime 0.01
    runFluid
    expectNoText log.pimpleFoam "residualControl has no entry for U"
    rm -rf 0.* structure/results structure/postProcessing postProcessing
    flapEntry "  predictor: quadratic" $'  predictor: quadratic\n  convergence: {force: none}'
    runFluid
    expectText log.pimpleFoam "residualControl has no entry for U"
}

property relaxationFactors "under-relaxation that a case has inherited is warned of, with its factors"
relaxationFactors()
{
    makeCase fluid
    entry system/fvSolution relaxationFactors '{ fields { p 0.7; } equations { U 0.9; UFinal 1; } }'
    runFluid
    expectText log.pimpleFoam "relaxationFactors: p 0.7 U 0.9; under-relaxed, the force lags behind"
}

property unrelaxed "factors of 1 are not warned of"
unrelaxed()
{
    makeCase fluid
    entry system/fvSolution relaxationFactors '{ fields { ".*" 1; } equations { ".*" 1; } }'
    entry system/controlDict endTime 0.01
    runFluid
    expectNoText log.pimpleFoam "relaxationFactors:"
    expectNoText log.pimpleFoam "FOAM Warning"
}

property cellDisplacement "a solver of the mesh motion that stops too early is warned of"
cellDisplacement()
{
    makeCase fluid
    useLaplacian
    entry system/controlDict endTime 0.01
    runFluid
    expectNoText log.pimpleFoam "cellDisplacement is solved by"
    sed -i 's/{ solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0; minIter 300; }/{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }/' \
        system/fvSolution
    rm -rf 0.* postProcessing
    runFluid
    expectText log.pimpleFoam "cellDisplacement is solved by smoothSolver with minIter 0" "minIter 20"
}

property sliding "a plane along which another mesh motion lets points slide by moved normals is warned of"
sliding()
{
    makeCase fluid
    entry system/controlDict endTime 0.01
    sed -i "/^boundaryField/,/^{/ s|^{|{ upperWall { type slip; }|" 0/pointDisplacement
    runFluid
    expectNoText log.pimpleFoam "normals of the moved mesh"
    rm -rf 0.* postProcessing
    useLaplacian
    runFluid
    expectText log.pimpleFoam "on patch 'upperWall'" "normals of the moved mesh" "fixedNormalSlip"
    rm -rf 0.* postProcessing
    sed -i 's/type slip;/type fixedNormalSlip; n (0 1 0);/' 0/pointDisplacement
    runFluid
    expectNoText log.pimpleFoam "normals of the moved mesh"
}

property consistent "a viscous flow without SIMPLEC is warned of, with its diffusion number"
consistent()
{
    makeCase fluid
    entry system/fvSolution PIMPLE.consistent no
    entry system/controlDict endTime 0.01
    runFluid
    expectNoText log.pimpleFoam "'consistent' is off"
    # nu 1, and cells of a sixth of a metre, or a bit more above the flap
    rm -rf 0.* postProcessing
    entry system/controlDict deltaT 0.1
    entry system/controlDict endTime 0.1
    runFluid
    expectText log.pimpleFoam "2 nu deltaT/h^2 with a cell's longest extent h, is 7.2" "add 'consistent yes;', or reduce deltaT by 1.44"
}

property correctPhi "a flux that is corrected in each outer corrector is warned of, also where that is the default"
correctPhi()
{
    makeCase fluid
    entry system/controlDict endTime 0.01
    removeEntry system/fvSolution PIMPLE.correctPhi
    runFluid
    expectText log.pimpleFoam "'correctPhi' is on" "write 'correctPhi no;'" "Solving for pcorr"
    rm -rf 0.* postProcessing
    entry system/fvSolution PIMPLE.correctPhi no
    runFluid
    expectNoText log.pimpleFoam "'correctPhi' is on"
}

property standardEntries "entries that any function object has are known"
standardEntries()
{
    makeCase fluid
    coupling errors warn
    coupling updateHeader no
    coupling useUserTime yes
    entry system/controlDict endTime 0.01
    runFluid
}

# A flap whose top is a patch of its own, which is not coupled and does not move
splitTop()
{
    sed -i 's/flap { type wall ; faces ( ( 1 5 17 13 ) ( 5 6 18 17 ) ( 2 14 18 6 ) ) ; }/flap { type wall ; faces ( ( 1 5 17 13 ) ( 2 14 18 6 ) ) ; } top { type wall ; faces ( ( 5 6 18 17 ) ) ; }/' \
        system/blockMeshDict
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    sed -i 's/upperWall/top|upperWall/' 0/p 0/U 0/pointDisplacement
    grep -q 'top' 0/pointDisplacement || fail "the conditions of the top could not be set"
}

property heldPoints "points that another patch holds where the structure moves end the run, with that patch"
heldPoints()
{
    makeCase fluid
    useLaplacian
    splitTop
    behave sway
    runFaultyFluid
    expectText log.pimpleFoam "4 of 28 points of the coupled patches do not follow the structure, by up to 100 % of its largest displacement" \
        "of patch 'flap' moves by (0 0 0) m where the structure moves by (" "it belongs to 'top' (fixedValue) too"
}

runProperties "$@"
