# 10-tin.gp - sh figures/draw/chart.sh figures/10/10-tin.gp DATA.csv CHART.svg
# Blocks of either tin: outline, axis, two sides and the balls of the capsule, and
# the lines down from the axis to the lowest points of both ends.
high = 270
load "figures/draw/chart.gp"
set datafile separator comma
unset border
unset tics
set size ratio -1
set style fill solid 0.25 noborder
set multiplot layout 1,2
set lmargin 0.5
set rmargin 0.5
set tmargin 2.6
set bmargin 2.6
set xrange [-1.25:1.45]
set yrange [-0.12:1.35]
set arrow 1 from -1.25,0 to 1.45,0 nohead lc rgb ink lw 1.2

tin(k) = sprintf("plot csv index %d with filledcurves closed lc rgb purple, csv index %d with lines lc rgb purple, csv index %d with lines lc rgb purple lw 2.5, csv index %d with lines lc rgb orange dt 2, csv index %d with lines lc rgb orange dt 2, csv index %d using 1:2:3 with circles fill empty lc rgb orange dt 2, csv index %d with lines lc rgb ink dt 3, csv index %d with lines lc rgb ink dt 3, csv index %d using 1:2 with points pt 7 ps 0.5 lc rgb ink", k, k, k + 1, k + 2, k + 3, k + 4, k + 5, k + 6, k + 4)

set title "lying"
set label 1 "r" at -0.7,0.19 textcolor rgb ink front
set label 2 "the capsule has the tin's radius" at graph 0.5,-0.06 center textcolor rgb ink front
eval tin(1)

set title "leaning by φ"
set label 1 "r / cos φ" at -0.55,0.16
set label 2 "thicker, and r tan φ further along"
eval tin(8)
unset multiplot
