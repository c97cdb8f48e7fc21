set terminal pngcairo size 1100,500
set output "evaluations.png"
set datafile separator ","
set style data histograms
set style fill solid
set ylabel "evaluations of the fluid a step (50: fails)"
set xtics rotate by -30
set key outside top horizontal
# Rows of the exact fluid at 1e-8 come first, the four methods of a case together.
row(method) = sprintf("< grep '^[^,]*,%s,1e-08,0,0,' results.csv", method)
plot row("aitken") using 6:xtic(1) title "Aitken", \
     row("iqnIls") using 6 title "IQN-ILS, 15 steps", \
     row("mvqn") using 6 title "MVQN", \
     row("block") using 6 title "block"
