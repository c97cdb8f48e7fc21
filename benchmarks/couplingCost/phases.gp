# Processor time of a time step by phase, of the runs that are compared
set terminal pngcairo size 1000,480 font "sans,10"
set output "../../doc/pictures/couplingCost.png"
set datafile separator ","
set style data histogram
set style histogram rowstacked
set style fill solid 0.8 border -1
set boxwidth 0.7
set grid y
set bmargin 6
set key outside right
set ylabel "processor time of a time step [ms]"
set yrange [0:*]
set xtics rotate by -25
# The first of each run, without those of many cells
rows = "< awk -F, 'NR > 1 && $1 != \"fineFlag\" && $1 != \"tube\" && !seen[$1 $2]++' results.csv"
titles = "mesh correctPhi U p exchange other structure"
plot for [i=1:7] rows using (1000*column(9 + i)):xtic(stringcolumn(1)."\n".stringcolumn(2)) title word(titles, i)
