set terminal pngcairo size 1200,800 font ",11"
set output "../../doc/pictures/mapping.png"
set datafile separator ","
set logscale xy
set format xy "10^{%L}"
set grid
set key font ",9" bottom left
set xlabel "time to build the mapping [s]"
set ylabel "error of a smooth field (root mean square)"
# pair, operator: columns of results.csv
row(pair, method) = sprintf("< grep '^%s,%s,' results.csv", pair, method)
fromMesh = "nearestNeighbour nearestElement rbfThinPlate rbfPartition rbfC2 rbfC6 mortar"
all = fromMesh . " mortarDual"
drawn(pair) = strstrt(pair, "D IBRA") ? "nearestElement mortar" : strstrt(pair, "IBRA") ? fromMesh : all
# The same colour in each part.
colour(method) = sum [i=1:words(all)] (word(all, i) eq method ? i : 0)
set multiplot layout 2,2
do for [pair in "'2D FE-FE' '2D FV-FE' '2D FE-IBRA' '2D IBRA-FE trimmed'"] {
    set title pair
    plot for [method in drawn(pair)] row(pair, method) using 6:9 \
        with linespoints pointtype 7 linecolor colour(method) title method
}
unset multiplot
