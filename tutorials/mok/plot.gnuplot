# Displacement of A and B with the published history, and outer correctors
set terminal pngcairo size 1000,700 font "sans,11"
set output png
set multiplot layout 2,1
set grid
set key top right
set ylabel "u_x [cm]"
set datafile commentschars "#"
plot history using "time":"A" with lines linewidth 2 title "A, Tokay", \
    history using "time":"B" with lines linewidth 2 title "B, Tokay", \
    "< tr , ' ' < reference/history.csv" using "time_s":"A" with points pointtype 6 title "A, Kratos", \
    "< tr , ' ' < reference/history.csv" using "time_s":"B" with points pointtype 6 title "B, Kratos"
set xlabel "time [s]"
set ylabel "outer correctors per time step"
set yrange [0:*]
plot coupling using 1:3 with steps notitle
unset multiplot
