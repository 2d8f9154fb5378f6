# 17-measure.gp - sh figures/draw/chart.sh figures/17/17-measure.gp DATA.csv CHART.svg
high = 280
load "figures/draw/chart.gp"

set multiplot
set bmargin 3.6
set tmargin 2.6

set logscale xy 10
set yrange [5e-6:2e5]
set ytics ("10 nm" 1e-5, "1 µm" 1e-3, "0.1 mm" 0.1, "1 cm" 10, "1 m" 1e3, "lost" 1e5)
set xrange [0.2:60]
set xtics ("0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30)
set xlabel "ms a frame" textcolor rgb ink

set origin 0,0
set size 0.36,1
set lmargin 9
set rmargin 1.5
set title "Hanging, 50 boxes and 100 kg"
set label 1 "joint by joint" at 1.2,300 textcolor rgb orange
set label 2 "as a tree" at 0.3,3e-4 textcolor rgb blue font bold
plot csv index 1 using 3:2 with linespoints pt 6 ps 0.91 lc rgb orange lw 1.6, \
     csv index 1 using 3:2:1 with labels offset 1.4,0.7 textcolor rgb orange font small, \
     csv index 0 using 3:2 with linespoints pt 7 ps 0.91 lc rgb blue lw 2, \
     csv index 0 using 3:2:1 with labels offset 1.4,0.7 textcolor rgb blue font small
unset label

set origin 0.36,0
set size 0.33,1
set lmargin 6
set title "Thrown from the horizontal"
set format y ""
set label 1 "joint by joint" at 0.3,6000 textcolor rgb orange
set label 2 "as a tree" at 0.3,3e-4 textcolor rgb blue font bold
plot csv index 3 using 3:2 with linespoints pt 6 ps 0.91 lc rgb orange lw 1.6, \
     csv index 3 using 3:2:1 with labels offset 1.4,0.7 textcolor rgb orange font small, \
     csv index 2 using 3:2 with linespoints pt 7 ps 0.91 lc rgb blue lw 2, \
     csv index 2 using 3:2:1 with labels offset 1.4,0.7 textcolor rgb blue font small
unset label

set origin 0.69,0
set size 0.31,1
set lmargin 8
set title "Box on a hinge: period"
set xrange [3.3:78]
set xtics (4, 8, 16, 32, 64)
set xlabel "substeps"
set format y "%g"
set yrange [1e-8:1e-3]
set ytics ("10^{-8}" 1e-8, "10^{-7}" 1e-7, "10^{-6}" 1e-6, "10^{-5}" 1e-5, "10^{-4}" 1e-4, "10^{-3}" 1e-3)
set label 1 "1 rad" at 20,6e-6 textcolor rgb purple
set label 2 "0.3 rad" at 6,3e-7 textcolor rgb blue
plot csv index 5 using 1:3 with linespoints pt 7 ps 0.91 lc rgb purple lw 2, \
     csv index 5 using 1:2 with linespoints pt 7 ps 0.91 lc rgb blue lw 2
unset multiplot
