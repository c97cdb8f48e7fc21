# Displacement of the floor's middle, and outer correctors
set terminal pngcairo size 1000,700 font "sans,11"
set output png
set multiplot layout 2,1
set grid
set ylabel "u_y of the middle [m]"
set datafile commentschars "#"
plot history using "time":"M" with lines linewidth 2 notitle
set xlabel "time [s]"
set ylabel "outer correctors per time step"
set yrange [0:*]
plot coupling using 1:3 with steps notitle
unset multiplot
