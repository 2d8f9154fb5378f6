# 06-sphere.gp - sh figures/draw/chart.sh figures/06/06-sphere.gp DATA.csv CHART.svg
high = 540
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
set multiplot
set style fill transparent solid 0.10 border

array says[3] = ["1: a point, the farthest", "2: a diameter", "3: all inside"]
do for [k=1:3] {
  set lmargin at screen 0.01 + 0.33 * (k - 1)
  set rmargin at screen 0.32 + 0.33 * (k - 1)
  set bmargin at screen 0.51
  set tmargin at screen 0.92
  set xrange [-0.12:1.62]
  set yrange [-0.22:1.48]
  set title says[k] textcolor rgb ink
  plot csv index k every ::0::0 using 1:2:3 with circles lw 1.6 fc rgb blue, \
       csv index 0 using 1:2 with points pt 7 ps 1.1 lc rgb grey, \
       csv index k every ::1 using ($3==0 ? $1 : NaN):2 with points pt 7 ps 1.69 lc rgb blue, \
       csv index k every ::1 using ($3<0 ? $1 : NaN):2 with points pt 7 ps 1.69 lc rgb orange, \
       csv index k every ::0::0 using 1:2 with points pt 1 ps 1.17 lw 1.6 lc rgb blue
}

array name[2] = ["layered: around the spheres below", "wrapped: around the vertices below"]
array colour[2] = [orange, blue]
do for [k=1:2] {
  set lmargin at screen 0.10 + 0.5 * (k - 1)
  set rmargin at screen 0.49 + 0.5 * (k - 1)
  set bmargin at screen 0.01
  set tmargin at screen 0.45
  set xrange [-0.35:3.95]
  set yrange [-1.75:2.45]
  set title name[k] textcolor rgb colour[k] offset 0,-0.5
  plot csv index 4+k using ($1==0 ? $2 : NaN):3:4 with circles lw 2.2 fs transparent solid 0.05 border fc rgb colour[k], \
       csv index 4+k using ($1==1 ? $2 : NaN):3:4 with circles lw 1.5 fs transparent solid 0.06 border fc rgb colour[k], \
       csv index 4+k using ($1==2 ? $2 : NaN):3:4 with circles lw 0.9 fs empty border fc rgb grey, \
       csv index 4 using 1:2 with linespoints lw 2.6 pt 7 ps 1.17 lc rgb ink
}
unset multiplot
