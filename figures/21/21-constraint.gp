# 21-constraint.gp - sh figures/draw/chart.sh figures/21/21-constraint.gp DATA.csv CHART.svg
high = 420
load "figures/draw/chart.gp"
exact = orange; near = purple; old = green; direct = blue
set logscale xy 10
set xlabel "time of a frame" textcolor rgb ink
set multiplot

# A strain that is only rounding is drawn at the bottom.
none = 1e-13
shown(e) = e > none ? e : none

do for [k = 0:1] {
  eval box(56 + 374 * k, 344 + 364 * k, 52, 384)
  if (k == 0) {
    set title "A rope of 50 links swings: strain"
    set xrange [4e2:1.5e5]
    set xtics ("1 µs" 1e3, "10 µs" 1e4, "100 µs" 1e5)
    set yrange [1e-10:30]
    set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8)
    set label 4 "exact root" at 5e2,2e-6 textcolor rgb exact 
    set label 5 "approximate root" at 5e2,5.5e-7 textcolor rgb near 
    set label 6 "old gradient" at 5e2,1.5e-7 textcolor rgb old 
    set label 1 "iterations on one step" at 1.4e5,9 right textcolor rgb quiet
    set label 2 "small steps" at 1.4e5,6e-5 right textcolor rgb quiet
    set label 3 "the line, solved" at 5e2,5e-9 left textcolor rgb direct font bold
  } else {
    unset label
    set title "A free brick tumbles: strain"
    set xrange [60:3e4]
    set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4)
    set yrange [none/3:1]
    set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8, "10^{−10}" 1e-10, "10^{−12}" 1e-12)
    set label 1 "iterations on one step" at 2.6e4,5e-12 right textcolor rgb quiet
    set label 2 "small steps" at 2.6e4,3e-3 right textcolor rgb quiet
    set label 3 "four particles,\nsolved" at 70,1e-9 left textcolor rgb direct font bold
  }
  b = 7 * k
  plot csv index (b) using 2:(shown($3)) with linespoints pt 6 ps 0.65 lc rgb exact lw 1.5 dt 2, \
       csv index (b+1) using 2:(shown($3)) with linespoints pt 6 ps 0.65 lc rgb near lw 1.5 dt 2, \
       csv index (b+2) using 2:(shown($3)) with linespoints pt 6 ps 0.65 lc rgb old lw 1.5 dt 2, \
       csv index (b+3) using 2:(shown($3)) with linespoints pt 7 ps 0.65 lc rgb exact lw 1.5, \
       csv index (b+4) using 2:(shown($3)) with linespoints pt 7 ps 0.65 lc rgb near lw 1.5, \
       csv index (b+5) using 2:(shown($3)) with linespoints pt 7 ps 0.65 lc rgb old lw 1.5, \
       csv index (b+6) using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb direct lw 2.2
}
unset multiplot
