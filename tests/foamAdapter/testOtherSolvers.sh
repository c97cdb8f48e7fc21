#!/usr/bin/env bash
# Solvers other than pimpleFoam: the force on the faces is that of the last pressure
# corrector, as OpenFOAM's function object `forces` has it after the step.
source "$(dirname "$0")/harness.sh"

# prepare SOLVER: a rigid flap in a start from rest, and the function object `forces`
prepare()
{
    solver=$1
    makeCase fluid
    removeEntry system/controlDict functions.structure.rho
    entry system/controlDict functions.forces \
        '{ type forces; libs (forces); patches (flap); CofR (0 0 0); writePrecision 16; }'
    entry system/controlDict deltaT 0.001
    entry system/controlDict endTime 0.003
    entry 0/U internalField 'uniform (1 0 0)'
    entry system/fvSolution PIMPLE.consistent no
    writeDictionary system/fvSchemes dictionary << 'END'
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes
{
    default Gauss upwind;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
END
}

# writeDictionary FILE CLASS: from the standard input
writeDictionary()
{
    {
        printf 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n' "$2" "${1##*/}"
        cat
    } > "$1"
}

# expectForces: with one, two and three pressure correctors, in each step, and a
# viscous part that would be missed
# Usage: expectForces [hydrostatic]: that the viscous part counts is not asked for
expectForces()
{
    local n
    for n in 1 2 3
    do
        rm -rf postProcessing record 0.*
        entry system/fvSolution PIMPLE.nCorrectors $n
        runFluid
        expectStepForces "$@"
    done
}

expectStepForces()
{
    local time
    for time in 0.001 0.002 0.003
    do
        forceSum record $time > sum
        tr -d '()' < postProcessing/forces/0/force.dat | awk -v time=$time '$1 == time { print $2, $3, 0 }' > foam
        # Rounding: 14 terms that partly cancel
        expectSameTable "force at $time s" 1e-12 foam sum
    done
    [ "${1:-}" != hydrostatic ] || return 0
    tr -d '()' < postProcessing/forces/0/force.dat | tail -n 1 \
        | awk '{ exit !($8^2 > 1e-6*$2^2) }' || fail "there is hardly a viscous force"
}

property incompressible "with pimpleFoam the force is that of the last pressure corrector"
incompressible()
{
    prepare pimpleFoam
    coupling rho 1000
    entry system/controlDict functions.forces.rho rhoInf
    entry system/controlDict functions.forces.rhoInf 1000
    expectForces
}

# A gas at 1e5 Pa
prepareGas()
{
    prepare rhoPimpleFoam
    gas constant/thermophysicalProperties hePsiThermo perfectGas
    temperature
    sed -i 's/\[ *0 2 -2 0/[1 -1 -2 0/; s/uniform 0/uniform 1e5/' 0/p
    sed -i 's/(U|UFinal)/(U|UFinal|e|eFinal|rho|rhoFinal)/' system/fvSolution
}

property compressible "so it is with rhoPimpleFoam"
compressible()
{
    prepareGas
    expectForces
}

property absolutePressure "an absolute pressure without pRef is warned of, with the pressure and the force"
absolutePressure()
{
    prepareGas
    entry system/controlDict endTime 0.001
    runFluid
    # Both sides and the top of the flap, 1 m deep
    expectText log.pimpleFoam "the pressure of this solver is absolute, 100000 Pa on the coupled patches at the start" \
        "210000 N on 2.1 m2" "add 'pRef 100000;', the pressure behind the structure"
    coupling pRef 0
    rm -rf 0.0* postProcessing
    runFluid
    expectNoText log.pimpleFoam "the pressure of this solver is absolute"
}

# gas FILE TYPE EQUATION [ENTRIES]: its thermophysical properties
gas()
{
    writeDictionary "$1" dictionary << END
thermoType
{
    type $2; mixture pureMixture; transport const; thermo hConst;
    equationOfState $3; specie specie; energy sensibleInternalEnergy;
}
mixture
{
    specie { molWeight 28.9; }
    thermodynamics { Cp 1005; Hf 0; }
    transport { mu 0.1; Pr 0.7; }
    ${4:-}
}
END
}

temperature()
{
    writeDictionary 0/T volScalarField << 'END'
dimensions [0 0 0 1 0 0 0];
internalField uniform 300;
boundaryField
{
    inlet { type fixedValue; value uniform 300; }
    frontAndBack { type empty; }
    ".*" { type zeroGradient; }
}
END
}

# prepareMixture SOLVER: water and air, half each, with gravity, solved for p_rgh
prepareMixture()
{
    prepare "$1"
    entry system/controlDict maxAlphaCo 1
    writeDictionary constant/transportProperties dictionary << 'END'
phases (water air);
water { transportModel Newtonian; nu 1e-2; rho 1000; }
air { transportModel Newtonian; nu 1e-2; rho 1; }
sigma 0;
END
    writeDictionary constant/g uniformDimensionedVectorField << 'END'
dimensions [0 1 -2 0 0 0 0];
value (0 -9.81 0);
END
    writeDictionary 0/alpha.water volScalarField << 'END'
dimensions [0 0 0 0 0 0 0];
internalField uniform 0.5;
boundaryField
{
    inlet { type fixedValue; value uniform 0.5; }
    frontAndBack { type empty; }
    ".*" { type zeroGradient; }
}
END
    sed 's/\[ *0 2 -2 0/[1 -1 -2 0/; s/object  *p;/object p_rgh;/; s/zeroGradient/fixedFluxPressure/' \
        0/p > 0/p_rgh
    rm 0/p
    sed -i 's/^    p$/    p_rgh/; s/pFinal/p_rghFinal/; s/\$p;/$p_rgh;/
        s/^solvers$/&\n/; s/^    "(U|UFinal)"$/    "alpha.*" { nAlphaCorr 1; nAlphaSubCycles 1; cAlpha 1; }\n&/' \
        system/fvSolution
}

property twoPhases "so it is with interFoam, which forms p from p_rgh"
twoPhases()
{
    prepareMixture interFoam
    expectForces
}

property isoAdvector "so it is with interIsoFoam"
isoAdvector()
{
    prepareMixture interIsoFoam
    sed -i 's/nAlphaCorr 1;/isoFaceTol 1e-6; surfCellTol 1e-6; nAlphaBounds 3; snapTol 1e-12; clip true;/' \
        system/fvSolution
    expectForces
}

property closedTwoPhases "so it is in a closed domain, whose pressure needs a reference"
closedTwoPhases()
{
    local patch
    prepareMixture interFoam
    entry 0/U internalField 'uniform (0 0 0)'
    for patch in inlet outlet
    do
        entry 0/U boundaryField.$patch '{ type fixedValue; value uniform (0 0 0); }'
    done
    sed -i 's/fixedValue;/fixedFluxPressure;/' 0/p_rgh
    sed -i 's/inlet {.*/inlet { type zeroGradient; }/' 0/alpha.water
    coupling enclosedFluid accept
    entry system/fvSolution PIMPLE.pRefCell 5
    entry system/fvSolution PIMPLE.pRefValue 1000
    behave rigid
    # A flow, though nothing enters
    sed -i 's/(upperWall|lowerWall)/lowerWall/' 0/U
    entry 0/U boundaryField.upperWall '{ type fixedValue; value uniform (1 0 0); }'
    expectForces hydrostatic
}

property compressibleTwoPhases "so it is with compressibleInterDyMFoam, which updates the densities after p_rgh"
compressibleTwoPhases()
{
    prepareMixture compressibleInterDyMFoam
    temperature
    writeDictionary constant/thermophysicalProperties dictionary << 'END'
phases (water air);
pMin 1000;
sigma 0;
END
    gas constant/thermophysicalProperties.water heRhoThermo perfectFluid 'equationOfState { R 3000; rho0 1000; }'
    gas constant/thermophysicalProperties.air heRhoThermo perfectGas
    sed -i 's/uniform 0/uniform 1e5/' 0/p_rgh
    sed 's/object p_rgh;/object p;/; s/fixedFluxPressure/calculated; value uniform 1e5/; s/fixedValue/calculated/' 0/p_rgh > 0/p
    sed -i 's/(U|UFinal)/(U|UFinal|T|TFinal|rho|rhoFinal)/' system/fvSolution
    # The flow converges slowly at one pressure corrector; its force is the subject here
    entry system/fvSolution PIMPLE.residualControl.U '{ tolerance 1e-3; relTol 0; }'
    expectForces hydrostatic
}

runProperties "$@"
