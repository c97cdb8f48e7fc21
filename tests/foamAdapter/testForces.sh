#!/usr/bin/env bash
# The force on the faces, against OpenFOAM's own function object `forces`.
source "$(dirname "$0")/harness.sh"

# Adds the function object `forces`; its entries beyond the usual: $1
addForces()
{
    entry system/controlDict functions.forces \
        "{ type forces; libs (forces); patches (flap); rho rhoInf; rhoInf 1000; CofR (0 0 0); writePrecision 16; ${1:-} }"
    coupling rho 1000
    behave sway
}

# expectForce RECORD COLUMNS DEPTH: the sum of the face forces of each step is the
# force that `forces` has in these columns of force.dat
expectForce()
{
    local time
    for time in 0.01 0.02 0.03
    do
        forceSum "$1" $time > sum
        tr -d '()' < postProcessing/forces/0/force.dat \
            | awk -v time=$time -v columns="$2" -v depth="$3" '
                $1 == time {
                    split(columns, c, " ")
                    print $c[1]/depth, $c[2]/depth, $c[3]/depth
                }' OFMT=%.16g > foam
        # Rounding: 28 terms that partly cancel, and 16 digits in the file
        expectSameTable "force at $time s" 1e-12 foam sum
    done
}

totalForce="2 3 4"
pressureForce="5 6 7"

property total "the face forces of a step add up to the force that OpenFOAM has at its end"
total()
{
    makeCase fluid solid
    addForces
    runFluid
    expectForce record "$totalForce" 1
}

property limited "with a limited gradient of the velocity they add up to OpenFOAM's force as well"
limited()
{
    makeCase fluid solid
    addForces
    entry system/fvSchemes gradSchemes.default "cellLimited Gauss linear 1"
    runFluid
    expectForce record "$totalForce" 1
}

property pressure "without the viscous part they add up to OpenFOAM's pressure force"
pressure()
{
    makeCase fluid solid
    addForces
    coupling viscous no
    runFluid
    expectForce record "$pressureForce" 1
}

property referencePressure "the reference pressure is taken off as OpenFOAM does it"
referencePressure()
{
    makeCase fluid
    addForces 'pRef 5000;'
    coupling pRef 5000
    runFluid
    # In 2D the third component is nobody's
    sed -i 's/ [^ ()]*)/ 0)/g' postProcessing/forces/0/force.dat
    expectForce record "$totalForce" 1
}

property depth "in 2D they add up to OpenFOAM's force over the mesh's thickness"
depth()
{
    makeCase fluid thin
    addForces
    runFluid
    sed -i 's/ [^ ()]*)/ 0)/g' postProcessing/forces/0/force.dat
    expectForce record "$totalForce" 0.1
}

property turbulent "with a turbulence model the eddy viscosity is in the force"
turbulent()
{
    makeCase fluid solid
    addForces
    entry constant/turbulenceProperties simulationType LES
    entry constant/turbulenceProperties LES \
        '{ LESModel Smagorinsky; delta cubeRootVol; cubeRootVolCoeffs {} turbulence on; printCoeffs off; }'
    # At the wall of the flap as large as the laminar viscosity
    makeNut 1
    runFluid
    expectForce record "$totalForce" 1
    cp sum withEddies
    makeNut 0
    runFluid
    forceSum record 0.03 > without
    if cmp -s withEddies without
    then
        fail "the eddy viscosity at the wall makes no difference"
    fi
}

# makeNut VALUE: field of the eddy viscosity, with this value on the flap
makeNut()
{
    cat > 0/nut << END
FoamFile
{
    version     2.0;
    format      ascii;
    class       volScalarField;
    object      nut;
}
dimensions      [0 2 -1 0 0 0 0];
internalField   uniform 0;
boundaryField
{
    flap
    {
        type    fixedValue;
        value   uniform $1;
    }
    ".*"
    {
        type    calculated;
        value   uniform 0;
    }
}
END
}

runProperties "$@"
