set terminal pngcairo size 1200,900
set output "prices.png"
set datafile separator ","
set logscale xy
set format y "10^{%L}"
set ylabel "error of the tip against the same theory, percent"
set key outside right
set multiplot layout 2,2
rows(kinematics, strains, degree) = sprintf("< grep '^%s,%s,%d,' prices.csv", kinematics, strains, degree)
do for [strains in "linear nonlinear"] {
    do for [x in "unknowns seconds"] {
        set title strains." strains"
        set xlabel x eq "unknowns" ? "unknowns" : "processor seconds"
        where = x eq "unknowns" ? 5 : 6
        plot for [p=2:5] rows("beam", strains, p) using (column(where)):8 with linespoints pt 4 lc p title sprintf("beam %d", p), \
             for [p=2:5] rows("shell", strains, p) using (column(where)):8 with linespoints pt 6 lc p title sprintf("shell %d", p), \
             for [p=1:5] rows("planeStrain", strains, p) using (column(where)):8 with linespoints pt 8 lc p title sprintf("plane strain %d", p), \
             for [p=1:5] rows("solid", strains, p) using (column(where)):8 with linespoints pt 12 lc p title sprintf("solid %d", p)
    }
}
