# 18-cache.gp - sh figures/draw/chart.sh figures/18/18-cache.gp DATA.csv CHART.svg
high = 290
load "figures/draw/chart.gp"
set grid ytics lc rgb rule lw 0.5
set xlabel "s" textcolor rgb ink

set multiplot layout 1,2
set logscale y 10
set format y "10^{%L}"
set yrange [0.5:30000]
set title "questions in a frame"
set label 1 "forgotten in every frame" at 9.9,9000 right textcolor rgb orange
set label 2 "kept" at 4.6,600 textcolor rgb blue
plot csv index 0 using 1:($4>0.5?$4:0.5) with lines lc rgb orange lw 1.5, \
     csv index 0 using 1:($2>0.5?$2:0.5) with lines lc rgb blue lw 1.5
unset label
set key at graph 1,1 right top samplen 1 spacing 1.3 textcolor variable
set yrange [1e-12:1e5]
set title "joules of motion"
plot csv index 0 using 1:($7>1e-12?$7:1e-12) with lines lc rgb orange lw 1.5 title "forgotten in every frame", \
     csv index 0 using 1:($6>1e-12?$6:1e-12) with lines lc rgb grey lw 1.5 title "asked in every frame", \
     csv index 0 using 1:($5>1e-12?$5:1e-12) with lines lc rgb blue lw 1.5 title "kept"
