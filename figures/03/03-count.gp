# 03-count.gp - sh figures/draw/chart.sh figures/03/03-count.gp DATA.csv CHART.svg
high = 230
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
set multiplot
array colour[3] = [orange, purple, blue]
array says[3] = ["both cells fold", "the right cell folds", "nothing folds"]
do for [k=0:2] {
  set lmargin at screen 0.01 + 0.33 * k
  set rmargin at screen 0.32 + 0.33 * k
  set bmargin at screen 0.03
  set tmargin at screen 0.88
  set autoscale
  stats csv index 6 every ::k::k using 2 name "S" nooutput
  stats csv index 6 every ::k::k using 3 name "R" nooutput
  set xrange [-0.4:2.7]
  set yrange [-0.8:1.15]
  set label 1 says[k+1] at 1.05,-0.66 center textcolor rgb colour[k+1]
  set title sprintf("%d sticks, rank %d", S_max, R_max) textcolor rgb colour[k+1]
  plot csv index 3+k using 1:2:($3-$1):($4-$2) with vectors nohead lw 1.4 dt 2 lc rgb grey, \
       csv index k using 1:2:($3-$1):($4-$2) with vectors nohead lw 2.4 lc rgb colour[k+1], \
       csv index k using 1:2 with points pt 7 ps 1.43 lc rgb ink, \
       csv index k using 3:4 with points pt 7 ps 1.43 lc rgb ink
}
unset multiplot
