# 21-body.gp - gnuplot -e "csv='...'; png='...'" figures/21/21-body.gp
set encoding utf8
set terminal pngcairo size 1800,850 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
unset key
plain = "#d55e00"; cut = "#009e73"; four = "#0072b2"; grey = "#606060"
bold = "DejaVu Sans Bold,22"
set logscale xy 10
set xrange [40:1e6]
set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5)
set xlabel "time to relax after a blow" textcolor rgb "#404040"
set yrange [2e-9:6]
set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8)
set multiplot
set lmargin 9
set rmargin 2
set size 0.5,1
do for [k = 0:1] {
  set origin 0.5 * k,0
  set title (k ? "A ball of 42 corners" : "A brick, struck at a corner: error of its speed") font "DejaVu Sans,26" offset 0,-0.3
  set label 1 (k ? "a particle at every corner:\ninertia 82 % too large" : "a particle at every corner:\ninertia 200 % too large") at (k ? 1.2e4 : 1e4),2.5e-2 center textcolor rgb grey
  set label 2 "four particles, solved:\ninertia as the solid’s" at 150,2e-7 left textcolor rgb four font bold
  set label 3 "edges and diagonals" at 1.2e4,3.4 left textcolor rgb plain
  set label 4 "tetrahedralised" at 1.2e4,1.3 left textcolor rgb cut
  plot csv index (3*k+1) using 2:3 with linespoints pt 7 ps 1 lc rgb plain lw 1.5, \
       csv index (3*k+2) using 2:3 with linespoints pt 6 ps 1 lc rgb cut lw 1.5, \
       csv index (3*k+3) using 2:3 every ::0::2 with linespoints pt 7 ps 1.3 lc rgb four lw 2
}
unset multiplot
