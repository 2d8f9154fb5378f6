# 17-measure.gp - sh figures/draw/chart.sh figures/17/17-measure.gp DATA.csv CHART.svg
high = 600
load "figures/draw/chart.gp"

set multiplot

set logscale xy 10
set yrange [5e-6:1.5e6]
set ytics ("10 nm" 1e-5, "1 µm" 1e-3, "0.1 mm" 0.1, "1 cm" 10, "1 m" 1e3, "lost" 1e5)
set xrange [0.2:60]
set xtics ("0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30)
set xlabel "time of a frame, ms" textcolor rgb ink

eval box(66, 350, 346, 566)
set title "Hanging, 50 boxes and 100 kg: gap"
set label 1 "joint by joint" at 2.2,300 textcolor rgb orange
set label 2 "as a tree" at 7,1.2e-3 textcolor rgb blue font bold
plot csv index 1 using 3:2 with linespoints pt 6 ps 0.91 lc rgb orange lw 1.6, \
     csv index 1 using 3:2:1 with labels offset 0.9,0.75 textcolor rgb orange font small, \
     csv index 0 using 3:2 with linespoints pt 7 ps 0.91 lc rgb blue lw 2, \
     csv index 0 using 3:2:1 with labels offset 0.9,0.75 textcolor rgb blue font small
unset label

eval box(420, 704, 346, 566)
set title "Thrown from the horizontal: gap"
set label 1 "joint by joint" at 4,6000 textcolor rgb orange
set label 2 "as a tree" at 7,1.2e-3 textcolor rgb blue font bold
plot csv index 3 using 3:2 with linespoints pt 6 ps 0.91 lc rgb orange lw 1.6, \
     csv index 3 using ($1 == 16 || $1 == 32 ? NaN : $3):2:1 with labels offset 0.9,0.75 textcolor rgb orange font small, \
     csv index 2 using 3:2 with linespoints pt 7 ps 0.91 lc rgb blue lw 2, \
     csv index 2 using 3:2:1 with labels offset 0.9,0.75 textcolor rgb blue font small
unset label

eval box(66, 580, 52, 262)
set title "A box on a hinge: error of its period"
set xrange [3.3:78]
set xtics (4, 8, 16, 32, 64)
set xlabel "substeps"
set format y "%g"
set yrange [1e-8:1e-3]
set ytics ("10^{-8}" 1e-8, "10^{-7}" 1e-7, "10^{-6}" 1e-6, "10^{-5}" 1e-5, "10^{-4}" 1e-4, "10^{-3}" 1e-3)
set label 1 "from 1 rad" at 20,4e-6 textcolor rgb purple
set label 2 "from 0.3 rad" at 6,1.2e-6 textcolor rgb blue
plot csv index 5 using 1:3 with linespoints pt 7 ps 0.91 lc rgb purple lw 2, \
     csv index 5 using 1:2 with linespoints pt 7 ps 0.91 lc rgb blue lw 2
unset multiplot
