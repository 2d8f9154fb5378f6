# 04-loop.gp - a drawing: sh figures/draw/chart.sh figures/04/04-loop.gp - CHART.svg
high = 410
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 410)
set xrange [0:720]
set yrange [0:410]
set style arrow 1 head filled size 11,22 lw 1.6 lc rgb ink
# Boxes at (x, y), w wide and h high, around their middles.
frame(n, x, y, w, h, c) = sprintf("set object %d rectangle center %g,%g size %g,%g fc rgb '%s' fs solid 0.15 border rgb '%s' lw 1.4", n, x, y, w, h, c, c)
eval frame(1, 260, 300, 164, 70, blue)
eval frame(2, 460, 300, 164, 70, blue)
eval frame(3, 460, 170, 164, 70, blue)
eval frame(4, 260, 170, 164, 70, green)
eval frame(5, 460, 40, 164, 56, green)
eval frame(6, 260, 40, 164, 56, orange)
set label 1 "the nearest point v\nof the simplex to 0;\ndrop idle corners" at 260,316 center textcolor rgb ink
set label 2 "the support w of A − B\nalong −v: the corner\nfurthest towards 0" at 460,316 center textcolor rgb ink
set label 3 "is w further along\n−v than the\nsimplex is?" at 460,186 center textcolor rgb ink
set label 4 "add w to the simplex:\n2 to 4 corners" at 260,178 center textcolor rgb ink
set label 5 "apart: |v| is\nthe distance" at 460,48 center textcolor rgb ink
set label 6 "v = 0: they overlap" at 260,40 center textcolor rgb ink
set label 7 "begin with one corner, or\nwith the last frame’s simplex" at 260,396 center textcolor rgb quiet
set arrow 1 from 260,368 to 260,337 as 1
set arrow 2 from 343,300 to 375,300 as 1
set arrow 3 from 460,264 to 460,207 as 1
set arrow 4 from 377,170 to 345,170 as 1
set arrow 5 from 460,134 to 460,70 as 1
set arrow 6 from 260,206 to 260,263 as 1
set arrow 7 from 178,300 to 160,300 nohead lw 1.6 lc rgb ink
set arrow 8 from 160,300 to 160,40 nohead lw 1.6 lc rgb ink
set arrow 9 from 160,40 to 175,40 as 1
set label 8 "no" at 470,104 textcolor rgb green
set label 9 "yes" at 361,185 center textcolor rgb blue
set label 10 "again" at 270,236 textcolor rgb blue
plot NaN
