# 04-corners.gp - sh figures/draw/chart.sh figures/04/04-corners.gp DATA.csv CHART.svg
high = 330
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
set multiplot
a = blue; b = green; near = orange
do for [k=0:1] {
  set lmargin at screen 0.002 + 0.5 * k
  set rmargin at screen 0.498 + 0.5 * k
  set bmargin at screen 0.005
  set tmargin at screen 0.995
  set xrange [-0.2:4.4]
  set yrange [-0.15:3.95]
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  set label 2 "A" at (k == 0 ? 0.9 : 0.6),(k == 0 ? 0.7 : 1.8) center textcolor rgb a font bold front
  set label 3 "B" at (k == 0 ? 2.1 : 2.05),(k == 0 ? 2.6 : 3.2) center textcolor rgb b font bold front
  stats csv index 3*k+2 using (sqrt(($1-$3)**2+($2-$4)**2)) nooutput
  far = STATS_max
  stats csv index 3*k+2 using (sqrt(($5-$7)**2+($6-$8)**2)) nooutput
  gap = STATS_max
  if (k == 0) {
    set label 4 sprintf("nearest corners:\n%.2f m apart", far) at 4.3,3.65 right textcolor rgb ink
    set label 5 sprintf("gap %.2f m", gap) at 1.75,1.4 right textcolor rgb near
  } else {
    set label 4 "no corner\nof either lies\nin the other" at 4.3,3.65 right textcolor rgb ink
  }
  plot csv index 3*k   using 1:2 with filledcurves closed fc rgb a fs transparent solid 0.22 noborder, \
       csv index 3*k+1 using 1:2 with filledcurves closed fc rgb b fs transparent solid 0.22 noborder, \
       csv index 3*k   using 1:2 with lines lc rgb a lw 2.2, \
       csv index 3*k+1 using 1:2 with lines lc rgb b lw 2.2, \
       csv index 3*k+2 using 1:2:(k == 0 ? $3-$1 : NaN):($4-$2) with vectors nohead lc rgb ink lw 1.4 dt 2, \
       csv index 3*k+2 using 5:6:(k == 0 ? $7-$5 : NaN):($8-$6) with vectors nohead lc rgb near lw 3.2, \
       csv index 3*k+2 using (k == 0 ? $5 : NaN):6 with points pt 7 ps 0.85 lc rgb near, \
       csv index 3*k+2 using (k == 0 ? $7 : NaN):8 with points pt 7 ps 0.85 lc rgb near
  unset label
}
unset multiplot
