# Usage: source tables.sh
#
# Numbers out of the records of fakeStructure and of OpenFOAM's files, as tables
# that can be compared.

# recordRow RECORD NAME: the values of a line of the interface, one a line
recordRow()
{
    awk -v name="$2" '$1 == name { for (i = 2; i <= NF; ++i) printf "%.15g\n", $i }' "$1"
}

# interfacePoints RECORD: points of the reference configuration, sorted
interfacePoints()
{
    awk '
        $1 == "dimension" { d = $2 }
        $1 == "points" {
            for (i = 2; i <= NF; ++i) printf "%.9f%s", ($i^2 < 1e-20 ? 0 : $i), (i - 1) % d ? " " : "\n"
        }' "$1" | sort
}

# interfaceFaces RECORD: points a face, then its centre, sorted
interfaceFaces()
{
    finalForces "$1" 0 | cut -d ' ' -f 1-4 | sort
}

# finalForces RECORD TIME: a line a face, "points centre force", sorted by the
# centre, with the forces of the last exchange of the step that ends at TIME
# (0: zeros). Centres are those of the reference configuration; in 2D the third
# components are 0
finalForces()
{
    awk -v time="$2" '
        function round(x) { return x^2 < 1e-20 ? 0 : x }
        $1 == "dimension" { d = $2 }
        $1 == "points" { for (i = 2; i <= NF; ++i) x[i - 2] = $i }
        $1 == "faceOffsets" { for (i = 2; i <= NF; ++i) offset[i - 2] = $i; nFaces = NF - 2 }
        $1 == "facePoints" { for (i = 2; i <= NF; ++i) point[i - 2] = $i }
        $1 == "forces" && ($2 - time)^2 < 1e-20 && $3 == 1 { for (i = 6; i <= NF; ++i) force[i - 6] = $i; found = NF - 5 }
        END {
            if (time > 0 && found != nFaces*d) exit 1
            for (f = 0; f < nFaces; ++f) {
                n = offset[f + 1] - offset[f]
                printf "%d", n
                for (c = 0; c < 3; ++c) {
                    centre = 0
                    for (i = offset[f]; i < offset[f + 1] && c < d; ++i) centre += x[point[i]*d + c]/n
                    printf " %.9f", round(centre)
                }
                for (c = 0; c < 3; ++c) printf " %.15g", c < d ? force[f*d + c] + 0 : 0
                printf "\n"
            }
        }' "$1" | sort -k 2,4
}

# forceSum RECORD TIME: "x y z" (2D: 0 for z)
forceSum()
{
    finalForces "$1" "$2" | awk '
        { for (c = 0; c < 3; ++c) sum[c] += $(5 + c) }
        END { printf "%.15g %.15g %.15g\n", sum[0], sum[1], sum[2] }'
}

# foamForce FOLDER TIME: total force "x y z" of OpenFOAM's function object
foamForce()
{
    awk -v time="$2" '$1 == time { gsub(/[()]/, ""); print $2, $3, $4 }' \
        "$1/postProcessing/forces/0/force.dat"
}

# pointField FILE PATCH: values of a patch in an ascii field, "x y z" a line
pointField()
{
    awk -v patch="$2" '
        $1 == patch { inside = 1 }
        inside && $1 == "}" { exit }
        inside && /^\(.*\)$/ { gsub(/[()]/, ""); print }' "$1"
}

# movedPoints BEFORE AFTER: "x y z dx dy dz" of each point of two files of points
movedPoints()
{
    paste -d ' ' <(grep '^(.*)$' "$1") <(grep '^(.*)$' "$2") | tr -d '()' \
        | awk -v OFMT=%.15g '{ print $1, $2, $3, $4 - $1, $5 - $2, $6 - $3 }'
}

# expectSameTable WHAT TOLERANCE FILE FILE: as many rows and columns, and numbers
# that differ by at most TOLERANCE of the largest one
expectSameTable()
{
    local difference
    [ -s "$3" ] || fail "$1: $3 is empty"
    difference=$(awk '
        function size(x) { return x < 0 ? -x : x }
        NR == FNR { rows[FNR] = $0; n = FNR; for (i = 1; i <= NF; ++i) if (size($i) > largest) largest = size($i); next }
        {
            if (split(rows[FNR], row) != NF) { wrong = 1 }
            for (i = 1; i <= NF; ++i) if (!(size($i - row[i]) <= worst)) worst = size($i - row[i])
        }
        END {
            if (wrong || FNR != n) print "shape"
            else printf "%.3g\n", worst/(largest > 0 ? largest : 1)
        }' "$3" "$4")
    [ "$difference" != shape ] || fail "$1: $3 and $4 have different numbers of rows or columns"
    awk -v difference="$difference" -v tolerance="$2" 'BEGIN { exit !(difference <= tolerance) }' \
        || fail "$1: $3 and $4 differ by $difference of the largest value, more than $2"
}

# flapPoints ACROSS UP: of such rows those on the flap, where these columns are
# the coordinates across and along it. The flap has no mesh inside
flapPoints()
{
    awk -v a="$1" -v u="$2" '$a > -0.0501 && $a < 0.0501 && $u < 1.0001' | sort
}

# expectSway ACROSS UP FILE NPOINTS [DEPTH]: the rows have fakeStructure's sway at
# 0.03 s; in space DEPTH is the column of the third coordinate
expectSway()
{
    expectEqual "points on the flap" "$(wc -l < "$3")" "$4"
    awk -v a="$1" -v u="$2" -v d="${5:-0}" -v OFMT=%.15g '
        { for (c = 1; c <= 3; ++c) print c == a ? 0.05*sin(20*0.03)*$u*(d ? $d : 1) : 0 }' "$3" > expected
    awk '{ print $4; print $5; print $6 }' "$3" > actual
    # Coordinates of up to 4 with 14 digits, against displacements of 0.03
    expectSameTable displacement 1e-11 expected actual
}
