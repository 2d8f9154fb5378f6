# 03-count.gp - gnuplot -e "csv='...'; png='...'" figures/03/03-count.gp
set encoding utf8
set terminal pngcairo size 1500,470 font "DejaVu Sans,21" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
unset key
unset border
unset tics
set size ratio -1
set multiplot
array colour[3] = ["#d55e00", "#cc79a7", "#0072b2"]
array says[3] = ["both cells fold", "the right cell folds", "nothing folds"]
do for [k=0:2] {
  set lmargin at screen 0.01 + 0.33 * k
  set rmargin at screen 0.32 + 0.33 * k
  set bmargin at screen 0.06
  set tmargin at screen 0.80
  set autoscale
  stats csv index 6 every ::k::k using 2 name "S" nooutput
  stats csv index 6 every ::k::k using 3 name "R" nooutput
  set xrange [-0.4:2.7]
  set yrange [-0.8:1.15]
  set label 1 says[k+1] at 1.05,-0.66 center textcolor rgb colour[k+1]
  set title sprintf("%d sticks, rank %d", S_max, R_max) textcolor rgb colour[k+1] font "DejaVu Sans,24"
  plot csv index 3+k using 1:2:($3-$1):($4-$2) with vectors nohead lw 1.4 dt 2 lc rgb "#a0a0a0", \
       csv index k using 1:2:($3-$1):($4-$2) with vectors nohead lw 2.4 lc rgb colour[k+1], \
       csv index k using 1:2 with points pt 7 ps 2.2 lc rgb "#404040", \
       csv index k using 3:4 with points pt 7 ps 2.2 lc rgb "#404040"
}
unset multiplot
