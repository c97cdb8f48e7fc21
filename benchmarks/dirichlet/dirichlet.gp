set terminal pngcairo size 1200,500 font ",10"
set datafile separator ","
set grid
set logscale xy
set format y "%g"
set key outside right font ",9"
methods = "'egm whole' 'egm none' nitsche lagrange penalty 'shifted 2' shifted"

set output "orders.png"
set multiplot layout 1,2
set xlabel "elements a side"
set ylabel "error in L2"
do for [degree=2:3] {
    set title sprintf("degree %d", degree)
    plot for [m in methods] sprintf("< grep '^%s,%d,' orders.csv", m, degree) \
        using 3:4 with linespoints title m
}
unset multiplot

set output "conditions.png"
set multiplot layout 1,2
set ylabel "condition number"
do for [degree=2:3] {
    set title sprintf("degree %d", degree)
    plot for [m in methods] sprintf("< grep '^%s,%d,' conditions.csv", m, degree) \
        using 3:4 with linespoints title m
}
unset multiplot

set output "cuts.png"
set multiplot layout 1,2
set xlabel "cut [element]"
set format x "%g"
set title "degree 2"
set ylabel "condition number"
plot for [m in methods] sprintf("< grep '^%s,2,' cuts.csv", m) using 3:5 with linespoints title m
set ylabel "stable explicit step over that of the whole square"
plot for [m in methods] sprintf("< grep '^%s,2,' cuts.csv", m) using 3:6 with linespoints title m
unset multiplot

set output "disc.png"
set multiplot layout 1,2
set format x "%g"
set xlabel "elements a side"
set ylabel "relative error of deflection in L2"
set yrange [1e-10:1]
do for [m in "'egm whole' nitsche"] {
    set title m
    plot for [degree=2:5] sprintf("< grep '^%s,%d,' disc.csv", m, degree) \
        using 3:4 with linespoints title sprintf("degree %d", degree)
}
unset multiplot
