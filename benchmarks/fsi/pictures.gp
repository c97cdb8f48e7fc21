# Error against processor time, relative to the base's: a panel for each axis, and the
# Pareto front of each scene
set terminal pngcairo size 1500,1500 font "sans,9"
set datafile separator "\t"
set logscale xy
set format y "10^{%L}"
set grid
set xlabel "processor time over the base's"
scenes = "cavity mok FSI1 FSI3 FSI2"
axes = "mesh deltaT tolerance type loads structure couplingInterval pressureTolerance acceleration motion fluidPredictor predictor"
# error of the displacement, cost over the base's, setting; front: those on the front only
rows(scene, axis, front) = sprintf("< awk -F, -v OFS='\\t' '$1 == \"%s\" && $2 == \"base\" { base = $9 } $1 == \"%s\" && $4 == \"ends\" && $2 ~ /%s/ && (\"%s\" == \"\" || $13 == \"yes\") { gsub(/\"/, \"\", $3); print $9/base, $6, $2 == \"base\" ? \"base\" : $3, $2 \" \" $3 }' results.csv | sort -g", scene, scene, axis, front)

set output "axes.png"
set ylabel "error of the displacement"
set key bottom left
set xrange [0.3:9]
set yrange [1e-7:1]
set xtics (0.5, 1, 2, 4, 8)
set multiplot layout 4,3
do for [axis in axes] {
    set title axis
    # The base has an error of its own reference on these two
    shown = axis eq "mesh" || axis eq "deltaT" ? axis : "^(base|".axis.")$"
    plot for [k=1:5] rows(word(scenes, k), shown, "") using 1:2 with points pointtype 4 + k lc k title word(scenes, k), \
        for [k=1:5] rows(word(scenes, k), shown, "") using 1:2:3 with labels left offset 0.7,0.3 font "sans,7" tc lt k notitle
}
unset multiplot

set terminal pngcairo size 1200,900 font "sans,10"
set output "front.png"
set multiplot layout 2,2
same = "^(base|tolerance|type|loads|couplingInterval|pressureTolerance|acceleration|motion|fluidPredictor|predictor)$"
# FSI1 has a few axes only
do for [scene in "cavity mok FSI3 FSI2"] {
    set title scene
    plot rows(scene, same, "") using 1:2 with points pt 6 lc "gray40" title "one choice changed", \
        rows(scene, same."|^preset$", "yes") using 1:2 with lines lc "red" title "Pareto front", \
        rows(scene, same."|^preset$", "yes") using 1:2:4 with labels left offset 0.7,0.3 font "sans,7" notitle, \
        rows(scene, "^preset$", "") using 1:2 with points pt 7 lc "blue" title "presets", \
        rows(scene, "^preset$", "") using 1:2:3 with labels left offset 0.7,-0.6 font "sans,8" tc "blue" notitle
}
unset multiplot
