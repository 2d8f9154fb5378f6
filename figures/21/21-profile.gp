# 21-profile.gp - sh figures/draw/chart.sh figures/21/21-profile.gp DATA.csv CHART.svg
high = 320
load "figures/draw/chart.gp"
set style fill solid 1 noborder
array phase[7] = ["pairs", "contacts", "prepare", "solve", "cloth", "move", "sleep"]
array colour[7] = [grey, pale(blue, 0.5), red, green, grey, blue, purple]
array title[3] = ["Room of 50: ms a step", "Cloth on a cube", "Cloth on a rope"]
set multiplot
set lmargin 6
set rmargin 1
set tmargin 3
set bmargin 3.6
set xrange [0:6]
set yrange [0:*]
set xtics 2
set xlabel "seconds of the scene" textcolor rgb ink
set size 0.275,1
do for [k = 0:2] {
  set origin 0.277 * k,0
  set title title[k+1] offset 0,-0.3
  plot for [i = 7:1:-1] csv index k using 1:(sum [j = 2:i+1] column(j)) with filledcurves x1 lc rgb colour[i]
}
set origin 0.83,0
set size 0.17,1
unset border
unset tics
unset xlabel
unset title
set lmargin 0
set xrange [0:1]
set yrange [0:1]
do for [i = 1:7] {
  set label i phase[i] at 0.22,0.2+0.1*i textcolor rgb ink
  set object i rectangle from 0.02,0.17+0.1*i to 0.16,0.23+0.1*i fillcolor rgb colour[i] fillstyle solid noborder
}
plot NaN
unset multiplot
