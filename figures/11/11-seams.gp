# 11-seams.gp - sh figures/draw/chart.sh figures/11/11-seams.gp DATA.csv CHART.svg
high = 290
load "figures/draw/chart.gp"
set multiplot

# The drawing: a corner that is in two pieces, and three ways out.
unset border; unset tics; unset grid
eval box(0, 400, 0, 290)
set xrange [0:400]
set yrange [0:290]
set style arrow 1 head filled size screen 0.011,22 lc rgb blue lw 2.2
set style arrow 2 head filled size screen 0.011,22 lc rgb orange lw 2.2
set object 1 rectangle from 20,40 to 190,150 fc rgb purple fs transparent solid 0.15 border lc rgb purple
set object 2 rectangle from 190,40 to 380,150 fc rgb green fs transparent solid 0.15 border lc rgb green
set object 3 rectangle from 70,118 to 216,250 fc rgb grey fs transparent solid 0.15 border lc rgb grey
set object 4 circle at 216,118 size 4 fc rgb ink fs solid 1 front
set arrow 1 from 216,118 to 216,156 arrowstyle 1
set arrow 2 from 212,118 to 176,118 arrowstyle 2
set label 1 "C" at 60,70 textcolor rgb purple font bold
set label 2 "B" at 340,70 textcolor rgb green font bold
set label 3 "A" at 90,225 textcolor rgb quiet font bold
set label 4 "out of B, and of the floor" at 224,172 textcolor rgb blue front
set label 5 "shorter, but into C" at 182,96 right textcolor rgb orange front
set label 6 "two ways out of B" at 200,276 center font bold textcolor rgb ink
plot NaN notitle
unset object; unset arrow; unset label
eval axes

eval box(470, 700, 52, 250)
set title "Seams passed until it stands"
set xlabel "speed, m/s"
set logscale x 2
set xrange [0.4:80]
set yrange [-3:108]
set xtics ("0.5" 0.5, "2" 2, "8" 8, "32" 32)
set ytics ("0" 0, "50" 50, "100" 100)
set label 1 "the floor as one" at 0.5,93 textcolor rgb blue font bold
set label 2 "each tile alone" at 0.7,40 textcolor rgb orange font bold
set label 3 "law" at 22,52 textcolor rgb quiet
plot csv index 0 using 1:4 with lines lc rgb quiet lw 1 dt 2, \
     csv index 0 using 1:2 with points pt 7 ps 0.6 lc rgb orange, \
     csv index 0 using 1:3 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
