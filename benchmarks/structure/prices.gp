set terminal pngcairo size 1300,950 font ",10"
set output "../../doc/pictures/flapPrices.png"
set datafile separator ","
set logscale xy
set format xy "%g"
set grid
set yrange [1e-4:200]
set key outside right font ",8"
set multiplot layout 2,2
rows(kinematics, strains, degree) = sprintf("< grep '^%s,%s,%d,' prices.csv", kinematics, strains, degree)
do for [strains in "linear nonlinear"] {
    do for [x in "unknowns seconds"] {
        set title strains." strains"
        set xlabel x eq "unknowns" ? "unknowns" : "processor seconds"
        set ylabel "error of the tip within the theory [%]"
        where = x eq "unknowns" ? 5 : 6
        plot for [p=2:5] rows("beam", strains, p) using (column(where)):8 with linespoints pt p lc "black" title sprintf("beam, degree %d", p), \
             for [p=2:5] rows("shell", strains, p) using (column(where)):8 with linespoints pt p lc "red" title sprintf("shell, %d", p), \
             for [p=1:5] rows("planeStrain", strains, p) using (column(where)):8 with linespoints pt p lc "blue" title sprintf("plane strain, %d", p), \
             for [p=1:5] rows("solid", strains, p) using (column(where)):8 with linespoints pt p lc "dark-green" title sprintf("solid, %d", p)
    }
}
