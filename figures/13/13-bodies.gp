# 13-bodies.gp - gnuplot -e "csv='...'; png='...'" figures/13/13-bodies.gp
set encoding utf8
set terminal pngcairo size 1800,1700 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
unset key
passes = "#0072b2"; steps = "#009e73"; cold = "#d55e00"; grey = "#606060"
small = "DejaVu Sans,17"
bold = "DejaVu Sans Bold,22"

# Labels stand at their points, wherever a machine's clock puts these.
stats csv index 0 using 2 nooutput
few = STATS_min
last = STATS_max
stats csv index 0 using 4 nooutput
least = STATS_min
stats csv index 0 using 3 nooutput
low = STATS_max
stats csv index 1 using 2 nooutput
first = STATS_min
end = STATS_max
stats csv index 1 using 3 nooutput
high = STATS_max
stats csv index 1 using 4 nooutput
most = STATS_max

set multiplot
set bmargin 3.6
set tmargin 3
set logscale xy 10
set xrange [0.55*first:1.6*end]
set xtics (0.05, 0.1, 0.2, 0.5, 1)
set xlabel "ms a step" textcolor rgb "#404040"

set origin 0,0.49
set size 0.5,0.51
set lmargin 11
set rmargin 2
set title "Fifty bodies: deepest overlap, of a radius" font "DejaVu Sans,26" offset 0,-0.3
set yrange [0.05:12]
set ytics ("0.1 %%" 0.1, "1 %%" 1, "10 %%" 10)
set label 3 "by passes" at 1.08*few,1.1*low left textcolor rgb passes font bold
set label 4 "by substeps" at 1.16*first,1.15*high left textcolor rgb steps
plot csv index 1 using 2:3 with linespoints pt 7 ps 1.1 lc rgb steps lw 1.6, \
     csv index 1 using 2:3:1 with labels font small textcolor rgb steps offset 1.2,0.5, \
     csv index 0 using 2:3 with linespoints pt 7 ps 1.3 lc rgb passes lw 2, \
     csv index 0 using 2:3:1 with labels font small textcolor rgb passes offset -1.2,0.3
unset label

set origin 0.5,0.49
set title "Joules left after six seconds" offset 0,-0.3
set yrange [1e-14:3e-4]
set format y "10^{%T}"
set ytics ("10^{-12}" 1e-12, "10^{-9}" 1e-9, "10^{-6}" 1e-6)
set label 3 "by passes" at 1.12*few,1.5e-7 left textcolor rgb passes font bold
set label 4 "by substeps" at 1.1*first,1.5*most left textcolor rgb steps
plot csv index 1 using 2:4 with linespoints pt 7 ps 1.1 lc rgb steps lw 1.6, \
     csv index 1 using 2:4:1 with labels font small textcolor rgb steps offset -1.2,-0.6, \
     csv index 0 using 2:4 with linespoints pt 7 ps 1.3 lc rgb passes lw 2, \
     csv index 0 using 2:4:1 with labels font small textcolor rgb passes offset 1.3,0.6
unset label

set origin 0,0
set size 1,0.47
set lmargin 14
set rmargin 24
set title "Ten cubes, one on the other, awake for ten seconds: drift of a cube"
set xrange [1.8:70]
set xtics (2, 4, 8, 16, 32, 64)
set xlabel "passes a substep"
set yrange [0.005:6000]
set ytics ("0.01 mm" 0.01, "0.1 mm" 0.1, "1 mm" 1, "1 cm" 10, "10 cm" 100, "1 m" 1000)
set label 1 "without memory" at 76,1.1 textcolor rgb cold
set label 2 "with memory" at 76,0.015 textcolor rgb passes font bold
set label 3 "fallen" at 2.05,370 textcolor rgb grey
plot csv index 3 using 1:2 with linespoints pt 6 ps 1.3 lc rgb cold lw 1.6, \
     csv index 2 using 1:2 with linespoints pt 7 ps 1.3 lc rgb passes lw 2
unset multiplot
