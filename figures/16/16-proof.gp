# 16-proof.gp - a drawing: sh figures/draw/chart.sh figures/16/16-proof.gp - CHART.svg
high = 250
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 250)
set xrange [0:720]
set yrange [0:250]
set parametric
set style arrow 1 nohead lc rgb quiet lw 1.4 dt 2
set style arrow 2 head filled size screen 0.011,22 lc rgb purple lw 2.2
set style arrow 3 nohead lc rgb rule lw 1.2
set style arrow 4 head filled size screen 0.009,22 lc rgb quiet lw 1.2
triangle(n, x, y, u, v, p, q, c, how) = sprintf("set object %d polygon from %g,%g to %g,%g to %g,%g to %g,%g fc rgb '%s' fs %s border lc rgb '%s'", n, x, y, u, v, p, q, x, y, c, how, c)
dot(n, x, y, c) = sprintf("set object %d circle at %g,%g size 3.5 fc rgb '%s' fs solid 1 front", n, x, y, c)

# A plane with the same normal at both ends of the frame.
set label 1 "a plane for two" at 118,232 center font bold textcolor rgb ink
eval triangle(1, 60,170, 100,200, 130,160, blue, "solid 0.25")
eval triangle(2, 70,120, 120,105, 95,75, orange, "solid 0.25")
eval triangle(3, 130,135, 172,160, 196,128, blue, "empty")
eval triangle(4, 120,88, 172,96, 150,50, orange, "empty")
set arrow 1 from 30,143 to 140,143 arrowstyle 1
set arrow 2 from 100,112 to 215,112 arrowstyle 1
set arrow 3 from 40,143 to 40,185 arrowstyle 2
set label 2 "n" at 26,172 center textcolor rgb purple front
set arrow 4 from 104,172 to 142,150 arrowstyle 4
set arrow 5 from 104,98 to 132,84 arrowstyle 4
set label 3 "x" at 52,198 center textcolor rgb quiet front
set label 4 "y" at 205,145 center textcolor rgb quiet front

# A bent page: every point has a shadow of its own.
page_x(t) = 262 + 190 * t
page_y(t) = 140 + 45 * sin(5.5 * t) - 8 * t
set label 11 "a shadow without a fold" at 357,232 center font bold textcolor rgb ink
do for [i = 0:8] {
    t = i / 8.0
    set arrow 20+i from page_x(t),page_y(t) to page_x(t),52 arrowstyle 3
    eval dot(20+i, page_x(t), 52, orange)
    eval dot(40+i, page_x(t), page_y(t), blue)
}
set arrow 30 from page_x(0),52 to page_x(1),52 nohead lc rgb orange lw 2.2

# A page that turns back: two points with one shadow.
turn_x(t) = 560 + 70 * sin(4.2 * t)
turn_y(t) = 90 + 115 * t
set label 12 "and one with a fold" at 600,232 center font bold textcolor rgb ink
fold = 0.2
other = 3.14159265 / 4.2 - fold
set arrow 31 from turn_x(fold),turn_y(other) to turn_x(fold),52 arrowstyle 3
set arrow 32 from turn_x(0.9),52 to turn_x(3.14159265/8.4),52 nohead lc rgb orange lw 2.2
eval dot(60, turn_x(fold), turn_y(fold), red)
eval dot(61, turn_x(other), turn_y(other), red)
eval dot(62, turn_x(fold), 52, red)
set label 13 "shadows" at 357,28 center textcolor rgb quiet
set label 14 "two points, one shadow" at 600,28 center textcolor rgb quiet
set trange [0:1]
plot page_x(t),page_y(t) with lines lc rgb blue lw 2.2, [t=-0.1:0.9] turn_x(t),turn_y(t) with lines lc rgb blue lw 2.2
