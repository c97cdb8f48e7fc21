#!/usr/bin/env bash
# CAD files whose patches are degenerate, or have coordinates near the end of doubles.
source "$(dirname "$0")/../structureScenes.sh"

property pole "an edge that is a point, joined by Nitsche's method, runs"
pole()
{
    makeScene pole
    runStructure p_pole.yaml
}

property farControlPoint "a control point at 2^40 m ends in one message"
farControlPoint()
{
    makeScene far
    expectRefused run crash2.yaml "the matrix is not positive definite"
}

# caseWith FILE: a case of the patch
caseWith()
{
    cat > case.yaml << EOF
geometry: {cadJson: $1}
discretisation: {degree: [2, 2], elements: [2, 2]}
model: {kinematics: shell, strains: linear, thickness: 0.01}
material: {type: StVenantKirchhoff, youngsModulus: 1e7, poissonsRatio: 0.3, density: 100}
supports: []
time: {step: 1, end: 1}
EOF
}

property knots "knots whose range is no number are refused"
knots()
{
    makeScene knots
    caseWith denormal.cad.json
    expectRefused check case.yaml "too short for double precision"
    caseWith huge.cad.json
    expectRefused check case.yaml "their magnitude must be below"
}

runProperties "$@"
