# 14-sweep.gp - a drawing: sh figures/draw/chart.sh figures/14/14-sweep.gp - CHART.svg
high = 420
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [-0.3:13.9]
set yrange [-4.6:3.6]
# Balls by where their shadows begin.
array x[7] = [1.1, 2.7, 4.7, 6.1, 6.5, 10.0, 11.6]
array y[7] = [1.6, 2.6, 1.2, 2.75, 0.9, 1.8, 1.2]
array r[7] = [0.8, 0.7, 1.0, 0.7, 0.9, 0.9, 0.8]
bar(k) = -1.15 - 0.36 * (k - 1)
do for [k = 1:7] {
  c = k == 3 ? orange : k == 4 || k == 5 ? green : blue
  set object k circle at x[k],y[k] size r[k] fc rgb c fs transparent solid 0.2 border lc rgb c
  set object 10 + k rectangle from x[k]-r[k],bar(k)-0.1 to x[k]+r[k],bar(k)+0.1 fc rgb c fs solid 1 noborder
  set label k sprintf("%d", k) at x[k],y[k] center textcolor rgb c font bold front
}
set arrow 1 from x[3]-r[3],y[3] to x[3]-r[3],bar(3) nohead dt 2 lw 0.9 lc rgb orange back
set arrow 2 from x[3]+r[3],y[3] to x[3]+r[3],bar(7)-0.3 nohead dt 2 lw 0.9 lc rgb orange back
set arrow 3 from -0.2,-0.75 to 13.4,-0.75 head filled size 0.25,20 lw 1.2 lc rgb ink
set label 20 "x" at 13.55,-0.75 left textcolor rgb ink
set label 21 "the shadows, sorted by where they begin" at 0,-3.75 left textcolor rgb quiet
set label 22 "ball 3 is compared with 4 and 5, whose shadows begin before its own ends" at 0,-4.2 left textcolor rgb orange
plot NaN
