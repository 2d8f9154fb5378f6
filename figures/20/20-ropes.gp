# 20-ropes.gp - sh figures/draw/chart.sh figures/20/20-ropes.gp DATA.csv CHART.svg
high = 740
load "figures/draw/chart.gp"
set multiplot
ours = blue
theirs = orange

unset border
unset tics
set size ratio -1
set lmargin at screen 0.01
set rmargin at screen 0.99
set tmargin at screen 0.95
set bmargin at screen 0.465
set xrange [-1.15:1.15]
set yrange [-1.09:0.08]
shade(t) = number(orange) + 0x1000000 * int(255 * (0.75 - 0.75 * t / 0.93))
set label 10 "7.  A chain of 20 links, let go from the horizontal, every 60th of a second" at screen 0.5,0.977 center font bold textcolor rgb ink
set label 11 "path of\nits end" at -0.68,-0.74 right textcolor rgb ours font bold
set label 12 "0.93 s" at -1.0,-0.1 right textcolor rgb orange
set label 13 "0 s" at 1.01,0.03 textcolor rgb grey
plot csv index 0 using 1:2:(shade($3)) with lines lc rgb variable lw 1.1, \
     csv index 1 using 1:2 with lines lc rgb ours lw 1.6, \
     csv index 2 using 1:2 with points pt 7 ps 0.85 lc rgb ours, \
     csv index 2 using 1:2:(sprintf("fastest: %.1f m/s", $3)) with labels offset 0,-1.1 textcolor rgb ours, \
     "<echo 0 0" using 1:2 with points pt 7 ps 0.85 lc rgb ink
unset label

set size noratio
eval axes
set tmargin at screen 0.41
set bmargin at screen 0.07
set lmargin at screen 0.095
set rmargin at screen 0.53
set logscale xy 10
set xrange [1:1e6]
set yrange [1e-12:1e4]
set xtics nomirror ("1" 1, "100" 100, "10^4" 1e4, "10^6" 1e6)
set ytics nomirror ("10^3" 1e3, "1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12)
set xlabel "load, in particles of the rope" textcolor rgb ink offset 0,0.3
set title "8.  A loaded rope: its largest strain"
set label 1 "10 iterations" at 6,25 textcolor rgb theirs
set label 2 "10 small steps" at 25,2e-2 textcolor rgb green
set label 3 "the line solved, 3 Newton steps" at 1.6,2e-11 textcolor rgb ours font bold
set label 4 "target" at 1.6,4e-8 textcolor rgb grey
plot 1e-8 with lines dt 2 lc rgb grey lw 1, \
     csv index 3 using 1:2 with linespoints pt 7 ps 0.59 lc rgb theirs lw 1.5, \
     csv index 4 using 1:2 with linespoints pt 7 ps 0.59 lc rgb green lw 1.5, \
     csv index 5 using 1:2 with linespoints pt 7 ps 0.72 lc rgb ours lw 2
unset label
unset logscale

unset border
unset tics
unset grid
unset xlabel
set size ratio -1
set lmargin at screen 0.60
set rmargin at screen 0.98
set xrange [-0.06:1.06]
set yrange [-0.86:0.04]
unset title
set label 5 "9.  A chain finds its rest" at screen 0.79,0.4405 center font bold textcolor rgb ink
set label 1 "solved: off by\n1.4·10^{−14} m" at 0.5,-0.44 center textcolor rgb ours font bold
set label 2 "grey: exact" at 0.5,-0.18 center textcolor rgb grey
set label 3 "10 iterations:\n7 mm too low" at 0.5,-0.27 center textcolor rgb theirs
plot csv index 6 using 1:2 with lines lc rgb pale(grey, 0.4) lw 7, \
     csv index 8 using 1:2 with lines lc rgb theirs lw 1.2, \
     csv index 7 using 1:2 with points pt 7 ps 0.49 lc rgb ours
unset multiplot
