set terminal pngcairo size 1200,800 font ",11"
set output "../../doc/pictures/mapping.png"
set datafile separator ","
set logscale xy
set format xy "10^{%L}"
set grid
set key font ",9" bottom left
set xlabel "time to build the mapping [s]"
set ylabel "error of a smooth field (root mean square)"
set multiplot layout 2,2
# pair, operator: columns of results.csv
row(pair, method) = sprintf("< grep '^%s,%s,' results.csv", pair, method)
drawn = "nearestNeighbour nearestElement rbfThinPlate rbfC2 rbfC6 mortar mortarDual"
do for [pair in "'2D FE-FE' '2D FV-FE' '2D FE-IBRA' '2D IBRA-FE trimmed'"] {
    set title pair
    plot for [method in drawn] row(pair, method) using 6:10 with linespoints pointtype 7 title method
}
unset multiplot
