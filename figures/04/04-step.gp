# 04-step.gp - sh figures/draw/chart.sh figures/04/04-step.gp DATA.csv CHART.svg
high = 330
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
near = orange; lower = purple
set multiplot
do for [k=0:1] {
  stats csv index 3 every ::k::k using 1 nooutput
  vx = STATS_max
  stats csv index 3 every ::k::k using 2 nooutput
  vy = STATS_max
  stats csv index 3 every ::k::k using 3 nooutput
  wx = STATS_max
  stats csv index 3 every ::k::k using 4 nooutput
  wy = STATS_max
  len = sqrt(vx*vx + vy*vy)
  bound = (vx*wx + vy*wy)/len
  set lmargin at screen 0.002 + 0.5 * k
  set rmargin at screen 0.498 + 0.5 * k
  set bmargin at screen 0.005
  set tmargin at screen 0.995
  set xrange [-0.75:4.85]
  set yrange [-1.95:3.04]
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  # The line through w, across v, and its distance from the origin.
  fx = bound*vx/len; fy = bound*vy/len
  t = k == 0 ? 1.35 : 1.6; t2 = k == 0 ? 0.75 : 1.6
  set arrow 1 from wx-t*(-vy)/len,wy-t*vx/len to wx+t2*(-vy)/len,wy+t2*vx/len nohead lc rgb near lw 1.2 dt 2 front
  set arrow 2 from 0,0 to vx,vy lc rgb blue lw 2.4 front
  set label 1 "0" at -0.16,-0.2 center textcolor rgb ink font bold
  set label 2 (k == 0 ? "v" : "v") at (k == 0 ? 1.0 : 0.75),(k == 0 ? -0.68 : -0.02) center textcolor rgb blue font bold front
  set label 3 "w" at wx+(k == 0 ? 0.3 : 0.25),wy+(k == 0 ? -0.12 : 0.05) center textcolor rgb near font bold front
  set label 4 (k == 0 ? "w reaches further: go on" : "nothing reaches further: done") at graph 0.03,0.94 left textcolor rgb ink
  set label 5 sprintf("|v| = %.2f m", len) at graph 0.97,0.13 right textcolor rgb blue
  set label 6 sprintf("v · w / |v| = %.2f m", bound) at graph 0.97,0.06 right textcolor rgb near
  plot csv index 0 using 1:2 with filledcurves closed fc rgb pale(grey, 0.35) fs solid 0.75 noborder, \
       csv index 1+k using 1:2 with linespoints lc rgb blue lw 2.6 pt 7 ps 0.98, \
       csv index 3 every ::k::k using 3:4 with points pt 7 ps 0.98 lc rgb near, \
       "+" using (0):(0) every ::0::0 with points pt 7 ps 0.91 lc rgb ink
  unset label
  unset arrow
}
unset multiplot
