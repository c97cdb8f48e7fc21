# Radial displacement of the wall beside linear theory, and outer correctors
set terminal pngcairo size 1000,700 font "sans,11"
set output png
set multiplot layout 2,1
set grid
set datafile commentschars "#"
set ylabel "radial displacement [mm]"
set key left top
names = "quarter middle three-quarters"
plot for [k=1:3] history using (1e3*column("time")):(column(k + 1)) with lines linewidth 2 linetype k title word(names, k), \
    for [k=1:3] theory using (1e3*column("time")):(column(k + 1)) with lines dashtype 2 linetype k title (k == 1 ? "linear theory" : "")
set xlabel "time [ms]"
set ylabel "outer correctors per time step"
set yrange [0:*]
plot coupling using (1e3*$1):3 with steps notitle
unset multiplot
