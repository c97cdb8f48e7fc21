# Usage: source cases.sh
#
# Small cases for the adapter's tests: the fluid of tutorials/perpendicularFlap
# with 252 cells, three time steps, and fakeStructure in place of igaStructure.

# makeCase FOLDER [MESH]: a case in a folder of the property, and goes there.
# Meshes: plane, thin (0.1 thick), xz and yz (the plane mesh turned); in 3D: slab
# (one cell across), solid (two)
makeCase()
{
    local mesh=${2:-plane}
    prepareMesh "$mesh"
    cd "$propertyFolder"
    cp -r "$runsFolder/meshes/$mesh" "$1"
    cd "$1"
}

# makeFlap FOLDER [MESH]: a case coupled to igaStructure, with the tutorial's flap
makeFlap()
{
    makeCase "$@"
    cp -r "$TOKAY_ROOT/tutorials/perpendicularFlap/structure" .
    removeEntry system/controlDict functions.structure.structure.program
    removeEntry system/controlDict functions.structure.structure.arguments
    coupling structure.case '"structure/case.yaml"'
    coupling structure.log '"log.igaStructure"'
}

# flapEntry TEXT TEXT: replaces a text in the flap's case file
flapEntry()
{
    local text
    text=$(cat structure/case.yaml)
    [[ $text == *"$1"* ]] || fail "the flap's case file has no '$1'"
    printf '%s\n' "${text/"$1"/"$2"}" > structure/case.yaml
}

# editEntry FILE KEY OPTION...: macros of the file stay, where they stand for values
editEntry()
{
    local file=$1 key=$2 keep=(-disableFunctionEntries)
    shift 2
    [[ $file != *fvSolution ]] || keep=()
    foamDictionary ${keep[@]+"${keep[@]}"} "$file" -entry "$key" "$@" > log.foamDictionary 2>&1 \
        || fail "foamDictionary $file -entry $key $* failed"
}

# entry FILE KEY VALUE: sets an entry of a dictionary
entry()
{
    editEntry "$1" "$2" -set "$3"
}

# removeEntry FILE KEY
removeEntry()
{
    editEntry "$1" "$2" -remove
}

# coupling KEY VALUE: sets an entry of the coupling's function object
coupling()
{
    entry system/controlDict "functions.structure.$1" "$2"
}

# behave BEHAVIOUR: of fakeStructure
behave()
{
    coupling structure.arguments "(\"--behaviour\" \"$1\" \"--record\" \"record\")"
}

# Solutions that agree though the iterations towards them differ: as many
# correctors in every step, to the end of all convergence
tightenSolvers()
{
    sed -i 's/relTol  *0.01;/relTol 0;/; s/tolerance  *1e-8;/tolerance 1e-11;/' system/fvSolution
    entry system/fvSolution PIMPLE.nOuterCorrectors 15
    entry system/fvSolution PIMPLE.residualControl.U.tolerance 1e-16
    coupling onUnconverged warn
    coupling pressureTolerance fixed
}

# decompose RANKS: along x
decompose()
{
    entry system/decomposeParDict numberOfSubdomains "$1"
    entry system/decomposeParDict coeffs.n "($1 1 1)"
    decomposePar > log.decomposePar 2>&1 || fail "decomposePar failed"
}

# prepareMesh MESH: once for all tests, again when what it is made from changes
prepareMesh()
{
    local folder=$runsFolder/meshes/$1 made
    mkdir -p "$runsFolder/meshes"
    (
        flock 9
        made=$(find "$TOKAY_ROOT/tutorials/perpendicularFlap/fluid" "$testsFolder/cases.sh" \
            -newer "$folder/made" 2> /dev/null || printf 'never')
        if [ -n "$made" ]
        then
            rm -rf "$folder"
            cp -r "$TOKAY_ROOT/tutorials/perpendicularFlap/fluid" "$folder"
            cd "$folder"
            makeMesh "$1"
            touch made
        fi
    ) 9> "$runsFolder/meshes/.lock"
}

makeMesh()
{
    rm -rf 0 [1-9]* processor* postProcessing
    mv 0.orig 0
    coarsen
    setControls
    case $1 in
        thin) thicken 0.1 ;;
        slab) openSides ;;
        solid) openSides; doubleCellsAcross ;;
    esac
    blockMesh > log.blockMesh 2>&1 || fail "blockMesh failed"
    case $1 in
        xz) transformPoints -rotate '((0 1 0) (0 0 1))' > log.transformPoints 2>&1 ;;
        yz) turnToYz ;;
    esac
}

coarsen()
{
    local key
    for key in "nx 10" "nFlap 2" "nLow 6" "nHigh 6"
    do
        entry system/blockMeshDict "${key% *}" "${key#* }"
    done
}

setControls()
{
    entry system/controlDict endTime 0.03
    entry system/controlDict writeInterval 1
    entry system/controlDict writePrecision 14
    coupling structure.program '"fakeStructure"'
    coupling structure.case '"case.yaml"'
    behave rigid
}

# thicken THICKNESS
thicken()
{
    sed -i "s/ 1 ) ( \$x/ $1 ) ( \$x/g; s/ 1 ) );/ $1 ) );/" system/blockMeshDict
    grep -q "y2 $1 )" system/blockMeshDict || fail "the thickness could not be set"
}

# Three dimensions: sides that add nothing to any equation (a symmetry plane adds
# to the diagonal of the momentum equation)
openSides()
{
    local field
    sed -i 's/type empty/type patch/' system/blockMeshDict
    for field in p U pointDisplacement
    do
        entry 0/$field boundaryField.frontAndBack.type zeroGradient
    done
    # Such sides are no boundary conditions of a flow, and SIMPLEC notices
    manyCorrectors
}

doubleCellsAcross()
{
    sed -i 's/\(\$n[LH][a-z]*\) 1 ) simple/\1 2 ) simple/g' system/blockMeshDict
    grep -q 'nHigh 2' system/blockMeshDict || fail "the cells across could not be set"
}

# x becomes y, y becomes z, z becomes x
turnToYz()
{
    transformPoints -rotate '((0 1 0) (0 0 1))' > log.transformPoints 2>&1
    transformPoints -rotate '((1 0 0) (0 1 0))' >> log.transformPoints 2>&1
    entry 0/U internalField 'uniform (0 10 0)'
}

# useLaplacian: OpenFOAM's mesh motion, converged
useLaplacian()
{
    sed -i 's/harmonicBasis/displacementLaplacian/; s/tokayFoamAdapter/fvMotionSolvers/; s/coupledMotion/dynamicMotion/' constant/dynamicMeshDict
    entry constant/dynamicMeshDict displacementLaplacianCoeffs.diffusivity 'quadratic inverseDistance (flap)'
    sed -i '/^solvers/,/^{/ s|^{|{ "cellDisplacement.*" { solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0; minIter 300; }|' \
        system/fvSolution
}

# Five correctors of the pressure, and no SIMPLEC
manyCorrectors()
{
    entry system/fvSolution PIMPLE.consistent no
    entry system/fvSolution PIMPLE.nCorrectors 5
}

# The points of the last step are kept
writeAtEnd()
{
    entry system/controlDict writeInterval 0.03
}
