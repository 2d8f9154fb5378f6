# 21-verlet.gp - sh figures/draw/chart.sh figures/21/21-verlet.gp DATA.csv CHART.svg
high = 400
load "figures/draw/chart.gp"
explicit = orange; symplectic = purple; verlet = blue; kutta = green
set logscale xy 10
set xrange [2e1:1e8]
set xtics ("0.1 µs" 1e2, "" 1e3, "10 µs" 1e4, "" 1e5, "1 ms" 1e6)
set xlabel "time of a period and a quarter" textcolor rgb ink
set yrange [1e-13:30]
set format y "10^{%T}"
set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8, "10^{−10}" 1e-10, "10^{−12}" 1e-12)
set multiplot

do for [k = 0:1] {
  eval box(58 + 372 * k, 344 + 362 * k, 52, 364)
  set title (k ? "A pendulum, from 90 degrees: error" : "A mass on a spring: error") offset 0,-0.3
  set label 1 "explicit Euler" at (k ? 5e5 : 9e4),(k ? 4e-3 : 1.5e-3) textcolor rgb explicit
  set label 2 (k ? "symplectic" : "symplectic Euler") at (k ? 1e6 : 1.8e5),(k ? 8e-5 : 6e-5) textcolor rgb symplectic
  set label 3 "Verlet" at (k ? 2e6 : 1.2e6),8e-9 textcolor rgb verlet font bold
  set label 4 "Runge–Kutta,\nfour pulls a step" at (k ? 1.5e3 : 1.2e3),1e-11 center textcolor rgb kutta
  plot csv index (4*k) using 2:3 with linespoints pt 7 ps 0.59 lc rgb explicit lw 1.5, \
       csv index (4*k+1) using 2:3 with linespoints pt 7 ps 0.59 lc rgb symplectic lw 1.5, \
       csv index (4*k+3) using 2:3 with linespoints pt 6 ps 0.72 lc rgb kutta lw 1.5, \
       csv index (4*k+2) using 2:3 with linespoints pt 7 ps 0.72 lc rgb verlet lw 2
}
unset multiplot
