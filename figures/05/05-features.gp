# 05-features.gp - sh figures/draw/chart.sh figures/05/05-features.gp DATA.csv CHART.svg
high = 540
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
a = blue; b = green; hit = orange
name(i, j) = sprintf("a_%d − b_%d", i, j)
set multiplot
do for [k=0:1] {
  set bmargin at screen 0.503 - 0.5 * k
  set tmargin at screen 0.997 - 0.5 * k
  set lmargin at screen 0.003
  set rmargin at screen 0.497
  set xrange [-2.1:2.3]
  set yrange [-1.15:2.25]
  set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
  set label 1 (k == 0 ? "a vertex of A in a face of B" : "an edge of A across an edge of B") at graph 0.03,0.94 front textcolor rgb ink font bold
  set label 2 "A" at (k == 0 ? -0.3 : -1.05),(k == 0 ? 1.35 : 1.25) center front textcolor rgb a font bold
  set label 3 "B" at -1.55,(k == 0 ? -0.75 : -0.45) center front textcolor rgb b font bold
  plot csv index 5*k+1 using 1:2:3:4 with vectors nohead lc rgb b lw 1.3, \
       csv index 5*k using 1:2:3:4 with vectors nohead lc rgb a lw 1.3, \
       csv index 5*k+3 using 1:2 with filledcurves closed fc rgb b fs transparent solid 0.25 noborder, \
       csv index 5*k+3 using 1:2 with lines lc rgb b lw 3.4, \
       csv index 5*k+2 using 1:2 with lines lc rgb a lw 3.4, \
       csv index 5*k+3 using 1:2 with points pt 7 ps 1.17 lc rgb b, \
       csv index 5*k+2 using 1:2 with points pt 7 ps 1.17 lc rgb a, \
       csv index 5*k+3 using 1:2:3 with labels offset 0.4,-1.0 textcolor rgb b font bold, \
       csv index 5*k+2 using 1:2:3 with labels offset 0.4,1.0 textcolor rgb a font bold
  unset label
  set lmargin at screen 0.503
  set rmargin at screen 0.997
  set xrange [-0.75:4.0]
  set yrange [-0.95:2.72]
  set label 1 "the hit face of A − B" at graph 0.03,0.94 front textcolor rgb ink font bold
  plot csv index 5*k+4 every ::0::2 using 1:2 with filledcurves closed fc rgb hit fs transparent solid 0.2 noborder, \
       "< awk '/^# the hit face/ { n++; next } n == ".(k+1)." && NF == 4 { r[++m] = $1 \" \" $2 } END { print r[1]; print r[2]; print r[3]; print r[1] }' ".csv using 1:2 with lines lc rgb hit lw 2.4, \
       csv index 5*k+4 every ::0::2 using 1:2 with points pt 7 ps 1.17 lc rgb hit, \
       csv index 5*k+4 every ::0::1 using 1:2:(name($3,$4)) with labels offset 0,-1.2 textcolor rgb hit font bold, \
       csv index 5*k+4 every ::2::2 using 1:2:(name($3,$4)) with labels offset 0,1.2 textcolor rgb hit font bold, \
       csv index 5*k+4 every ::3::3 using 1:2 with points pt 7 ps 0.98 lc rgb ink, \
       csv index 5*k+4 every ::3::3 using 1:2:("v") with labels offset 1.2,0.8 textcolor rgb ink font bold
  unset label
}
unset multiplot
