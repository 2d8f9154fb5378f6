# 01-order.gp - sh figures/draw/chart.sh figures/01/01-order.gp DATA.csv CHART.svg
high = 670
load "figures/draw/chart.gp"
set logscale xy 10
set format y "10^{%L}"
set multiplot

eval box(65, 545, 315, 620)
set title "A planet after an orbit and a quarter: error of its position"
set xlabel "time to compute (Verlet, 1000 steps an orbit = 1)" textcolor rgb ink
set xrange [0.025:400]
set yrange [1e-9:10]
set xtics (0.1, 1, 10, 100)
set label 1 "explicit Euler" at 450,2.4e-3 textcolor rgb orange
set label 2 "symplectic Euler\nand, in circles,\nVerlet with a\ncareless start" at 450,5e-5 textcolor rgb purple
set label 3 "Verlet" at 450,4.7e-9 textcolor rgb blue font bold
set label 4 "slope −1" at 3.2,1.15e-2 textcolor rgb grey
set label 5 "slope −2" at 6,8e-5 textcolor rgb grey
plot csv index 0 using 2:3 with linespoints pt 7 ps 0.52 lc rgb orange lw 1.5, \
     csv index 1 using 2:3 with linespoints pt 7 ps 0.52 lc rgb purple lw 1.5, \
     csv index 3 using 2:3 with points pt 6 ps 1.04 lc rgb grey lw 1, \
     csv index 2 using 2:3 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
unset label

eval box(65, 545, 55, 225)
set title "Its energy, 200 steps an orbit: relative error"
set xlabel "orbits"
set xrange [0.05:100]
set yrange [1e-5:3]
set xtics (0.1, 1, 10, 100)
set label 1 "explicit Euler" at 110,0.9 textcolor rgb orange
set label 2 "symplectic Euler" at 110,1.5e-2 textcolor rgb purple
set label 3 "Verlet" at 110,4e-4 textcolor rgb blue font bold
plot csv index 4 using 1:2 with lines lc rgb orange lw 1.5, \
     csv index 5 using 1:2 with lines lc rgb purple lw 1.5, \
     csv index 6 using 1:2 with lines lc rgb blue lw 2
unset multiplot
