# Displacement of the flag's end, and correctors a step
set terminal pngcairo size 1000,700 font "sans,11"
set output png
set multiplot layout 2,1
set grid
set datafile commentschars "#"
set ylabel "u_y of A [m]"
plot tip using 1:3 with lines linewidth 2 notitle
set xlabel "time [s]"
set ylabel "correctors a step"
set yrange [0:*]
plot coupling using 1:3 with steps notitle
unset multiplot
