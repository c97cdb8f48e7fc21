# Error over steps a period, a line a pair of time schemes
set terminal pngcairo size 900,600 font "sans,11"
set output png
set grid
set logscale xy
set datafile separator ","
set xlabel "time steps a period"
set ylabel "relative error of the crown's displacement"
set key top right
pick(name, radius, substeps) = \
    (strcol(1) eq name && column(2) == radius && column(3) == substeps ? column(5) : 1/0)
plot csv using 4:(pick("Euler", 1, 1)) with linespoints linewidth 2 title "Euler", \
     csv using 4:(pick("backward", 1, 1)) with linespoints linewidth 2 title "backward", \
     csv using 4:(pick("CrankNicolson_1", 1, 1)) with linespoints linewidth 2 title "CrankNicolson 1", \
     csv using 4:(pick("CrankNicolson_0.9", 1, 1)) with linespoints linewidth 2 title "CrankNicolson 0.9", \
     csv using 4:(pick("backward", 0.8, 1)) with linespoints linewidth 2 title "backward, structure's spectral radius 0.8", \
     csv using 4:(pick("backward", 1, 4)) with linespoints linewidth 2 title "backward, 4 substeps of the structure", \
     [25:400] 2/x with lines dashtype 2 linecolor "gray" title "order 1", \
     [25:400] 20/x**2 with lines dashtype 3 linecolor "gray" title "order 2"
