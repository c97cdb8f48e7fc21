# Displacement of A, drag and lift, and outer correctors, as far as there are such
set terminal pngcairo size 1000,900 font "sans,11"
set output png
set grid
set key top left
set style data lines
columns = system("head -n 1 ".history)
set multiplot layout 3,1
if (strstrt(columns, "uy")) {
    set ylabel "displacement of A [mm]"
    plot history using "time":"uy" title "u_y", history using "time":"ux" title "u_x"
}
if (strstrt(columns, "lift")) {
    set ylabel "force [N/m]"
    plot history using "time":"lift" title "lift", history using "time":"drag" title "drag"
}
if (strlen(coupling)) {
    set ylabel "outer correctors per time step"
    set xlabel "time [s]"
    set yrange [0:*]
    plot coupling using 1:3 with steps notitle
}
unset multiplot
