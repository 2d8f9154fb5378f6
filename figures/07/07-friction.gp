# 07-friction.gp - sh figures/draw/chart.sh figures/07/07-friction.gp DATA.csv CHART.svg
high = 290
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
set xrange [-2.6:2.0]
set yrange [-1.5:1.25]
set lmargin 0
set rmargin 0
set tmargin 3
set bmargin 0

stats csv index 2 using 1:2 nooutput prefix "M"
mu = M_min_x
array title[2] = ["Little sliding: all of it is undone", "Much sliding: only μ d of it"]
set multiplot
do for [k = 0:1] {
  stats csv index k every ::0::0 using 1:2 nooutput prefix "P"
  stats csv index k every ::2::2 using 1:2 nooutput prefix "E"
  set size 0.5,1
  set origin 0.5 * k,0
  unset label
  unset arrow
  unset object
  set title title[k + 1] textcolor rgb ink
  set object 1 rectangle from -2.57,-1.4 to 1.97,0 fc rgb pale(grey, 0.2) fs solid 1 noborder behind
  set object 2 polygon from 0,-1 to -mu,0 to mu,0 to 0,-1 fc rgb pale(green, 0.25) fs solid 1 noborder
  set arrow 1 from -2.57,0 to 1.97,0 nohead lw 1.5 lc rgb ink
  set arrow 2 from -mu,0 to mu,0 nohead lw 5 lc rgb green
  set arrow 3 from P_min_x,P_min_y to 0,-1 lw 2 dt 2 lc rgb ink head size 0.1,22 filled
  set arrow 4 from 0,-1 to E_min_x,E_min_y lw 3 lc rgb blue head size 0.11,24 filled front
  set arrow 5 from P_min_x,P_min_y to P_min_x,0 nohead lw 1 dt 3 lc rgb grey
  set arrow 6 from 1.0,-1 to 1.0,0 heads size 0.09,22 filled lw 1.5 lc rgb ink
  set label 1 "d" at 1.08,-0.5 font ":Italic" textcolor rgb ink
  set label 2 "previous" at P_min_x+0.12,P_min_y+0.08 left textcolor rgb ink
  set label 3 "position" at 0.1,-1.13 textcolor rgb ink
  set label 4 "μ d" at mu/2,0.17 center textcolor rgb green
  set arrow 7 from 0.02,0.08 to mu,0.08 heads size 0.06,22 filled lw 1.2 lc rgb green
  set label 5 "after" at E_min_x-0.08,0.17 right textcolor rgb blue
  set arrow 8 from P_min_x,-1.28 to 0,-1.28 heads size 0.09,22 filled lw 1.5 lc rgb ink
  set label 6 "s" at P_min_x/2-0.02,-1.16 center font ":Italic" textcolor rgb ink
  set arrow 9 from 0,-1 to 0,0 nohead lw 1 dt 3 lc rgb grey
  plot csv index k every ::0::0 using 1:2 with points pt 6 ps 1.3 lw 2 lc rgb ink, \
       csv index k every ::1::1 using 1:2 with points pt 7 ps 1.3 lc rgb ink, \
       csv index k every ::2::2 using 1:2 with points pt 7 ps 1.3 lc rgb blue
}
unset multiplot
