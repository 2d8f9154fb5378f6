# 04-loop.gp - a drawing: sh figures/draw/chart.sh figures/04/04-loop.gp - CHART.svg
high = 320
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 320)
set xrange [0:720]
set yrange [0:320]
set style arrow 1 head filled size 11,22 lw 1.6 lc rgb ink
# Boxes at (x, y), w wide and h high, around their middles.
frame(n, x, y, w, h, c) = sprintf("set object %d rectangle center %g,%g size %g,%g fc rgb '%s' fs solid 0.15 border rgb '%s' lw 1.4", n, x, y, w, h, c, c)
eval frame(1, 105, 215, 170, 70, blue)
eval frame(2, 360, 215, 170, 70, blue)
eval frame(3, 615, 215, 170, 70, blue)
eval frame(4, 360, 65, 170, 56, green)
eval frame(5, 615, 65, 170, 56, green)
eval frame(6, 105, 65, 170, 56, orange)
set label 1 "the nearest point v\nof the simplex to 0;\ndrop idle corners" at 105,231 center textcolor rgb ink
set label 2 "the support w of A − B\nalong −v: the corner\nfurthest towards 0" at 360,231 center textcolor rgb ink
set label 3 "is w further along −v\nthan the simplex is?" at 615,223 center textcolor rgb ink
set label 4 "add w to the simplex:\n2 to 4 corners" at 360,73 center textcolor rgb ink
set label 5 "apart: |v| is\nthe distance" at 615,73 center textcolor rgb ink
set label 6 "v = 0: they overlap" at 105,65 center textcolor rgb ink
set label 7 "begin with one corner, or\nwith the last frame’s simplex" at 105,305 center textcolor rgb quiet
set arrow 1 from 105,278 to 105,252 as 1
set arrow 2 from 191,215 to 273,215 as 1
set arrow 3 from 446,215 to 528,215 as 1
set arrow 4 from 105,179 to 105,95 as 1
set arrow 5 from 615,179 to 615,95 as 1
set label 8 "no" at 625,137 textcolor rgb green
set label 9 "yes" at 480,150 right textcolor rgb blue
set arrow 6 from 545,179 to 430,95 as 1
set arrow 7 from 290,95 to 175,179 as 1
set label 10 "again" at 222,122 right textcolor rgb blue
plot NaN
