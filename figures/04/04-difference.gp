# 04-difference.gp - sh figures/draw/chart.sh figures/04/04-difference.gp DATA.csv CHART.svg
high = 600
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
set multiplot
a = blue; b = green; near = orange; pale = grey
side(s) = s == 1 ? number(blue) : number(green)

# The panels, width 6 m and height 5 m each.
left(i) = 0.002 + 0.5 * i
top(k) = 1 - 0.5 * k
do for [k=0:1] {
  set bmargin at screen top(k) - 0.497
  set tmargin at screen top(k) - 0.003
  stats csv index 5 * k + 3 using (sqrt(($1-$3)**2 + ($2-$4)**2)) nooutput
  gap = STATS_max

  # A and B.
  set lmargin at screen left(0)
  set rmargin at screen left(0) + 0.496
  set xrange [-1.0:5.0]
  set yrange [-1.15:3.85]
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  set label 1 k == 0 ? "apart" : "overlapping" at graph 0.04,0.93 textcolor rgb ink
  set label 2 "A" at 3.25,1.75 center textcolor rgb a font bold front
  set label 3 "B" at (k == 0 ? 0.15 : 2.35),(k == 0 ? 0.8 : 0.42) center textcolor rgb b font bold front
  if (k == 0) {
    set label 4 sprintf("%.2f m", gap) at 1.5,0.28 center textcolor rgb near
  } else {
    set label 4 "a point of both" at 0.75,1.9 center textcolor rgb near
    set arrow 1 from 1.2,1.7 to 2.43,1.245 nohead front lc rgb near lw 0.8
  }
  plot csv index 5*k   using 1:2 with filledcurves closed fc rgb a fs transparent solid 0.22 noborder, \
       csv index 5*k+1 using 1:2 with filledcurves closed fc rgb b fs transparent solid 0.22 noborder, \
       csv index 5*k   using 1:2 with lines lc rgb a lw 2.2, \
       csv index 5*k+1 using 1:2 with lines lc rgb b lw 2.2, \
       csv index 5*k+3 using 1:2:($3-$1):($4-$2) with vectors nohead lc rgb near lw 2.6, \
       csv index 5*k+3 using 1:2 with points pt 7 ps 1.04 lc rgb near, \
       csv index 5*k+3 using 3:4 with points pt 7 ps 1.04 lc rgb near
  unset label
  unset arrow

  # A - B and the origin.
  set lmargin at screen left(1)
  set rmargin at screen left(1) + 0.496
  set xrange [-1.34:4.66]
  set yrange [-1.9:3.1]
  set arrow 1 from graph 0,first 0 to graph 1,first 0 nohead back lc rgb rule lw 0.8
  set arrow 2 from first 0,graph 0 to first 0,graph 1 nohead back lc rgb rule lw 0.8
  set label 2 "A − B" at (k == 0 ? 2.95 : 0.95),0.85 center textcolor rgb ink font bold front
  set label 3 "0" at (k == 0 ? -0.2 : 0.24),(k == 0 ? -0.25 : 0.14) center textcolor rgb near font bold front
  if (k == 0) {
    set label 4 sprintf("%.2f m", gap) at 0.52,0.42 center textcolor rgb near
  }
  plot csv index 5*k+2 using 1:2 with filledcurves closed fc rgb pale(grey, 0.35) fs solid 0.75 noborder, \
       csv index 5*k+4 using 1:(k == 1 ? $2 : NaN) with filledcurves closed fc rgb page fs transparent solid 0.55 noborder, \
       csv index 5*k+4 using 1:(k == 1 ? $2 : NaN) with lines lc rgb quiet lw 1.1 dt 2, \
       csv index 5*k+2 using 1:2:3:4:(side($5)) with vectors nohead lc rgb variable lw 2.4, \
       csv index 5*k+2 using 1:2 with points pt 7 ps 0.59 lc rgb ink, \
       csv index 5*k+3 using (0):(0):($1-$3):($2-$4) with vectors nohead lc rgb near lw 2.6, \
       csv index 5*k+3 using ($1-$3):($2-$4) with points pt 7 ps 1.04 lc rgb near, \
       csv index 5*k+3 using (0):(0) with points pt 7 ps 1.3 lc rgb near
  unset label
  unset arrow
}
unset multiplot
