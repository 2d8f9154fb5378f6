# 00b-spring.gp - sh figures/draw/chart.sh figures/00b/00b-spring.gp DATA.csv CHART.svg
high = 350
load "figures/draw/chart.gp"
set multiplot
eval box(20, 330, 30, 318)
set title "The spring is the shadow of a circle"
unset border
unset tics
set size ratio -1
set xrange [-1.35:1.35]
set yrange [-1.75:1.35]
w = 0.8
set object 1 circle at 0,0 size 1 fillstyle empty border lc rgb rule lw 1.5
set style arrow 1 head filled size 0.11,20 lw 2.5
set style arrow 2 nohead dt 3 lw 1 lc rgb grey
set arrow 1 from cos(w),sin(w) to cos(w)-0.62*sin(w),sin(w)+0.62*cos(w) as 1 lc rgb blue
set arrow 2 from cos(w),sin(w) to 0.42*cos(w),0.42*sin(w) as 1 lc rgb orange
set arrow 3 from cos(w),sin(w) to cos(w),-1.4 as 2
set arrow 4 from cos(w),-1.4 to 0.42*cos(w),-1.4 as 1 lc rgb orange
set arrow 5 from -1.2,-1.4 to 1.2,-1.4 nohead lw 1 lc rgb rule back
set arrow 6 from 0,0 to 0.9,0 nohead lw 1 lc rgb rule back
set arrow 7 from 0,0 to 0.42*cos(w),0.42*sin(w) nohead lw 1 lc rgb grey
set label 1 "v = ω r" at 0.17,1.2 right textcolor rgb blue
set label 2 "a = ω² r" at 0.36,0.52 right textcolor rgb orange
set label 3 "ω t" at 0.28,0.13 textcolor rgb quiet
set label 4 "x" at cos(w)-0.03,-1.6 textcolor rgb green
set label 5 "ω² x" at 0.46,-1.25 center textcolor rgb orange
set label 6 "0" at 0,-1.6 center textcolor rgb quiet
plot csv index 0 using 2:(-$3) with points pt 7 ps 0.4 lc rgb grey, \
     csv index 0 using 2:(-1.4) with points pt 7 ps 0.4 lc rgb grey, \
     "+" using (cos(w)):(sin(w)) every ::0::0 with points pt 7 ps 1.4 lc rgb ink, \
     "+" using (cos(w)):(-1.4) every ::0::0 with points pt 7 ps 1.4 lc rgb green
unset label
unset arrow
unset object
set size noratio
eval axes
eval box(420, 700, 50, 318)
set title "Twenty periods, in few steps"
set xlabel "steps a period"
set ylabel "largest swing" offset 0.5,0
set logscale xy
set xrange [2.7:70]
set yrange [0.7:1e5]
set xtics (3, 4, 6, 10, 20, 40)
set format y "%g"
set ytics (1, 10, 100, 1000, "10,000" 10000)
set arrow 1 from pi,0.7 to pi,1e5 nohead dt 3 lw 1 lc rgb red
set label 1 "ω Δt = 2" at pi*1.06,3.5e4 textcolor rgb red
plot csv index 1 using 1:2 with linespoints pt 7 ps 0.6 lc rgb blue lw 1.5
unset multiplot
