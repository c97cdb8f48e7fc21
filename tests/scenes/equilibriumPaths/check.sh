#!/usr/bin/env bash
# Shells that snap, followed by arc length at default settings.
source "$(dirname "$0")/../structureScenes.sh"

# endOfPath NAME: last time of its table
endOfPath() { awk '!/^#/ { t = $1 } END { print t }' "postProcessing/$1/0/watchPoints.dat"; }

property semiCylinder "arc length follows a pinched semi-cylinder to the end of the load"
semiCylinder()
{
    makeScene paths
    runStructure semiArc.yaml
    [ "$(endOfPath semiArc)" = 1 ] || fail "the path ends at t = $(endOfPath semiArc)"
    # 171.505 (Sze, Liu & Lo 2004, with elements that shear, on their mesh)
    expectClose "deflection of A" "$(watch semiArc 2)" -171.505 0.01
    expectText log.igaStructure "arcLength"
}

property pulledCylinder "arc length follows a cylinder that is pulled apart"
pulledCylinder()
{
    makeScene paths
    runStructure pullArc.yaml
    [ "$(endOfPath pullArc)" = 1 ] || fail "the path ends at t = $(endOfPath pullArc)"
    # 2.768 (Sze, Liu & Lo 2004, with elements that shear); 2.709 on the 16 x 12 elements of
    # the case, 2.730 on 32 x 24
    expectClose "deflection of A" "$(watch pullArc 2)" 2.768 0.025
}

property limitPoint "static load steps that meet a limit point name it, its load and arcLength"
limitPoint()
{
    makeScene paths
    cat > roof.yaml << ROOF
# A shallow roof with hinged straight edges under a force in its middle, a quarter: it snaps
# at 0.7421 of 3000 (Sze, Liu & Lo 2004)
geometry:
  cylinder: {base: [0, 0, 0], radius: 2540, height: 254, angles: [84.27042204869177, 90]}
discretisation: {degree: [3, 3], elements: [8, 8]}
model: {kinematics: shell, strains: nonlinear, thickness: 12.7}
material: {type: StVenantKirchhoff, youngsModulus: 3102.75, poissonsRatio: 0.3, density: 1}
supports:
  - {edge: left, fix: [x, y, z]}
  - {edge: right, fix: [x, rotation]}
  - {edge: bottom, fix: [z, rotation]}
loads:
  - {point: [0, 2540, 0], force: [0, "-750*t", 0]}
time: {scheme: static, step: 0.05, end: 1}
output: {interval: 0}
ROOF
    expectRefused run roof.yaml "limit point at t = 0.74"
    expectText log.igaStructure "time.scheme arcLength"
}

runProperties "$@"
