# 04-support.gp - sh figures/draw/chart.sh figures/04/04-support.gp DATA.csv CHART.svg
high = 290
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
a = blue; b = green; near = orange
array X[3]
array Y[3]
do for [k=1:3] {
  stats csv index 3 every ::k-1::k-1 using 1 nooutput
  X[k] = STATS_max
  stats csv index 3 every ::k-1::k-1 using 2 nooutput
  Y[k] = STATS_max
}
stats csv index 4 using 1 nooutput
dx = STATS_max
stats csv index 4 using 2 nooutput
dy = STATS_max
array CX[3] = [2.95, 0.75, 2.2]
array CY[3] = [1.65, 1.0, 0.7]
set multiplot
do for [k=1:3] {
  s = k == 2 ? -1 : 1
  set lmargin at screen 0.002 + (k-1)/3.0
  set rmargin at screen k/3.0 - 0.002
  set bmargin at screen 0.005
  set tmargin at screen 0.995
  set xrange [CX[k]-2.75:CX[k]+2.75]
  set yrange [CY[k]-3.25:CY[k]+3.35]
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  # The line across d through the support, and d itself from there.
  set arrow 1 from X[k]-1.25*s*(-dy),Y[k]-1.25*s*dx to X[k]+1.25*s*(-dy),Y[k]+1.25*s*dx nohead lc rgb near lw 1.2 dt 2
  set arrow 2 from X[k],Y[k] to X[k]+0.9*s*dx,Y[k]+0.9*s*dy lc rgb near lw 2.4 front
  set label 1 (k == 2 ? "−d" : "d") at X[k]+(k == 2 ? -0.95*dx-0.05 : 0.95*dx+0.08),Y[k]+s*0.95*dy+(k == 2 ? -0.1 : 0.2) center textcolor rgb near font bold
  set label 2 (k == 1 ? "A" : k == 2 ? "B" : "A − B") at (k == 1 ? 2.75 : k == 2 ? 0.75 : 1.7),CY[k] center textcolor rgb (k == 1 ? a : k == 2 ? b : ink) font bold front
  set label 3 (k == 1 ? "s_A(d)" : k == 2 ? "s_B(−d)" : "s_A(d) − s_B(−d)") at graph 0.5,0.07 center textcolor rgb ink
  if (k < 3) {
    plot csv index k-1 using 1:2 with filledcurves closed fc rgb (k == 1 ? a : b) fs transparent solid 0.22 noborder, \
         csv index k-1 using 1:2 with lines lc rgb (k == 1 ? a : b) lw 2.2, \
         csv index 3 every ::k-1::k-1 using 1:2 with points pt 7 ps 1.17 lc rgb near
  } else {
    set label 4 "0" at -0.02,-0.25 center textcolor rgb ink font bold
    plot csv index 2 using 1:2 with filledcurves closed fc rgb pale(grey, 0.35) fs solid 0.75 noborder, \
         csv index 2 using 1:2:3:4:($5 == 1 ? number(blue) : number(green)) with vectors nohead lc rgb variable lw 2.4, \
         csv index 3 every ::2::2 using 1:2 with points pt 7 ps 1.17 lc rgb near, \
         "+" using (0):(0) every ::0::0 with points pt 7 ps 0.78 lc rgb ink
  }
  unset label
  unset arrow
}
unset multiplot
