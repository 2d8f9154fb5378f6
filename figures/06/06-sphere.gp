# 06-sphere.gp - gnuplot -e "csv='...'; png='...'" figures/06/06-sphere.gp
set encoding utf8
set terminal pngcairo size 1500,1130 font "DejaVu Sans,21" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
unset key
unset border
unset tics
set size ratio -1
set multiplot
set style fill transparent solid 0.10 border

array says[3] = ["1: one point, and the farthest", "2: a diameter", "3: all inside"]
do for [k=1:3] {
  set lmargin at screen 0.01 + 0.33 * (k - 1)
  set rmargin at screen 0.32 + 0.33 * (k - 1)
  set bmargin at screen 0.51
  set tmargin at screen 0.92
  set xrange [-0.12:1.62]
  set yrange [-0.22:1.48]
  set title says[k] textcolor rgb "#404040" font "DejaVu Sans,22"
  plot csv index k every ::0::0 using 1:2:3 with circles lw 1.6 fc rgb "#56b4e9", \
       csv index 0 using 1:2 with points pt 7 ps 1.7 lc rgb "#808080", \
       csv index k every ::1 using ($3==0 ? $1 : NaN):2 with points pt 7 ps 2.6 lc rgb "#0072b2", \
       csv index k every ::1 using ($3<0 ? $1 : NaN):2 with points pt 7 ps 2.6 lc rgb "#d55e00", \
       csv index k every ::0::0 using 1:2 with points pt 1 ps 1.8 lw 1.6 lc rgb "#0072b2"
}

array name[2] = ["layered: around the spheres below", "wrapped: around the vertices below"]
array colour[2] = ["#d55e00", "#0072b2"]
do for [k=1:2] {
  set lmargin at screen 0.01 + 0.5 * (k - 1)
  set rmargin at screen 0.49 + 0.5 * (k - 1)
  set bmargin at screen 0.01
  set tmargin at screen 0.45
  set xrange [-0.35:3.95]
  set yrange [-1.75:2.45]
  set title name[k] textcolor rgb colour[k] font "DejaVu Sans,22" offset 0,-0.5
  plot csv index 4+k using ($1==0 ? $2 : NaN):3:4 with circles lw 2.2 fs transparent solid 0.05 border fc rgb colour[k], \
       csv index 4+k using ($1==1 ? $2 : NaN):3:4 with circles lw 1.5 fs transparent solid 0.06 border fc rgb colour[k], \
       csv index 4+k using ($1==2 ? $2 : NaN):3:4 with circles lw 0.9 fs empty border fc rgb "#808080", \
       csv index 4 using 1:2 with linespoints lw 2.6 pt 7 ps 1.8 lc rgb "#404040"
}
unset multiplot
