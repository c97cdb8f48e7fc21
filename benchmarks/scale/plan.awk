# Usage: awk -f plan.awk fluid.csv interface.csv ../structureSpeed/speed.csv
#
# Prints the planning table as Markdown: fluid's cells and ranks, a time step's seconds and
# the memory, from what the tables measured. The interface has cells^(2/3) faces, a wall of
# a cube, the structure a control point for 2 x 2 faces; a time step has five outer
# correctors, each an exchange, and the structure factors twice in it. Beyond the tables
# everything grows by the powers given here; the fluid scales with its ranks, which it never
# does quite: so the shares of the coupling are upper bounds.
BEGIN {
    FS = ","
    correctors = 5; factorisations = 2
}
FNR == 1 {
    delete column
    for (i = 1; i <= NF; i++) column[$i] = i
    next
}
"cpu_us_per_cell_corrector" in column {
    cellSeconds = 1e-6*$column["cpu_us_per_cell_corrector"]
    # Of the last two meshes, without what the program needs by itself
    fluidMemory = ($column["fluid_MB"] - lastMemory)/($column["cells"] - lastCells)
    lastMemory = $column["fluid_MB"]
    lastCells = $column["cells"]
}
"gather_s" in column {
    faces = $column["faces"]
    # With a core for each rank: the dearest face, and the channel of the largest interface
    if ($column["ranks"] <= 2) {
        gather = atLeast(gather, ($column["gather_s"] + $column["distribute_s"])/faces)
        channel = faces == mostFaces || faces > mostFaces ? $column["channel_cpu_s"]/faces : channel
        mostFaces = atLeast(mostFaces, faces)
    }
    if ($column["ranks"] == 1) masterMemory = $column["master_MB"]/faces
    if ($column["structure_mapping_cpu_s"] != "") {
        mapping = $column["structure_mapping_cpu_s"]/faces
        mappingMemory = $column["structure_MB"]/faces
    }
}
"numeric_s" in column && $column["degree"] == 2 && $column["threads"] == 2 && $column["dof"] > 1e5 {
    unknowns = $column["dof"]
    factorSeconds = $column["numeric_s"] + $column["assembly_s"]
    solveSeconds = $column["solution_s"]
    factorMemory = 8e-6*$column["factor_entries"]
}
function atLeast(a, b) { return a > b ? a : b }
function row(cells, ranks,   faces, dof, fluid, map, solve, link) {
    faces = cells^(2/3)
    dof = 3*faces/4
    fluid = correctors*cellSeconds*cells/ranks
    link = correctors*channel*faces
    map = correctors*mapping*faces
    solve = (factorisations*factorSeconds + correctors*solveSeconds)*(dof/unknowns)^1.29
    printf "| %.0e | %d | %.1e | %.1e | %.3g | %.2g (%.2f %%) | %.2g | %.2g | %.2g | %.2g | %.2g | %.2g |\n", cells,
        ranks, faces, dof, fluid, correctors*gather*faces, 100*correctors*gather*faces/fluid, link, map, solve,
        fluidMemory*cells/ranks/1e3, masterMemory*faces/1e3,
        (mappingMemory*faces + factorMemory*(dof/unknowns)^1.16)/1e3
}
END {
    printf "%.1f us of a core for a cell and outer corrector; for a face and exchange: gather and distribution %.3f us, ",
        1e6*cellSeconds, 1e6*gather
    printf "channel %.2f us, mapping %.2f us\n\n", 1e6*channel, 1e6*mapping
    print "| cells | ranks | faces | unknowns | fluid [s] | gather, distribute [s] | channel [s] | mapping [s] | structure [s] | memory of a rank [GB] | more on the master [GB] | structure [GB] |"
    print "|---|---|---|---|---|---|---|---|---|---|---|---|"
    for (cells = 1e6; cells < 2e9; cells *= 10)
        for (ranks = 1; ranks <= 1000; ranks *= 10)
            if (cells/ranks >= 2e4 && cells/ranks <= 1e7) row(cells, ranks)
}
