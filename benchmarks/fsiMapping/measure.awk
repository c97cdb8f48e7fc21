# Usage: awk -v thickness=T -v normal="x y z" -v radial=0|1 -v nComponents=2|3 -f measure.awk
#            POINTS REFERENCE CASE
#
# Compares the watch points of two runs; prints the error of the displacement and that of
# the strain of the outer fibre, each relative to the largest of the reference.
#
#   POINTS           x y z of each watch point; the last five lie along one face, from one
#                    point of the fluid to the next
#   REFERENCE, CASE  watchPoints.dat of both
#   thickness        of a thin body, whose fibre strain is stretch plus thickness/2 times
#                    the change of curvature; 0: of a body whose points lie on its surface
#   normal           of the undeformed surface at the face; radial 1: along x, y of its middle

function at(row, point, k) { return x[point, k] + (k <= nComponents ? row[2 + (point - 1)*nComponents + k - 1] : 0) }

# Strain of the outer fibre at a watch point between two others
function strain(row, i,    k, s, t, c, along, across, stretch, bend) {
    stretch = bend = s = 0
    for (k = 1; k <= 3; k++) {
        t[k] = at(row, i + 1, k) - at(row, i - 1, k)
        c[k] = at(row, i + 1, k) - 2*at(row, i, k) + at(row, i - 1, k)
        s += (x[i + 1, k] - x[i - 1, k])^2
        stretch += t[k]^2
    }
    along = 0
    for (k = 1; k <= 3; k++) along += n[k]*t[k]/stretch
    for (k = 1; k <= 3; k++) { across = n[k] - along*t[k]; bend += across*c[k] }
    return sqrt(stretch/s) - 1 - thickness/2*bend*4/s
}

function abs(v) { return v < 0 ? -v : v }

FNR == 1 { file++ }
file == 1 { nPoints++; for (k = 1; k <= 3; k++) x[nPoints, k] = $k; next }
/^#/ { next }
file == 2 {
    if (!ready++) {
        split(normal, n, " ")
        m = nPoints - 2
        if (radial) { r = sqrt(x[m, 1]^2 + x[m, 2]^2); n[1] = x[m, 1]/r; n[2] = x[m, 2]/r; n[3] = 0 }
        for (k = 1; k <= NF; k++) rest[k] = 0
        for (j = 1; j <= 3; j++) strain0[j] = strain(rest, nPoints - 4 + j)
    }
    reference[FNR] = $0
    next
}
{
    nColumns = split(reference[FNR], r0, " ")
    if (nColumns != NF) { print "the tables differ in row " FNR > "/dev/stderr"; exit 1 }
    split($0, r1, " ")
    for (i = 1; i <= nPoints; i++) {
        size = off = 0
        for (k = 1; k <= nComponents; k++) {
            column = 2 + (i - 1)*nComponents + k - 1
            size += r0[column]^2
            off += (r1[column] - r0[column])^2
        }
        if (size > largest) largest = size
        if (off > error) error = off
    }
    for (j = 1; j <= 3; j++) {
        size = strain(r0, nPoints - 4 + j) - strain0[j]
        off = strain(r1, nPoints - 4 + j) - strain0[j] - size
        if (abs(size) > largestStrain) largestStrain = abs(size)
        if (abs(off) > strainError) strainError = abs(off)
    }
}
END { printf "%.2e,%.2e", sqrt(error/largest), strainError/largestStrain }
