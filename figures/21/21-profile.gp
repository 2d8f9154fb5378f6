# 21-profile.gp - sh figures/draw/chart.sh figures/21/21-profile.gp DATA.csv CHART.svg
high = 320
load "figures/draw/chart.gp"
set style fill solid 1 noborder
array phase[7] = ["pairs", "contacts", "prepare", "solve", "cloth", "move", "sleep"]
array colour[7] = [grey, blue, red, green, orange, purple, ink]
array title[3] = ["Room of 50: ms a step", "Cloth on a cube", "Cloth on a rope"]
set multiplot
set xrange [0:6]
set yrange [0:*]
set xtics 2
set xlabel "time in the scene, s" textcolor rgb ink
do for [k = 0:2] {
  eval box(46 + 203 * k, 195 + 203 * k, 52, 284)
  set title title[k+1] offset 0,-0.3
  plot for [i = 7:1:-1] csv index k using 1:(sum [j = 2:i+1] column(j)) with filledcurves x1 lc rgb colour[i]
}
eval box(625, 715, 52, 284)
unset grid
unset border
unset tics
unset xlabel
unset title
set xrange [0:1]
set yrange [0:1]
do for [i = 1:7] {
  set label i phase[i] at 0.22,0.2+0.1*i textcolor rgb ink
  set object i rectangle from 0.02,0.17+0.1*i to 0.16,0.23+0.1*i fillcolor rgb colour[i] fillstyle solid noborder
}
plot NaN
unset multiplot
