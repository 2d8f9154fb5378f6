# 16-touch.gp - a drawing: sh figures/draw/chart.sh figures/16/16-touch.gp - CHART.svg
high = 270
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 270)
set xrange [0:720]
set yrange [0:270]
set style arrow 1 nohead lc rgb ink lw 2.2
set style arrow 2 nohead lc rgb blue lw 2.2 dt 2
set style arrow 3 head filled size screen 0.011,22 lc rgb orange lw 2.2
set style arrow 4 heads filled size screen 0.009,22 lc rgb quiet lw 1.2
dot(n, x, y, c) = sprintf("set object %d circle at %g,%g size 4 fc rgb '%s' fs solid 1 front", n, x, y, c)
ring(n, x, y, r, c) = sprintf("set object %d circle at %g,%g size %g fc rgb '%s' fs transparent solid 0.15 border lc rgb '%s'", n, x, y, r, c, c)

# A touch: a side between two particles, too deep by d over a corner.  The point
# has the weights .7 and .3, so they move by .7 and .3 of d over .58.
d = 40
x1 = 40; y1 = 118; x2 = 210; y2 = 108
px = 0.7 * x1 + 0.3 * x2; py = 0.7 * y1 + 0.3 * y2
set label 1 "a touch" at 122,250 center font bold textcolor rgb ink
set object 1 polygon from 20,30 to 20,40 to px,py+d to 228,62 to 228,30 to 20,30 fc rgb purple fs solid 0.18 border lc rgb purple
set arrow 1 from x1,y1 to x2,y2 arrowstyle 1
set arrow 2 from x1,y1+0.7/0.58*d to x2,y2+0.3/0.58*d arrowstyle 2
set arrow 3 from x1,y1+5 to x1,y1+0.7/0.58*d-5 arrowstyle 3
set arrow 4 from x2,y2+4 to x2,y2+0.3/0.58*d-4 arrowstyle 3
set arrow 5 from px,py+4 to px,py+d-3 arrowstyle 3
eval dot(2, x1, y1, ink)
eval dot(3, x2, y2, ink)
eval dot(4, px, py, orange)
eval dot(5, x1, y1+0.7/0.58*d, blue)
eval dot(6, x2, y2+0.3/0.58*d, blue)
set label 2 "c = 0.7" at x1-2,y1-16 center textcolor rgb ink front
set label 3 "c = 0.3" at x2-2,y2-16 center textcolor rgb ink front
set label 4 "δ" at px+8,py+20 left textcolor rgb orange front

# Half distances: a corner over an edge, and how far each particle may go.
set label 11 "its space" at 360,250 center font bold textcolor rgb ink
a = 100
set arrow 11 from 296,70 to 424,70 arrowstyle 1
eval ring(11, 296, 70, 0.45*a, blue)
eval ring(12, 424, 70, 0.45*a, blue)
eval ring(13, 360, 70+a, 0.45*a, orange)
eval dot(14, 296, 70, ink)
eval dot(15, 424, 70, ink)
eval dot(16, 360, 70+a, ink)
set arrow 12 from 296,70+0.45*a to 424,70+0.45*a arrowstyle 2
set arrow 13 from 360,74 to 360,70+a-5 arrowstyle 4
set label 12 "d" at 368,100 left textcolor rgb quiet front
set label 13 "0.45 d" at 405,70+a+20 left textcolor rgb orange front
eval dot(17, 360, 70+0.55*a, orange)

# Balls: two diagonals of a cell that cross in their middles.
set label 21 "balls" at 608,250 center font bold textcolor rgb ink
s = 100
cx = 558; cy = 70
eval ring(21, cx, cy, 0.5*s, blue)
eval ring(22, cx+s, cy+s, 0.5*s, blue)
eval ring(23, cx+s, cy, 0.5*s, orange)
eval ring(24, cx, cy+s, 0.5*s, orange)
set arrow 21 from cx,cy to cx+s,cy+s nohead lc rgb blue lw 2.2
set arrow 22 from cx+s,cy to cx,cy+s nohead lc rgb orange lw 2.2
eval dot(25, cx, cy, blue)
eval dot(26, cx+s, cy+s, blue)
eval dot(27, cx+s, cy, orange)
eval dot(28, cx, cy+s, orange)
plot NaN
