# Correctors a step of each acceleration against the density ratio, beside those of the prescribed motion
set terminal pngcairo size 1100,450 font "sans,10"
set output "../../doc/pictures/coupledRuns.png"
set datafile separator ","
set logscale x
set format x "10^{%L}"
set grid
set key top left
set xlabel "density of the fluid over the structure's"
set ylabel "correctors a step"
set yrange [2:13]
rows(scene, setting) = sprintf("< awk -F, '$1 == \"%s\" && $3 == \"acceleration\" && $4 == \"%s\" && $13 != \"stopped\"' results.csv | sort -t, -g -k2", scene, setting)
set multiplot layout 1,2
do for [scene in "flap ring"] {
    set title scene
    plot for [s in "prescribed block iqnIls mvqn aitken explicit"] rows(scene, s) using 2:6 with linespoints title s
}
unset multiplot
