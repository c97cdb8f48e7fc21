# Error of displacement and strain by mapping, from results.csv; filled: integrated loads, open: transposed
# loads. Errors below the axis are not drawn
set terminal pngcairo size 1300,1250 font ",10"
set output "../../doc/pictures/fsiMapping.png"
set datafile separator ","
set logscale y
set format y "%g"
set grid ytics
set yrange [0.001:300]
types = "offset nearestElement nearestNeighbour rbf mortar dualMortar"
scenes = system("tail -n +2 results.csv | cut -d, -f1 | uniq")
# Configurations of a scene in their order, as x
configurations(scene) = sprintf("awk -F, '$1 == \"%s\" { c = ($2 == \"plain\" ? \"\" : $2 == \"twoPatches\" ? \"two \" : $2 \" \") $3 \":\" $4; if (!(c in k)) { k[c]; printf \"%%s;\", c } }' results.csv", scene)
rows(scene, type, loads) = sprintf("< awk -F, '$1 == \"%s\" { c = $2 $3 $4; if (!(c in k)) k[c] = n++; if ($6 == \"%s\" && $7 == \"%s\" && $8 == \"ends\") print k[c] \",\" 100*$10 \",\" 100*$11 }' results.csv; echo -9,1,1", scene, type, loads)
nth(text, i) = system(sprintf("echo '%s' | cut -d';' -f%d", text, i))
count(text) = int(system(sprintf("echo '%s' | tr -cd ';' | wc -c", text)))
set multiplot layout words(scenes),2 margins 0.06,0.985,0.03,0.95 spacing 0.05,0.05
do for [s = 1:words(scenes)] {
    scene = word(scenes, s)
    names = system(configurations(scene))
    n = count(names)
    set xrange [-0.5:n - 0.5]
    set xtics nomirror ("" -9)
    do for [i = 1:n] { set xtics add (nth(names, i) i - 1) }
    do for [measure = 2:3] {
        set title (measure == 2 ? "displacement [%], " : "strain [%], ") . scene offset 0,-0.7
        if (s == 1 && measure == 2) {
            set key at screen 0.5,0.995 center top horizontal maxrows 1 samplen 1
        } else {
            unset key
        }
        plot for [t = 1:words(types)] rows(scene, word(types, t), "integrated") \
                using ($1 + 0.11*(t - 3.5)):measure with points pt 7 ps 1.1 lc t title word(types, t), \
            for [t = 1:words(types)] rows(scene, word(types, t), "transposed") \
                using ($1 + 0.11*(t - 3.5)):measure with points pt 6 ps 1.1 lc t notitle
    }
}
unset multiplot
