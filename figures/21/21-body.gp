# 21-body.gp - sh figures/draw/chart.sh figures/21/21-body.gp DATA.csv CHART.svg
high = 340
load "figures/draw/chart.gp"
plain = orange; cut = green; four = blue
set logscale xy 10
set xrange [40:1e6]
set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5)
set xlabel "time to relax after a blow" textcolor rgb ink
set yrange [2e-9:6]
set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8)
set multiplot
set lmargin 9
set rmargin 2
set size 0.5,1
do for [k = 0:1] {
  set origin 0.5 * k,0
  set title (k ? "A ball of 42 corners" : "A brick, struck at a corner: error of its speed") offset 0,-0.3
  set label 1 (k ? "a particle at every corner:\ninertia 82 % too large" : "a particle at every corner:\ninertia 200 % too large") at (k ? 1.2e4 : 1e4),2.5e-2 center textcolor rgb quiet
  set label 2 "four particles, solved:\ninertia as the solid’s" at 150,2e-7 left textcolor rgb four font bold
  set label 3 "edges and diagonals" at 1.2e4,3.4 left textcolor rgb plain
  set label 4 "tetrahedralised" at 1.2e4,1.3 left textcolor rgb cut
  plot csv index (3*k+1) using 2:3 with linespoints pt 7 ps 0.65 lc rgb plain lw 1.5, \
       csv index (3*k+2) using 2:3 with linespoints pt 6 ps 0.65 lc rgb cut lw 1.5, \
       csv index (3*k+3) using 2:3 every ::0::2 with linespoints pt 7 ps 0.85 lc rgb four lw 2
}
unset multiplot
