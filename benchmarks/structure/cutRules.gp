set terminal pngcairo size 1300,480 font ",10"
set output "../../doc/pictures/cutRules.png"
set datafile separator ","
set logscale xy
set format xy "10^{%T}"
set grid
set key outside right font ",8"
set multiplot layout 1,2
rows(rule, degree) = sprintf("< grep '^%s,[^,]*,%d,24,' cutRules.csv | grep -v default", rule, degree)
do for [x in "points seconds"] {
    set title "clamped disc on 24 x 24 elements"
    set xlabel x eq "points" ? "points of cut elements" : "processor seconds of model and solution"
    set ylabel "error of u in the L_2 norm, relative"
    where = x eq "points" ? 6 : 8
    plot for [p=2:4] rows("boundaryExact", p) using (column(where)):11 with linespoints pt p lc "black" title sprintf("boundaryExact, degree %d", p), \
         for [p=2:4] rows("triangulated", p) using (column(where)):11 with linespoints pt p lc "red" title sprintf("triangulated, %d", p)
}
