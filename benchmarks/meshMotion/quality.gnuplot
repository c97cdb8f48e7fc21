# Smallest volume ratio and largest non-orthogonality over the tip's motion, flag
set terminal pngcairo size 1000,420 font "sans,10"
set output png
set grid
set datafile separator ","
set multiplot layout 1,2
set xlabel "motion of the flag's tip [mm]"
set xrange [0:160]
set arrow from 80, graph 0 to 80, graph 1 nohead dashtype 3 linecolor "gray"
pick(name, shape, value) = (strcol(1) eq "flag" && column(2) == shape && strcol(3) eq name ? column(value) : 1/0)
set ylabel "smallest volume ratio"
set yrange [-0.6:1]
set ytics 0.2
set key bottom left Left reverse samplen 2
set xtics 20
plot csv using (1000*$4):(pick("harmonicBasis-root", 0, 6)) with linespoints linewidth 2 title "harmonicBasis", \
     csv using (1000*$4):(pick("harmonicBasis-linear-noRotation", 0, 6)) with linespoints linewidth 2 title "without rotation, linear", \
     csv using (1000*$4):(pick("displacementLaplacian-linear-1", 0, 6)) with linespoints title "displacementLaplacian, linear, 1 sweep", \
     csv using (1000*$4):(pick("displacementLaplacian-linear-60", 0, 6)) with linespoints title "60 sweeps", \
     csv using (1000*$4):(pick("displacementLaplacian-quadratic-60", 0, 6)) with linespoints title "quadratic, 60 sweeps"
set ylabel "largest non-orthogonality [degrees]"
set yrange [45:95]
set ytics 10
unset key
plot csv using (1000*$4):(pick("harmonicBasis-root", 0, 5)) with linespoints linewidth 2, \
     csv using (1000*$4):(pick("harmonicBasis-linear-noRotation", 0, 5)) with linespoints linewidth 2, \
     csv using (1000*$4):(pick("displacementLaplacian-linear-1", 0, 5)) with linespoints, \
     csv using (1000*$4):(pick("displacementLaplacian-linear-60", 0, 5)) with linespoints, \
     csv using (1000*$4):(pick("displacementLaplacian-quadratic-60", 0, 5)) with linespoints
