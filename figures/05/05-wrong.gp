# 05-wrong.gp - sh figures/draw/chart.sh figures/05/05-wrong.gp DATA.csv CHART.svg
high = 200
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
a = blue; b = grey; out = orange; good = green
set multiplot
set xrange [-0.2:6.0]
set yrange [-0.9:2.5]
do for [k=0:1] {
  c = k == 0 ? out : good
  set lmargin at screen 0.005 + 0.5 * k
  set rmargin at screen 0.495 + 0.5 * k
  set bmargin at screen 0.01
  set tmargin at screen 0.99
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  set label 1 (k == 0 ? "from middle to middle" : "the least move") at graph 0.04,0.90 textcolor rgb c font bold
  stats csv index 4+k using 5 nooutput
  set label 2 sprintf("%.2f m", STATS_max) at graph 0.04,0.78 textcolor rgb c
  set label 3 "floor" at 0.9,-0.45 center textcolor rgb ink front
  set label 4 "box" at 2.45,0.78 center textcolor rgb a front
  plot csv index 0 using 1:2 with filledcurves closed fc rgb b fs transparent solid 0.35 noborder, \
       csv index 0 using 1:2 with lines lc rgb b lw 1.6, \
       csv index 1 using 1:2 with filledcurves closed fc rgb a fs transparent solid 0.25 noborder, \
       csv index 1 using 1:2 with lines lc rgb a lw 1.6, \
       csv index 2+k using 1:2 with filledcurves closed fc rgb c fs transparent solid 0.15 noborder, \
       csv index 2+k using 1:2 with lines lc rgb c lw 1.6 dt 2, \
       csv index 4+k using 1:2:3:4 with vectors filled head lc rgb c lw 2.6, \
       csv index 4+k using 1:2 with points pt 7 ps 0.78 lc rgb c
}
unset multiplot
