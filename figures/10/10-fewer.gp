# 10-fewer.gp - sh figures/draw/chart.sh figures/10/10-fewer.gp DATA.csv CHART.svg
high = 340
load "figures/draw/chart.gp"
cold = orange; warm = blue
array title[2] = ["Icosahedra 1 cm apart: error", "1 cm deep in each other: error"]
# What is only rounding is drawn at the bottom.
none = 1e-8
shown(e) = e > none ? e : none
set logscale xy 10
set xrange [2e2:3e4]
set yrange [4e-9:6e-5]
set xtics ("0.3 µs" 3e2, "1 µs" 1e3, "3 µs" 3e3, "10 µs" 1e4)
set ytics ("0.01 mm" 1e-5, "1 µm" 1e-6, "0.1 µm" 1e-7, "rounding" none)
set xlabel "time of all queries of a frame" textcolor rgb ink
set multiplot
do for [k = 0:1] {
  eval box(75 + 370 * k, 345 + 370 * k, 50, high - 36)
  set title title[k+1] offset 0,-0.3
  if (k == 0) {
    set label 2 "cold" at 8e3,1.5e-6 center textcolor rgb cold font bold
    set label 3 "carried" at 4.5e2,5e-7 center textcolor rgb warm font bold
  }
  plot csv index k using 2:(shown($3)) with linespoints pt 7 ps 1.04 lc rgb cold lw 1.5, \
       csv index k using 4:(shown($5)) with linespoints pt 7 ps 1.04 lc rgb warm lw 2, \
       csv index k using 2:(shown($3)):1 with labels font small textcolor rgb cold offset 1.6,0.6, \
       csv index k using 4:(shown($5)):1 with labels font small textcolor rgb warm offset -1.4,-0.6
  unset label
}
unset multiplot
