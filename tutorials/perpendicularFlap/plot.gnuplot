# Tip displacement with the published extrema, and correctors a step
set terminal pngcairo size 1000,700 font "sans,11"
set output png
set multiplot layout 2,1
set grid
set key top right
set ylabel "tip u_x [m]"
set datafile commentschars "#"
plot tip using 1:2 with lines linewidth 2 title "Tokay, ".(strains eq "beam" ? "beam" : strains." strains"), \
    sprintf("< awk -F, -v s=%s '$1 == s {print $4, $5}' %s", strains, reference) \
    using 1:2 with points pointtype 6 pointsize 1.5 title "reference"
set xlabel "time [s]"
set ylabel "correctors a step"
set yrange [0:*]
plot coupling using 1:3 with steps notitle
unset multiplot
