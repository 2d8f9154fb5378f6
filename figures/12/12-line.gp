# 12-line.gp - sh figures/draw/chart.sh figures/12/12-line.gp DATA.csv CHART.svg
high = 770
load "figures/draw/chart.gp"
set multiplot

set logscale xy 10
set xrange [0.06:200]
set yrange [1e-16:1e4]
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100)
set tmargin at screen 0.915
set bmargin at screen 0.55
set label 10 "A hanging rope of 50 links: its largest strain" at screen 0.5,0.978 center font bold textcolor rgb ink
set label 11 "time a frame (10 iterations with the exact root = 1)" at screen 0.55,0.497 center textcolor rgb ink

set lmargin at screen 0.115
set rmargin at screen 0.385
set title "load 1"
set ytics ("10^{3}" 1e3, "1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15)
set label 1 "n iterations" at 3,8 textcolor rgb orange
set label 2 "n small\nsteps" at 0.9,3e-6 textcolor rgb blue
set label 3 "the line\nsolved: 1,\n2, 3, 4 steps" at 1.6,1e-10 textcolor rgb green font bold
plot csv index 0 using 2:3 with linespoints pt 7 ps 0.45 lc rgb orange lw 1.5, \
     csv index 1 using 2:3 with linespoints pt 7 ps 0.45 lc rgb blue lw 1.5, \
     csv index 2 using 2:3 with linespoints pt 7 ps 0.72 lc rgb green lw 2
unset label
unset ylabel
set format y ""
set ytics ("" 1e3, "" 1, "" 1e-3, "" 1e-6, "" 1e-9, "" 1e-12, "" 1e-15)

set lmargin at screen 0.415
set rmargin at screen 0.685
set title "load 100"
plot csv index 3 using 2:3 with linespoints pt 7 ps 0.45 lc rgb orange lw 1.5, \
     csv index 4 using 2:3 with linespoints pt 7 ps 0.45 lc rgb blue lw 1.5, \
     csv index 5 using 2:3 with linespoints pt 7 ps 0.72 lc rgb green lw 2

set lmargin at screen 0.715
set rmargin at screen 0.985
set title "load 10,000"
plot csv index 6 using 2:3 with linespoints pt 7 ps 0.45 lc rgb orange lw 1.5, \
     csv index 7 using 2:3 with linespoints pt 7 ps 0.45 lc rgb blue lw 1.5, \
     csv index 8 using 2:3 with linespoints pt 7 ps 0.72 lc rgb green lw 2
unset label

set tmargin at screen 0.425
set bmargin at screen 0.075
set lmargin at screen 0.115
set rmargin at screen 0.985
set title "A taut rope, touched: how many times a zigzag has grown after 200 steps"
set xlabel "T h² / (m L): pull times step squared" textcolor rgb ink
set xrange [0.019:1.5]
set yrange [1e-4:1e13]
set xtics ("0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "1/3" 1.0/3, "1" 1)
set ytics ("10^{12}" 1e12, "10^{9}" 1e9, "10^{6}" 1e6, "10^{3}" 1e3, "1" 1, "10^{−3}" 1e-3)
set label 1 "along the new links" at 0.3,2e6 right textcolor rgb blue font bold
set label 2 "along the old links" at 0.9,3e9 right textcolor rgb purple font bold
plot csv index 9 using 1:2 with lines lc rgb blue lw 2.5, \
     csv index 10 using 1:2 with lines lc rgb purple lw 2.5
unset multiplot
