# 07-response.gp - sh figures/draw/chart.sh figures/07/07-response.gp DATA.csv CHART.svg
high = 608
load "figures/draw/chart.gp"
set grid ytics lc rgb rule lw 0.5
set multiplot
amber = purple

eval box(80, 540, 358, 574)
set title "How much of an overlap is left, after how much work"
set xlabel "iterations over the sticks" textcolor rgb ink
set logscale y 10
set logscale x 2
set xrange [0.9:70]
set yrange [3e-5:1.6]
set xtics (1, 2, 4, 8, 16, 32, 64)
set ytics ("100 %%" 1, "10 %%" 0.1, "1 %%" 1e-2, "0.1 %%" 1e-3, "0.01 %%" 1e-4)
set label 1 "pushed once,\nbefore the first\n(the paper)" at 78,1.3 textcolor rgb orange
set label 2 "pushed before each:\nthe least move" at 78,6.5e-4 textcolor rgb blue font bold
set label 3 "Eq. 10, mended" at 78,7e-5 textcolor rgb amber
plot csv index 0 using 1:3 with linespoints pt 7 ps 0.59 lc rgb orange lw 2, \
     csv index 1 using 1:3 with linespoints pt 7 ps 0.59 lc rgb amber lw 1.5, \
     csv index 2 using 1:3 with linespoints pt 7 ps 0.59 lc rgb blue lw 2.5
unset label

eval box(80, 540, 50, 266)
set title "Momentum that one push makes from nothing, in units of m_A d"
set xlabel "mass of B / mass of A" textcolor rgb ink
set logscale x 10
set xrange [0.9:11000]
set yrange [1e-17:1e5]
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000, "10,000" 10000)
set ytics ("1000" 1e3, "1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15)
set label 1 "Eq. 10\nas printed" at 13000,2e3 textcolor rgb orange
set label 2 "Eq. 10, mended" at 13000,1e-1 textcolor rgb amber
set label 3 "the least move:\nrounding" at 13000,2e-12 textcolor rgb blue font bold
plot csv index 3 using 1:2 with linespoints pt 7 ps 0.59 lc rgb orange lw 2, \
     csv index 3 using 1:3 with linespoints pt 7 ps 0.59 lc rgb amber lw 2, \
     csv index 3 using 1:4 with linespoints pt 7 ps 0.59 lc rgb blue lw 2.5
unset multiplot
