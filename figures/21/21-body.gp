# 21-body.gp - sh figures/draw/chart.sh figures/21/21-body.gp DATA.csv CHART.svg
high = 320
load "figures/draw/chart.gp"
plain = orange; cut = green; four = blue
set logscale xy 10
set xrange [60:1e6]
set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6)
set xlabel "time to relax after a blow"
set yrange [1e-9:90]
set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8)
set title "A brick and a ball of 42 corners, struck at a corner: error of its speed"
eval box(62, 700, 52, 284)
set label 1 "a particle at every corner, whose inertia is\n200 % too large for the brick, 82 % for the ball" at 2e3,3e-2 textcolor rgb quiet
set label 2 "four particles, solved:\ninertia as the solid’s" at 250,2e-8 textcolor rgb four font bold
set label 3 "edges and diagonals" at 1.3e2,12 textcolor rgb plain
set label 4 "tetrahedralised" at 1.3e2,90 textcolor rgb cut
set label 5 "dots: brick, rings: ball" at 9e5,3e-7 right textcolor rgb quiet
plot for [k = 0:1] csv index (3*k+1) using 2:3 with linespoints pt (k ? 6 : 7) ps 0.65 lc rgb plain lw 1.5, \
     for [k = 0:1] csv index (3*k+2) using 2:3 with linespoints pt (k ? 6 : 7) ps 0.65 lc rgb cut lw 1.5, \
     for [k = 0:1] csv index (3*k+3) using 2:3 every ::0::2 with linespoints pt (k ? 6 : 7) ps 0.85 lc rgb four lw 2
