# 21-constraint.gp - gnuplot -e "csv='...'; png='...'" figures/21/21-constraint.gp
set encoding utf8
set terminal pngcairo size 1800,1000 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
unset key
exact = "#d55e00"; near = "#e69f00"; old = "#009e73"; direct = "#0072b2"; grey = "#606060"
bold = "DejaVu Sans Bold,22"
small = "DejaVu Sans,18"
set logscale xy 10
set xlabel "time of a frame" textcolor rgb "#404040"
set multiplot
set lmargin 9
set rmargin 2
set size 0.5,1

# A strain that is only rounding is drawn at the bottom.
none = 1e-13
shown(e) = e > none ? e : none

do for [k = 0:1] {
  set origin 0.5 * k,0
  if (k == 0) {
    set title "A rope of 50 links swings: strain" font "DejaVu Sans,26" offset 0,-0.3
    set xrange [4e2:1.5e5]
    set xtics ("1 µs" 1e3, "10 µs" 1e4, "100 µs" 1e5)
    set yrange [1e-10:30]
    set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8)
    set label 4 "exact root" at 6e2,2e-3 textcolor rgb exact font small
    set label 5 "approximate root" at 6e2,7e-4 textcolor rgb near font small
    set label 6 "old gradient" at 6e2,2.5e-4 textcolor rgb old font small
    set label 1 "sweeps of one step" at 1.4e5,2.6 right textcolor rgb grey
    set label 2 "small steps" at 1.4e5,8e-4 right textcolor rgb grey
    set label 3 "the line, solved" at 5.2e3,1e-7 right textcolor rgb direct font bold
  } else {
    unset label
    set title "A free brick tumbles: strain" font "DejaVu Sans,26" offset 0,-0.3
    set xrange [60:3e4]
    set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4)
    set yrange [none/3:1]
    set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8, "10^{−10}" 1e-10, "10^{−12}" 1e-12)
    set label 1 "sweeps of one step" at 6e3,3e-12 right textcolor rgb grey
    set label 2 "small steps" at 2.6e4,2e-4 right textcolor rgb grey
    set label 3 "four particles,\nsolved" at 70,1e-8 left textcolor rgb direct font bold
  }
  b = 7 * k
  plot csv index (b) using 2:(shown($3)) with linespoints pt 6 ps 1 lc rgb exact lw 1.5 dt 2, \
       csv index (b+1) using 2:(shown($3)) with linespoints pt 6 ps 1 lc rgb near lw 1.5 dt 2, \
       csv index (b+2) using 2:(shown($3)) with linespoints pt 6 ps 1 lc rgb old lw 1.5 dt 2, \
       csv index (b+3) using 2:(shown($3)) with linespoints pt 7 ps 1 lc rgb exact lw 1.5, \
       csv index (b+4) using 2:(shown($3)) with linespoints pt 7 ps 1 lc rgb near lw 1.5, \
       csv index (b+5) using 2:(shown($3)) with linespoints pt 7 ps 1 lc rgb old lw 1.5, \
       csv index (b+6) using 2:(shown($3)) with linespoints pt 7 ps 1.2 lc rgb direct lw 2.2
}
unset multiplot
