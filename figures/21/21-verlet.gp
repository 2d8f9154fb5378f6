# 21-verlet.gp - sh figures/draw/chart.sh figures/21/21-verlet.gp DATA.csv CHART.svg
high = 360
load "figures/draw/chart.gp"
explicit = orange; symplectic = purple; verlet = blue; kutta = green
set logscale xy 10
set xrange [2e1:4e6]
set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6)
set xlabel "time of a period and a quarter" textcolor rgb ink
set yrange [1e-13:30]
set format y "10^{%T}"
set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8, "10^{−10}" 1e-10, "10^{−12}" 1e-12)
set multiplot
set lmargin 9
set rmargin 2
set size 0.5,1

do for [k = 0:1] {
  set origin 0.5 * k,0
  set title (k ? "A pendulum, from 90 degrees" : "A mass on a spring, error") offset 0,-0.3
  set label 1 "explicit Euler" at 6e5,(k ? 6e-2 : 2e-2) center textcolor rgb explicit
  set label 2 "symplectic Euler" at (k ? 8e5 : 5e5),(k ? 2e-5 : 1.5e-5) center textcolor rgb symplectic
  set label 3 "Verlet" at (k ? 2e5 : 6e4),2e-8 center textcolor rgb verlet font bold
  set label 4 "Runge–Kutta,\nfour pulls a step" at (k ? 8e3 : 1.5e3),1e-11 center textcolor rgb kutta
  plot csv index (4*k) using 2:3 with linespoints pt 7 ps 0.59 lc rgb explicit lw 1.5, \
       csv index (4*k+1) using 2:3 with linespoints pt 7 ps 0.59 lc rgb symplectic lw 1.5, \
       csv index (4*k+3) using 2:3 with linespoints pt 6 ps 0.72 lc rgb kutta lw 1.5, \
       csv index (4*k+2) using 2:3 with linespoints pt 7 ps 0.72 lc rgb verlet lw 2
}
unset multiplot
