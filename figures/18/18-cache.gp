# 18-cache.gp - sh figures/draw/chart.sh figures/18/18-cache.gp DATA.csv CHART.svg
high = 330
load "figures/draw/chart.gp"
set grid ytics lc rgb rule lw 0.5
set xlabel "time, s" textcolor rgb ink

set multiplot
eval box(56, 345, 52, 294)
set logscale y 10
set format y "10^{%L}"
set yrange [0.5:30000]
set xtics 0,2,10
set title "Questions in a frame"
set label 1 "forgotten in every frame" at 9.9,9000 right textcolor rgb orange
set label 2 "kept" at 4.2,300 textcolor rgb blue
plot csv index 0 using 1:($4>0.5?$4:0.5) with lines lc rgb orange lw 1.5, \
     csv index 0 using 1:($2>0.5?$2:0.5) with lines lc rgb blue lw 1.5
unset label
set yrange [1e-12:1e5]
eval box(430, 706, 52, 294)
set title "Energy of motion, J"
set label 1 "forgotten" at 9.9,10 right textcolor rgb orange
set label 2 "always asked" at 3.9,5e-7 textcolor rgb quiet
set label 3 "kept" at 6.4,1e-10 textcolor rgb blue
plot csv index 0 using 1:($7>1e-12?$7:1e-12) with lines lc rgb orange lw 1.5, \
     csv index 0 using 1:($6>1e-12?$6:1e-12) with lines lc rgb grey lw 1.5, \
     csv index 0 using 1:($5>1e-12?$5:1e-12) with lines lc rgb blue lw 1.5
