# 12-hold.gp - sh figures/draw/chart.sh figures/12/12-hold.gp DATA.csv CHART.svg
high = 290
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
pull = grey; move = blue; near = orange
set xrange [-1.35:1.35]
set yrange [-1.35:1.75]
set multiplot
do for [k=1:3] {
  set lmargin at screen 0.002 + (k-1)/3.0
  set rmargin at screen k/3.0 - 0.002
  set bmargin at screen 0.005
  set tmargin at screen 0.995
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  if (k > 1) {
    set object 2 rectangle from -1.35,-1.35 to 1.35,0 behind fc rgb rule fs solid noborder
    set arrow 1 from 0,0 to 0,1.3 lc rgb near lw 2.2 front
    set label 2 "n" at 0.1,1.25 left textcolor rgb near font bold front
  }
  set label 1 (k == 1 ? "free:  w" : k == 2 ? "slides:  w − m m^T" : "sticks:  0.3 w") at 0,1.55 center textcolor rgb ink font bold front
  plot csv using (0):(0):1:2 every 4 with vectors nohead lc rgb pull lw 0.8, \
       csv using (column(2*k+1)):(column(2*k+2)) with filledcurves closed fc rgb move fs transparent solid 0.25 noborder, \
       csv using (column(2*k+1)):(column(2*k+2)) with lines lc rgb move lw 2, \
       csv using (0):(0):(column(2*k+1)):(column(2*k+2)) every 4 with vectors lc rgb move lw 1.2, \
       "+" using (0):(0) every ::0::0 with points pt 7 ps 1.17 lc rgb ink
  unset label
  unset arrow
  unset object 2
}
unset multiplot
