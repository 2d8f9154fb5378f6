# 13-blocks.gp - sh figures/draw/chart.sh figures/13/13-blocks.gp DATA.csv CHART.svg
high = 330
load "figures/draw/chart.gp"
set grid ytics lc rgb rule lw 0.5 dt 1
plain = orange; blocks = blue; make = grey
set multiplot

eval box(62, 400, 52, 294)
set title "Two passes of a substep: ns a contact"
set style fill solid 1 noborder
set boxwidth 0.22
set xrange [0.5:4.9]
set xtics 1,1,4
set xlabel "points of a contact" textcolor rgb ink
set yrange [0:*]
stats csv index 0 using 2 nooutput
top = STATS_max
set label 1 "one by one" at 2.4,0.9*top right textcolor rgb plain
set label 2 "four side by side" at 2.4,0.8*top right textcolor rgb blocks font bold
set label 3 "to make a block" at 2.4,0.7*top right textcolor rgb make
plot csv index 0 using ($1-0.25):2 with boxes lc rgb plain, \
     csv index 0 using 1:3 with boxes lc rgb blocks, \
     csv index 0 using ($1+0.25):4 with boxes lc rgb make
unset label

eval box(490, 706, 52, 294)
set title "Lanes in use"
set logscale x 10
set xrange [8:4000]
set xtics (10, 100, 1000)
set xlabel "contacts"
set yrange [0:100]
set ytics ("50 %%" 50, "100 %%" 100)
plot csv index 1 using 1:2 with linespoints pt 7 ps 0.85 lc rgb blocks lw 2
unset multiplot
