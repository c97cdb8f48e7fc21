#!/usr/bin/env bash
# Solvers whose pressure is in Pa: the force on the faces is OpenFOAM's there too.
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
    # Forces of a pressure that the last correctors have converged
    manyCorrectors
    writeDictionary system/fvSchemes dictionary << 'END'
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default Gauss upwind; div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }
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

# expectForces: in each step, and a viscous part that would be missed
expectForces()
{
    local time
    for time in 0.001 0.002 0.003
    do
        forceSum record $time > sum
        tr -d '()' < postProcessing/forces/0/force.dat | awk -v time=$time '$1 == time { print $2, $3, 0 }' > foam
        # Rounding: 14 terms that partly cancel
        expectSameTable "force at $time s" 1e-12 foam sum
    done
    tr -d '()' < postProcessing/forces/0/force.dat | tail -n 1 \
        | awk '{ exit !($8^2 > 1e-6*$2^2) }' || fail "there is hardly a viscous force"
}

property compressible "rhoPimpleFoam couples, with the force of a compressible fluid"
compressible()
{
    prepare rhoPimpleFoam
    writeDictionary constant/thermophysicalProperties dictionary << 'END'
thermoType
{
    type hePsiThermo; mixture pureMixture; transport const; thermo hConst;
    equationOfState perfectGas; specie specie; energy sensibleInternalEnergy;
}
mixture
{
    specie { molWeight 28.9; }
    thermodynamics { Cp 1005; Hf 0; }
    transport { mu 0.1; Pr 0.7; }
}
END
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
    sed -i 's/\[ *0 2 -2 0/[1 -1 -2 0/; s/uniform 0/uniform 1e5/' 0/p
    sed -i 's/(U|UFinal)/(U|UFinal|e|eFinal|rho|rhoFinal)/' system/fvSolution
    runFluid
    expectForces
}

property twoPhases "interFoam couples, with the force of a fluid whose density varies"
twoPhases()
{
    prepare interFoam
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
    runFluid
    expectForces
}

runProperties "$@"
