# 05-wrong.gp - gnuplot -e "csv='...'; png='...'" figures/05/05-wrong.gp
set encoding utf8
set terminal pngcairo size 1400,380 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
unset key
unset border
unset tics
set size ratio -1
a = "#0072b2"; b = "#7f7f7f"; out = "#d55e00"; good = "#009e73"; ink = "#404040"
set multiplot
set xrange [-0.2:6.0]
set yrange [-0.9:2.5]
do for [k=0:1] {
  c = k == 0 ? out : good
  set lmargin at screen 0.005 + 0.5 * k
  set rmargin at screen 0.495 + 0.5 * k
  set bmargin at screen 0.01
  set tmargin at screen 0.99
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb "#f7f6f4" fs solid noborder
  set label 1 (k == 0 ? "from middle to middle" : "the least move") at graph 0.04,0.90 textcolor rgb c font "DejaVu Sans Bold,25"
  stats csv index 4+k using 5 nooutput
  set label 2 sprintf("%.2f m", STATS_max) at graph 0.04,0.78 textcolor rgb c font "DejaVu Sans,24"
  set label 3 "floor" at 0.9,-0.45 center textcolor rgb "#505050" front
  set label 4 "box" at 2.45,0.78 center textcolor rgb a front
  plot csv index 0 using 1:2 with filledcurves closed fc rgb b fs transparent solid 0.35 noborder, \
       csv index 0 using 1:2 with lines lc rgb b lw 1.6, \
       csv index 1 using 1:2 with filledcurves closed fc rgb a fs transparent solid 0.25 noborder, \
       csv index 1 using 1:2 with lines lc rgb a lw 1.6, \
       csv index 2+k using 1:2 with filledcurves closed fc rgb c fs transparent solid 0.15 noborder, \
       csv index 2+k using 1:2 with lines lc rgb c lw 1.6 dt 2, \
       csv index 4+k using 1:2:3:4 with vectors filled head lc rgb c lw 2.6, \
       csv index 4+k using 1:2 with points pt 7 ps 1.2 lc rgb c
}
unset multiplot
