# 08-orders.gp - sh figures/draw/chart.sh figures/08/08-orders.gp DATA.csv CHART.svg
high = 500
load "figures/draw/chart.gp"
set grid ytics lc rgb rule lw 0.5
set multiplot

set logscale x 10
set xrange [0.13:6e-7]
set xtics ("10 %%" 1e-1, "" 1e-2, "0.1 %%" 1e-3, "" 1e-4, "0.001 %%" 1e-5, "" 1e-6)

# Columns of order k = 0 .. 3: relaxed 2 + 3k, looked at 3 + 3k.
relaxed = "plot csv index i using 1:(column(5)/column(2)) with linespoints pt 7 ps 0.59 lc rgb blue lw 2, csv index i using 1:(column(8)/column(2)) with linespoints pt 7 ps 0.59 lc rgb orange lw 2, csv index i using 1:(column(11)/column(2)) with linespoints pt 7 ps 0.59 lc rgb green lw 2, csv index i using 1:(1) with lines lc rgb ink lw 1"
looked = "plot csv index i using 1:(column(6)/column(3)) with linespoints pt 7 ps 0.59 lc rgb blue lw 2, csv index i using 1:(column(9)/column(3)) with linespoints pt 7 ps 0.59 lc rgb orange lw 2, csv index i using 1:(column(12)/column(3)) with linespoints pt 7 ps 0.59 lc rgb green lw 2, csv index i using 1:(1) with lines lc rgb ink lw 1"

set yrange [0:1.5]
set ytics ("0" 0, "½" 0.5, "1" 1, "1½" 1.5)
set arrow 1 from 0.1,0.5 to 1e-6,0.5 nohead lc rgb grey lw 1 dt 2
set label 9 "in the paper" at 3.5e-7,0.5 textcolor rgb quiet
eval box(60, 260, 275, 466)
set title "Icosahedron, 36 sticks: relaxations"
set label 1 "repeated" at 3.5e-7,1.27 textcolor rgb orange
set label 2 "as listed" at 3.5e-7,1.08 textcolor rgb ink
set label 3 "breadth first" at 3.5e-7,0.93 textcolor rgb blue
set label 4 "largest first" at 3.5e-7,0.66 textcolor rgb green
i = 0
eval relaxed
eval box(410, 610, 275, 466)
set title "Sphere, 561 sticks: relaxations"
set label 1 "repeated" at 3.5e-7,1.14
set label 2 "as listed" at 3.5e-7,1.01
set label 3 "breadth first" at 3.5e-7,0.88
set label 4 "largest first" at 3.5e-7,0.68
i = 1
eval relaxed
unset arrow
unset label
set title "Sticks looked at (as listed: 1)"

set logscale y 10
set yrange [0.5:400]
set ytics ("1" 1, "10" 10, "100" 100)
set xlabel "until every stick is within" textcolor rgb ink
eval box(60, 260, 50, 206)
set label 4 "largest first" at 3.5e-7,17 textcolor rgb green
set label 1 "the others" at 3.5e-7,1.05 textcolor rgb ink
i = 0
eval looked
eval box(410, 610, 50, 206)
set label 4 "largest first" at 3.5e-7,240
i = 1
eval looked
unset multiplot
