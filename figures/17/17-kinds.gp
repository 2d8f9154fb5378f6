# 17-kinds.gp - a drawing: sh figures/draw/chart.sh figures/17/17-kinds.gp - CHART.svg
high = 260
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 260)
set xrange [0:720]
set yrange [0:260]
set style arrow 1 nohead lc rgb rule lw 1.5
set style arrow 2 head filled size screen 0.011,22 lc rgb purple lw 2.4
set style arrow 3 head filled size screen 0.011,22 lc rgb blue lw 2.4
set style arrow 4 heads filled size screen 0.009,22 lc rgb orange lw 2
set style arrow 5 nohead lc rgb ink lw 1.5 dt 2
# A box with its lower left corner at the origin, put to (x, y) and turned.
corner(i, w, h) = i % 4 == 1 || i % 4 == 2 ? w : 0
height(i, w, h) = i % 4 >= 2 ? h : 0
px(i, w, h, x, t) = x + corner(i, w, h) * cos(t) - height(i, w, h) * sin(t)
py(i, w, h, y, t) = y + corner(i, w, h) * sin(t) + height(i, w, h) * cos(t)
solid(n, w, h, x, y, t, c) = sprintf("set object %d polygon from %g,%g to %g,%g to %g,%g to %g,%g to %g,%g fc rgb '%s' fs solid 0.22 border lc rgb '%s'", \
  n, px(0,w,h,x,t), py(0,w,h,y,t), px(1,w,h,x,t), py(1,w,h,y,t), px(2,w,h,x,t), py(2,w,h,y,t), px(3,w,h,x,t), py(3,w,h,y,t), px(0,w,h,x,t), py(0,w,h,y,t), c, c)

set label 1 "hinge: 5 rows" at 120,240 center font bold textcolor rgb ink
eval solid(1, 60, 150, 45, 30, 0, purple)
eval solid(2, 80, 150, 118, 38, -0.12, blue)
set label 2 "A" at 70,75 center font bold textcolor rgb purple front
set label 3 "B" at 170,75 center font bold textcolor rgb blue front
set arrow 1 from 112,110 to 112,212 arrowstyle 2
set arrow 2 from 112,110 to 125,211 arrowstyle 3
set label 4 "a_A" at 104,206 right textcolor rgb purple front
set label 5 "a_B" at 133,206 left textcolor rgb blue front
set arrow 3 from 112,110 to 80,120 arrowstyle 4
set label 6 "t" at 74,124 right textcolor rgb orange front

set label 11 "fixed: 6 rows" at 360,240 center font bold textcolor rgb ink
eval solid(3, 90, 50, 265, 100, 0, purple)
eval solid(4, 90, 50, 368, 104, 0.16, blue)
set label 12 "A" at 310,125 center font bold textcolor rgb purple front
set label 13 "B" at 385,146 center font bold textcolor rgb blue front
set arrow 11 from 360,125 to 452,125 arrowstyle 5
set arrow 12 from 364,129 to 455,144 arrowstyle 5
set label 14 "θ" at 462,134 left textcolor rgb orange front

set label 21 "distance: 1 row" at 600,240 center font bold textcolor rgb ink
eval solid(5, 60, 50, 520, 130, 0.3, purple)
eval solid(6, 60, 50, 640, 50, -0.2, blue)
set label 22 "A" at 542,162 center font bold textcolor rgb purple front
set label 23 "B" at 675,69 center font bold textcolor rgb blue front
set arrow 21 from 570,160 to 650,90 arrowstyle 4
set object 31 circle at 570,160 size 3 fc rgb ink fs solid 1 front
set object 32 circle at 650,90 size 3 fc rgb ink fs solid 1 front
set label 24 "least ≤ length ≤ most" at 600,25 center textcolor rgb ink
plot NaN
