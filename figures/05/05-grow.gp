# 05-grow.gp - sh figures/draw/chart.sh figures/05/05-grow.gp DATA.csv CHART.svg
high = 560
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
inner = blue; low = orange; new = green
set multiplot
set xrange [-2.95:3.5]
set yrange [-1.85:3.17]
do for [k=0:3] {
  c = k % 2; r = k / 2
  set lmargin at screen 0.003 + 0.5 * c
  set rmargin at screen 0.497 + 0.5 * c
  set bmargin at screen 0.503 - 0.5 * r
  set tmargin at screen 0.997 - 0.5 * r
  stats csv index 2+3*k every ::2::2 using (sqrt($1**2+$2**2)) nooutput
  h = STATS_max
  stats csv index 3+3*k every ::1::1 using (sqrt($1**2+$2**2)) nooutput
  top = STATS_max
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  set label 1 sprintf("%.3f m", h) at graph 0.03,0.94 front textcolor rgb low font bold
  set label 2 sprintf("≤ depth ≤ %.3f m", top) at graph 0.245,0.94 front textcolor rgb ink
  set label 3 "A − B" at 1.35,1.75 center textcolor rgb quiet front
  set label 4 "0" at -0.2,0.2 center textcolor rgb low front
  set label 5 "w" at (k==0 ? 2.02 : k==1 ? -2.2 : k==2 ? 0.55 : 0.55),(k==0 ? -1.25 : k==1 ? -0.62 : -1.62) center textcolor rgb new front
  plot csv index 0 using 1:2 with filledcurves closed fc rgb pale(grey, 0.35) fs solid 0.6 noborder, \
       csv index 1+3*k using 1:2 with filledcurves closed fc rgb inner fs transparent solid 0.22 noborder, \
       csv index 1+3*k using 1:2 with lines lc rgb inner lw 1.8, \
       csv index 2+3*k every ::0::1 using 1:2 with lines lc rgb low lw 3.2, \
       csv index 2+3*k every ::2::2 using (0):(0):1:2 with vectors nohead lc rgb low lw 2, \
       csv index 3+3*k every ::0::0 using 1:2 with points pt 7 ps 1.43 lc rgb new, \
       csv index 2+3*k every ::2::2 using (0):(0) with points pt 7 ps 1.17 lc rgb low
}
unset multiplot
