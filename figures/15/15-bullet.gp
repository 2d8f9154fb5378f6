# 15-bullet.gp - sh figures/draw/chart.sh figures/15/15-bullet.gp DATA.csv CHART.svg
high = 660
load "figures/draw/chart.gp"
set logscale x 10
set xrange [0.9:1100]
set xtics ("1" 1, "3" 3.162, "10" 10, "30" 31.62, "100" 100, "300" 316.2, "1000" 1000)
set multiplot

eval box(70, 560, 386, 626)
set title "A ball of 5 cm, a plate of 1 cm, 60 frames a second: share of wrong shots"
set xlabel "speed, m/s" textcolor rgb ink
set yrange [-0.03:1.05]
set ytics ("0" 0, "25 %%" 0.25, "50 %%" 0.5, "75 %%" 0.75, "100 %%" 1)
set label 1 "look at\nthe end:\nthrough" at 7.2,0.66 right textcolor rgb orange font bold
set label 2 "of these\nnever seen" at 46,0.75 textcolor rgb orange
set label 3 "look ahead:\nstopped beside\nthe plate" at 1200,0.98 textcolor rgb purple font bold
set label 4 "substeps, swept:\nneither" at 1200,0.05 textcolor rgb blue font bold
plot csv index 0 using 1:2 with linespoints pt 7 ps 0.52 lc rgb orange lw 2, \
     csv index 0 using 1:3 with lines lc rgb orange lw 1 dt 2, \
     csv index 1 using 1:4 with linespoints pt 7 ps 0.52 lc rgb purple lw 2, \
     csv index 0 using 1:4 with linespoints pt 7 ps 0.52 lc rgb green lw 2, \
     csv index 0 using 1:6 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
unset label

eval box(70, 560, 52, 302)
set title "Time of the queries, in the frame in which the ball meets the plate"
set logscale y 10
set yrange [150:200000]
set ytics ("0.3 µs" 300, "1 µs" 1e3, "3 µs" 3e3, "10 µs" 1e4, "30 µs" 3e4, "100 µs" 1e5)
set label 1 "substeps of\nits own radius" at 1200,8e4 textcolor rgb green font bold
set label 2 "swept" at 1200,1500 textcolor rgb blue font bold
set label 3 "look ahead" at 1200,320 textcolor rgb purple
set label 4 "look at the end" at 1200,190 textcolor rgb orange
plot csv index 2 using 1:2 with linespoints pt 7 ps 0.52 lc rgb orange lw 2, \
     csv index 2 using 1:4 with linespoints pt 7 ps 0.52 lc rgb purple lw 2, \
     csv index 2 using 1:3 with linespoints pt 7 ps 0.52 lc rgb green lw 2, \
     csv index 2 using 1:5 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
