# Pictures of the verifications: curves against their references, and the error of each
# row over its limit. Data: $work/*.dat, reference/*.csv, results.csv
work = system("echo $work")."/"
set terminal pngcairo size 1000,620 font ",10"
set output "../../doc/pictures/verificationCurves.png"
set grid
set key font ",8" top left
set multiplot layout 2,3
set xlabel "share of the load"
set ylabel "tip [m]"
set title "roll-up of a cantilever"
plot work."beamRollUp.dat" using 1:(-$2) with lines linecolor 1 title "beam, -u", \
     work."beamRollUp.dat" using 1:3 with lines linecolor 2 title "beam, w", \
     work."shellRollUp.dat" using 1:(-$2) with points pointtype 2 linecolor 1 title "shell, -u", \
     work."shellRollUp.dat" using 1:4 with points pointtype 2 linecolor 2 title "shell, w", \
     "< grep '^[0-9]' reference/cantileverEndMoment.csv | tr , ' '" using 1:3 with points pointtype 6 linecolor 0 title "exact", \
     "" using 1:5 with points pointtype 6 linecolor 0 notitle
set title "cantilever with end shear"
plot work."beamShear.dat" using 1:(-$2) with lines linecolor 1 title "beam, -u", \
     work."beamShear.dat" using 1:3 with lines linecolor 2 title "beam, w", \
     work."shellShear.dat" using 1:(-$2) with points pointtype 2 linecolor 1 title "shell, -u", \
     work."shellShear.dat" using 1:4 with points pointtype 2 linecolor 2 title "shell, w", \
     "< grep '^[0-9]' reference/cantileverEndShear.csv | tr , ' '" using 1:2 with points pointtype 6 linecolor 0 title "Sze et al. 2004", \
     "" using 1:3 with points pointtype 6 linecolor 0 notitle
set title "neo-Hookean balloon"
set xlabel "stretch"
set ylabel "pressure [Pa]"
set key bottom right
plot work."balloon.dat" using (1 + $2/10):1 with lines linecolor 1 title "membrane", \
     "< grep '^[0-9]' reference/membraneBalloon.csv | tr , ' '" using 1:2 with points pointtype 6 linecolor 0 title "formula"
set title "von Mises' truss"
set xlabel "deflection [m]"
set ylabel "load [N]"
set key top left
height = 0.1
force(w) = -1000/(2*sqrt(1.01)**3)*((height + w)**3 - height**2*(height + w))
plot work."truss.dat" using (-$3):1 with lines linecolor 1 title "cable", \
     [0:0.25] force(-x) with points pointtype 6 linecolor 0 title "exact"
set title "CSM3, u_x"
set xlabel "t [s]"
set ylabel "[mm]"
unset key
plot work."csm3.dat" using 1:(1000*$2) with lines linecolor 1, 0 linecolor 0 dashtype 2, \
     -14.305 - 14.305 linecolor 0 dashtype 2
set title "CSM3, u_y (dashed: Turek, Hron 2006)"
plot work."csm3.dat" using 1:(1000*$3) with lines linecolor 1, \
     -63.607 + 65.160 linecolor 0 dashtype 2, -63.607 - 65.160 linecolor 0 dashtype 2
unset multiplot

set output "../../doc/pictures/verificationErrors.png"
set terminal pngcairo size 1000,560 font ",8"
set datafile separator ","
set title "error of each row of benchmarks/verification/results.csv over its limit (of load steps, the worst)"
set style fill solid
set boxwidth 0.7
set logscale y
set yrange [1e-5:2]
set xlabel ""
set ylabel "|error| / limit"
set xtics rotate by -60 font ",7" noenhanced
plot "< grep -vE '(endShear|rollUp)[0-9]' results.csv" every ::1 using 0:(abs($7)/$8 + 1e-5):xtic(strcol(1)." ".strcol(2)) \
         with boxes linecolor 1, 1 linecolor 0
