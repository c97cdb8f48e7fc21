#!/usr/bin/env bash
# The motion solver harmonicBasis at patches that constrain the mesh without fixing
# it: planes in which points slide; and what it leaves to displacementLaplacian.
source "$(dirname "$0")/harness.sh"

# basis KEY VALUE: sets an entry of the motion solver
basis()
{
    entry constant/dynamicMeshDict "harmonicBasisCoeffs.$1" "$2"
}

# makeMotion FOLDER [DISPLACEMENT]: the mesh alone, whose flap is displaced
makeMotion()
{
    makeCase "$1"
    entry system/controlDict functions '{}'
    entry system/controlDict deltaT 0.01
    writeAtEnd
    sed -i "s/structureDisplacement;/fixedValue;/; s/uniform (0 0 0);/uniform (${2:-0.02 0.01 0});/
        /inlet|outlet/,/}/ s/${2:-0.02 0.01 0}/0 0 0/; s/^\(internalField *\).*/\1uniform (0 0 0);/" 0/pointDisplacement
    basis patches "(flap)"
    solver=moveDynamicMesh
}

# condition PATCH ENTRIES: of pointDisplacement, before those of all walls
condition()
{
    sed -i "/^boundaryField/,/^{/ s|^{|{ $1 { $2 }|" 0/pointDisplacement
}

# moved: displacements of all points
moved()
{
    movedPoints constant/polyMesh/points 0.03/polyMesh/points
}

# slide [ENTRIES]: three sides of the channel; those of the outlet
slide()
{
    condition inlet 'type slip;'
    condition outlet "${1:-type fixedNormalSlip; n (1 0 0);}"
    condition upperWall 'type slip;'
}

property slides "harmonicBasis: points slide in planes, as those of a converged displacementLaplacian"
slides()
{
    # A thousandth of the flap's height: displacementLaplacian follows the mesh
    makeMotion product "0.001 0.0005 0"
    slide
    basis rotation no
    basis diffusivity 'quadratic inverseDistance (flap)'
    runFluid
    expectText log.pimpleFoam "extended in 2 ways for planes"
    moved > all
    awk '($1 == -3 || $1 == 3) && $4 != 0 || $2 == 4 && $5 != 0 { exit 1 }' all || fail "points leave their planes"
    awk '$2 == 4 && $4 > 1e-6 { above = 1 } $1 == 3 && $2 < 4 && $5 > 1e-7 { behind = 1 } END { exit !(above && behind) }' all \
        || fail "points do not slide"
    above all > ../product.moved
    cp -r . ../solution
    cd ../solution
    rm -rf 0.0*
    useLaplacian
    runFluid
    moved > all
    above all > moved
    # The limit of the diffusivity at the boundary makes a difference within the
    # first cells
    expectSameTable displacement 0.02 ../product.moved moved
}

# above FILE: displacements of the points above the flap, at whose foot the motion
# has a jump
above()
{
    awk '$2 > 1 { print $4, $5 }' "$1"
}

property inclined "harmonicBasis: planes inclined to the axes constrain the mesh as those that are not"
inclined()
{
    makeMotion aligned
    slide
    runFluid
    moved | awk -v OFMT=%.15g '{ print 0.8*$4 - 0.6*$5, 0.6*$4 + 0.8*$5 }' > ../aligned.moved
    makeMotion inclined "0.01 0.02 0"
    slide 'type fixedNormalSlip; n (0.8 0.6 0);'
    transformPoints -rotate '((1 0 0) (0.8 0.6 0))' > log.transformPoints 2>&1 || fail "transformPoints failed"
    runFluid
    moved | awk '{ print $4, $5 }' > moved
    # Extensions are solved to 1e-12 of their normalised residual
    expectSameTable displacement 1e-7 ../aligned.moved moved
}

property stays "harmonicBasis: a plane along which points slide by several cells stays one"
stays()
{
    makeMotion fluid "0.24 0.18 0"
    entry system/controlDict deltaT 0.001
    condition lowerWall 'type slip;'
    # Inclined, so that the plane has some rounding
    transformPoints -rotate '((1 0 0) (0.8 0.6 0))' > log.transformPoints 2>&1 || fail "transformPoints failed"
    runFluid
    movedPoints constant/polyMesh/points 0.03/polyMesh/points \
        | awk '{ print -0.6*$1 + 0.8*$2, 0.8*$4 + 0.6*$5, -0.6*$4 + 0.8*$5 }' > moved
    # Points are written to fourteen digits
    awk '$1*$1 < 1e-16 {
        if ($2 > 0.1) slides = 1
        if ($3*$3 > 1e-26) { print "off by", $3; bad = 1 }
    } END { exit bad || !slides }' moved || fail "the lower wall is no plane any more"
}

property period "harmonicBasis: with cyclic ends a wave moves the mesh alike wherever it is"
period()
{
    makeMotion fluid
    cat > system/blockMeshDict << END
FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }
vertices ((0 0 0) (2 0 0) (2 0.5 0) (0 0.5 0) (0 0 0.1) (2 0 0.1) (2 0.5 0.1) (0 0.5 0.1));
blocks (hex (0 1 2 3 4 5 6 7) (40 20 1) simpleGrading (1 1 1));
boundary
(
    roof { type wall; faces ((3 7 6 2)); } floor { type wall; faces ((0 1 5 4)); }
    inlet { type cyclic; neighbourPatch outlet; faces ((0 4 7 3)); }
    outlet { type cyclic; neighbourPatch inlet; faces ((1 2 6 5)); }
    sides { type empty; faces ((0 3 2 1) (4 5 6 7)); }
);
END
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    # A quarter of the period in each step
    cat > 0/pointDisplacement << END
FoamFile { version 2.0; format ascii; class pointVectorField; object pointDisplacement; }
dimensions [0 1 0 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{
    #includeEtc "caseDicts/setConstraintTypes"
    roof
    {
        type waveDisplacement; amplitude (0 0.05 0); waveNumber (3.14159265358979 0 0);
        omega 157.0796326794897; value uniform (0 0 0);
    }
    floor { type fixedValue; value uniform (0 0 0); }
}
END
    rm -f 0/U 0/p
    basis patches "(roof)"
    basis nFunctions 100000
    entry system/controlDict writeControl timeStep
    entry system/controlDict writeInterval 1
    runFluid
    wave 0.01 0 > first
    wave 0.02 0.5 > second
    # The functions' slopes, of which the rotations are made, are not periodic
    expectSameTable displacement 0.03 first second
}

# wave TIME SHIFT: displacements of the points by their positions in the wave
wave()
{
    movedPoints constant/polyMesh/points "$1/polyMesh/points" \
        | awk -v shift="$2" '$3 == 0 && $1 < 1.99 { printf "%.4f %.4f %s %s\n", ($1 - shift + 2.001)%2, $2, $4, $5 }' \
        | sort -g -k 1,1 -k 2,2 | cut -d ' ' -f 3-
}

# expectFallback REASON: said before the first motion, and the run continues
expectFallback()
{
    expectText log.pimpleFoam "the mesh moves as by displacementLaplacian with 60 sweeps from here on, because" "$1"
    expectNoText log.pimpleFoam "boundary points"
}

property oblique "motion fall-back: planes that are neither parallel nor perpendicular"
oblique()
{
    makeMotion fluid
    sed -i 's/( *\$x3 \$y1/(3.125 $y1/g; s/( *\$x3 \$y2/(3.5 $y2/g' system/blockMeshDict
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    slide 'type slip;'
    runFluid
    expectFallback "patch 'outlet' is oblique to another"
}

property curved "motion fall-back: points that slide on a patch that is not plane"
curved()
{
    makeMotion fluid
    sed -i 's/( *\$x2 \$y2/($x2 4.2/g' system/blockMeshDict
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    slide
    runFluid
    expectFallback "patch 'upperWall', on which points slide (slip), is not a plane"
}

property normal "motion fall-back: a normal that is not that of the patch"
normal()
{
    makeMotion fluid
    condition outlet 'type fixedNormalSlip; n (0.8 0.6 0);'
    runFluid
    expectFallback "patch 'outlet', on which points slide (fixedNormalSlip), is not a plane"
}

property wedge "motion fall-back: the wedges of an axisymmetric mesh"
wedge()
{
    makeMotion fluid
    cp "$TOKAY_ROOT/benchmarks/meshMotion/wedge.blockMeshDict" system/blockMeshDict
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    cat > 0/pointDisplacement << END
FoamFile { version 2.0; format ascii; class pointVectorField; object pointDisplacement; }
dimensions [0 1 0 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{
    "(inlet|outlet)" { type fixedValue; value uniform (0 0 0); }
    roof { type fixedValue; value uniform (0.01 0 0); }
    "(back|front)" { type wedge; }
    axis { type empty; }
}
END
    rm -f 0/U 0/p
    basis patches "(roof)"
    runFluid
    expectFallback "patch 'back' is a wedge"
}

runProperties "$@"
