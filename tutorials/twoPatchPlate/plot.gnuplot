# u(x) of both halves at the end, beside x/1000, for six of the cases
set terminal pngcairo size 1200,700 font "sans,10"
set output png
set grid
set key top left
set xlabel "x [m]"
set ylabel "u [mm]"
points(scene, half) = sprintf("< grep -h %s %s/%s/*/displacement.dat", half, run, scene)
set multiplot layout 2,3
do for [scene in "untrimmed-untrimmed trimmed-untrimmed trimmed-trimmed trimmed-trimmed-inside iga-fem trimmed-fem"] {
    set title scene noenhanced
    plot [0:4] x with lines linecolor "gray" title "exact: x/1000", \
        points(scene, "left") using 1:(1000*$2) with points pointtype 7 title "left half", \
        points(scene, "right") using 1:(1000*$2) with points pointtype 6 pointsize 1.6 title "right half"
}
unset multiplot
