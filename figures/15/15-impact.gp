# 15-impact.gp - sh figures/draw/chart.sh figures/15/15-impact.gp DATA.csv CHART.svg
high = 500
load "figures/draw/chart.gp"
set multiplot

# The drawing: a box in three places, seen from the side.
unset border; unset tics; unset grid
eval box(0, 720, 270, 500)
set xrange [0:720]
set yrange [0:230]
set style arrow 1 head filled size screen 0.011,22 lc rgb blue lw 2.2
set style arrow 2 head filled size screen 0.011,22 lc rgb orange lw 2.2
set style arrow 3 nohead lc rgb quiet lw 1.2 dt 2
# A box with half sides 62 and 30 whose lowest corner is at (x, y), leaning by a.
px(x, a, u, v) = x + u*cos(a) - v*sin(a)
py(y, a, u, v) = y + u*sin(a) + v*cos(a)
turned(n, x, y, a, c) = sprintf("set object %d polygon from %g,%g to %g,%g to %g,%g to %g,%g to %g,%g fc rgb '%s' fs transparent solid 0.15 border lc rgb '%s'", n, px(x,a,0,0),py(y,a,0,0), px(x,a,124,0),py(y,a,124,0), px(x,a,124,60),py(y,a,124,60), px(x,a,0,60),py(y,a,0,60), px(x,a,0,0),py(y,a,0,0), c, c)
dot(n, x, y, c) = sprintf("set object %d circle at %g,%g size 4 fc rgb '%s' fs solid 1 front", n, x, y, c)
set object 1 rectangle from 10,18 to 710,34 fc rgb grey fs solid 0.25 noborder
eval turned(2, 70, 78, 0.75, grey)
eval turned(3, 320, 34, 0.40, blue)
eval turned(4, 560, 62, 0.02, grey)
eval dot(5, 70, 78, ink)
eval dot(6, 320, 34, orange)
eval dot(7, 560, 62, ink)
eval dot(8, px(320,0.40,62,30), py(34,0.40,62,30), blue)
set arrow 1 from px(320,0.40,62,30),py(34,0.40,62,30) to 324,36 arrowstyle 3
set arrow 2 from 320,36 to 320,104 arrowstyle 2
set arrow 3 from 70,74 to 70,38 arrowstyle 1
set arrow 4 from 560,66 to 560,104 arrowstyle 1
set label 1 "1. fly to the touch" at 105,216 center font bold textcolor rgb ink
set label 2 "2. strike there" at 370,216 center font bold textcolor rgb ink
set label 3 "3. fly on" at 620,216 center font bold textcolor rgb ink
set label 4 "impulse" at 312,96 right textcolor rgb orange front
set label 5 "arm" at 352,40 left textcolor rgb quiet front
plot NaN notitle
unset object; unset arrow; unset label
eval axes

eval box(80, 330, 52, 232)
set title "How far off is the velocity after it?"
set xlabel "turn in a substep, degrees"
set logscale xy
set xrange [0.08:40]
set yrange [1e-17:3]
set xtics ("0.1" 0.1, "1" 1, "10" 10)
set ytics ("1" 1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12, "10^{-16}" 1e-16)
set label 1 "struck where the\nsubstep began" at 0.4,3e-6 textcolor rgb orange font bold
set label 2 "the engine" at 0.4,3e-14 textcolor rgb blue font bold
plot csv index 0 using 1:2 with linespoints pt 7 ps 0.52 lc rgb orange lw 2, \
     csv index 0 using 1:3 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
unset label

eval box(440, 690, 52, 232)
set title "How long does an impact take?"
set xlabel "corners that strike together"
unset logscale x
set xrange [0.7:4.3]
set yrange [300:100000]
set xtics ("1" 1, "2" 2, "3" 3, "4" 4)
set ytics ("1 µs" 1e3, "10 µs" 1e4, "100 µs" 1e5)
set label 1 "plain form" at 1.1,6e4 textcolor rgb green font bold
set label 2 "the engine" at 2.5,700 textcolor rgb blue font bold
plot csv index 1 using 1:2 with linespoints pt 7 ps 0.52 lc rgb green lw 2, \
     csv index 1 using 1:3 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
