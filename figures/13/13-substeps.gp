# 13-substeps.gp - sh figures/draw/chart.sh figures/13/13-substeps.gp DATA.csv CHART.svg
high = 576
load "figures/draw/chart.gp"

set multiplot

eval box(72, 330, 332, 542)
set title "A heavy cube on one of 1 kg: sag"
set logscale xy 10
set xrange [0.8:1300]
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000)
set xlabel "mass of the upper cube, kg" textcolor rgb ink
set yrange [0.006:500]
set ytics ("0.01 mm" 0.01, "0.1 mm" 0.1, "1 mm" 1, "1 cm" 10, "10 cm" 100)
set label 1 "2 substeps" at 60,230 right textcolor rgb ink
set label 2 "4" at 1400,350 textcolor rgb ink
set label 3 "8" at 1400,86 textcolor rgb ink
set label 4 "16" at 1400,21 textcolor rgb ink
set label 5 "32" at 1400,5.4 textcolor rgb ink
plot for [c=2:6] csv index 1 using 1:(column(c) < 400 ? column(c) : NaN) with lines lc rgb pale(blue, 0.45) lw 1.6, \
     for [c=2:6] csv index 0 using 1:(column(c) < 400 ? column(c) : NaN) with points pt 7 ps 0.85 lc rgb blue
unset label

eval box(440, 706, 332, 542)
set title "Ten cubes: sag"
set logscale x 2
set xrange [1.7:38]
set xtics (2, 4, 8, 16, 32)
set xlabel "passes a frame"
set yrange [0.2:300]
set ytics ("1 mm" 1, "1 cm" 10, "10 cm" 100)
set label 1 "two substeps,\nmore iterations" at 7,52 textcolor rgb orange
set label 2 "more\nsubsteps" at 3.1,3.6 textcolor rgb blue font bold
plot csv index 3 using 1:2 with linespoints pt 6 ps 0.91 lc rgb orange lw 1.6, \
     csv index 2 using 1:2 with linespoints pt 7 ps 0.91 lc rgb blue lw 2
unset label

eval box(72, 580, 52, 242)
set title "Ten cubes, 8 substeps: sag"
unset logscale
set xrange [0:1]
set xtics 0,0.25,1
set xlabel "time, s"
set yrange [0:60]
set ytics ("2 cm" 20, "4 cm" 40, "6 cm" 60)
set label 1 "from nothing in\nevery substep" at 1.02,53 textcolor rgb orange
set label 2 "warm-started" at 1.02,8.5 textcolor rgb blue font bold
plot csv index 5 using 1:2 with lines lc rgb orange lw 1.6, \
     csv index 4 using 1:2 with lines lc rgb blue lw 2
unset multiplot
