# 20-blows.gp - sh figures/draw/chart.sh figures/20/20-blows.gp DATA.csv CHART.svg
high = 680
load "figures/draw/chart.gp"
set style fill solid 1 noborder
set multiplot
ours = blue
theirs = orange

array colour[5] = [number(orange), number(red), number(green), number(purple), number(blue)]
half = 0.5
set tmargin at screen 0.935
set bmargin at screen 0.60
set lmargin at screen 0.075
set rmargin at screen 0.965
set xrange [0:0.7]
set yrange [-3.0:4.0]
set xtics ("0" 0, "0.1" 0.1, "0.2" 0.2, "0.3" 0.3, "0.4" 0.4, "0.5" 0.5, "0.6" 0.6, "0.7 s" 0.7)
set ytics ("−2 m" -2, "0" 0, "2 m" 2)
set title "14.  Newton's cradle: one cube comes in, one flies off, three stay"
set label 1 "in: 2 m/s" at 0.1,-2.13 center rotate by 4 front textcolor rgb page
set label 2 "out: 2.00000000000 m/s" at 0.47,2.66 center rotate by 4 front textcolor rgb page
plot for [i=1:5] csv index 0 using 1:(column(i+1)-half):(column(i+1)+half) with filledcurves lc rgb colour[i], \
     for [i=1:5] csv index 0 using 1:(column(i+1)-half) with lines lc rgb page lw 1.5, \
     for [i=1:5] csv index 0 using 1:(column(i+1)+half) with lines lc rgb page lw 1.5
unset label

set tmargin at screen 0.475
set bmargin at screen 0.07
set lmargin at screen 0.075
set rmargin at screen 0.53
set xrange [0:1.8]
set yrange [-0.03:1.08]
set xtics ("0" 0, "0.5" 0.5, "1" 1, "1.5 s" 1.5)
set ytics ("0" 0, "0.25" 0.25, "0.5" 0.5, "1 m" 1)
set title "15.  A bounce: its height at any step"
set label 1 "e = 1" at 0.9,1.04 center textcolor rgb ours font bold
set label 2 "e = 0.5" at 0.705,0.3 center textcolor rgb green font bold
set label 3 "e = 0" at 1.6,0.05 center textcolor rgb theirs font bold
set label 4 "grey: exact\nrings: 1/20 s\ndots: 1/240 s" at 0.9,0.62 center textcolor rgb quiet font small
plot csv index 1 using 1:2 with lines lc rgb pale(grey, 0.4) lw 5, \
     csv index 4 using 1:2 with lines lc rgb pale(grey, 0.4) lw 5, \
     csv index 7 using 1:2 with lines lc rgb pale(grey, 0.4) lw 5, \
     csv index 3 using 1:2 every 4 with points pt 7 ps 0.36 lc rgb theirs, \
     csv index 6 using 1:2 every 4 with points pt 7 ps 0.36 lc rgb green, \
     csv index 9 using 1:2 every 4 with points pt 7 ps 0.36 lc rgb ours, \
     csv index 2 using 1:2 with points pt 6 ps 1.23 lw 1.2 lc rgb theirs, \
     csv index 5 using 1:2 with points pt 6 ps 1.23 lw 1.2 lc rgb green, \
     csv index 8 using 1:2 with points pt 6 ps 1.23 lw 1.2 lc rgb ours
unset label

set lmargin at screen 0.615
set rmargin at screen 0.965
set xrange [0:10]
set yrange [-0.3:10]
set xtics ("0" 0, "5" 5, "10 s" 10)
set ytics ("0" 0, "5 m" 5, "10 m" 10)
set title "16.  A slope of 25 degrees"
set label 1 "friction for 24:\nit slides" at 6.4,6.3 right textcolor rgb theirs font bold
set label 2 "friction for 26: it stays" at 6.75,0.55 center textcolor rgb ours font bold
set label 3 "grey: exact" at 6.4,4.6 right textcolor rgb grey font small
plot csv index 10 using 1:3 with lines lc rgb pale(grey, 0.4) lw 5, \
     csv index 11 using 1:3 with lines lc rgb pale(grey, 0.4) lw 5, \
     csv index 10 using 1:2 with points pt 7 ps 0.59 lc rgb theirs, \
     csv index 11 using 1:2 with points pt 7 ps 0.59 lc rgb ours
unset multiplot
