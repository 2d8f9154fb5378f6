# 17-front.gp - a drawing: sh figures/draw/chart.sh figures/17/17-front.gp - CHART.svg
high = 230
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 230)
set xrange [0:720]
set yrange [0:230]
set style arrow 1 nohead lc rgb rule lw 1.6
set style arrow 2 head filled size screen 0.010,22 lc rgb orange lw 2
# Bodies: solved, in the front, and not yet.
colour(s) = s == 0 ? rule : s == 1 ? orange : blue
ball(n, x, y, s) = sprintf("set label %d '' at %g,%g point pt 7 ps 1.9 lc rgb '%s' front", n + 200, x, y, colour(s))

set label 1 "a chain: one waits" at 110,212 center font bold textcolor rgb ink
do for [k = 0:6] {
    if (k < 6) { set arrow 10+k from 30+27*k,120 to 57+27*k,120 arrowstyle 1 }
    eval ball(10+k, 30+27*k, 120, k < 3 ? 0 : k == 3 ? 1 : 2)
}
set arrow 20 from 111,145 to 140,145 arrowstyle 2

set label 2 "a ring: two wait" at 350,212 center font bold textcolor rgb ink
ringx(k) = 350 + 66 * sin(2 * pi * k / 12.0)
ringy(k) = 115 + 66 * cos(2 * pi * k / 12.0)
do for [k = 0:11] {
    set arrow 30+k from ringx(k),ringy(k) to ringx(k+1),ringy(k+1) arrowstyle 1
    eval ball(30+k, ringx(k), ringy(k), k < 3 || k > 9 ? 0 : k == 3 || k == 9 ? 1 : 2)
}
set arrow 44 from 438,112 to 428,84 arrowstyle 2
set arrow 45 from 262,112 to 272,84 arrowstyle 2

set label 3 "a net: as many as it is wide" at 595,212 center font bold textcolor rgb ink
do for [i = 0:5] {
    do for [j = 0:3] {
        x = 520 + 30 * i; y = 70 + 30 * j
        if (i < 5) { set arrow 50+4*i+j from x,y to x+30,y arrowstyle 1 }
        if (j < 3) { set arrow 80+4*i+j from x,y to x,y+30 arrowstyle 1 }
        eval ball(50+4*i+j, x, y, i < 2 ? 0 : i == 2 ? 1 : 2)
    }
}
set arrow 120 from 570,180 to 600,180 arrowstyle 2

eval ball(200, 180, 22, 0)
set label 11 "solved" at 195,22 left textcolor rgb quiet
eval ball(201, 300, 22, 1)
set label 12 "the front" at 315,22 left textcolor rgb quiet
eval ball(202, 440, 22, 2)
set label 13 "not yet" at 455,22 left textcolor rgb quiet
plot NaN
