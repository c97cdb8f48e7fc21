set terminal pngcairo size 1100,480 font ",10"
set output "../../doc/pictures/structureSpeed.png"
set datafile separator ","
set logscale xy
set format xy "10^{%L}"
set grid
set key font ",9" top left
set xlabel "unknowns"
set ylabel "seconds on one core"
row(degree) = sprintf("< grep '^%d,1,' speed.csv", degree)
set multiplot layout 1,2
do for [degree in "2 3"] {
    set title "one Newton iteration of a shell of degree ".degree
    plot row(int(degree)) using 3:10 with linespoints pointtype 7 title "assembly of the tangent", \
         "" using 3:11 with linespoints pointtype 7 title "symbolic factorisation (once)", \
         "" using 3:12 with linespoints pointtype 7 title "numeric factorisation", \
         "" using 3:13 with linespoints pointtype 7 title "solution"
}
unset multiplot
