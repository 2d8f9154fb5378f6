# 12-pull.gp - a drawing: sh figures/draw/chart.sh figures/12/12-pull.gp - CHART.svg
high = 330
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
set multiplot
set style arrow 1 head filled size 0.13,22 lw 2.4 lc rgb blue
set style arrow 2 head filled size 0.13,22 lw 2.4 lc rgb orange
set style arrow 3 head filled size 0.13,22 lw 2.6 lc rgb ink

eval box(0, 400, 10, 294)
set size ratio -1
set label 91 "Each particle is held by two links" at screen 0.277778, screen 0.95 center textcolor rgb ink font bold
set xrange [-0.45:6.05]
set yrange [-2.75:1.85]
array px[6] = [0, 1.05, 2.2, 3.35, 4.45, 5.4]
array py[6] = [1.2, 0.45, 0.05, 0.0, -0.4, -1.15]
do for [k = 1:5] { set arrow 10 + k from px[k],py[k] to px[k+1],py[k+1] nohead lw 1.4 lc rgb grey back }
f = 0.62
set arrow 1 from px[3],py[3] to px[3]+f*(px[4]-px[3]),py[3]+f*(py[4]-py[3]) as 1
set arrow 2 from px[3],py[3] to px[3]+f*(px[2]-px[3]),py[3]+f*(py[2]-py[3]) as 2
set arrow 3 from px[6],py[6] to px[6],py[6]-1.15 as 3
set label 1 "λ_k o_k" at 2.72,0.42 center textcolor rgb blue
set label 2 "−λ_{k−1} o_{k−1}" at 1.55,-0.22 right textcolor rgb orange
set label 3 "x_k" at px[3],py[3]+0.5 center textcolor rgb ink
set label 4 "x_{k+1}" at px[4]+0.1,py[4]+0.45 center textcolor rgb ink
set label 5 "x_{k−1}" at px[2]+0.1,py[2]+0.5 left textcolor rgb ink
set label 6 "pinned" at px[1]+0.22,py[1]+0.2 left textcolor rgb ink
set label 7 "a load\npulls" at px[6]-0.2,py[6]-0.75 right textcolor rgb ink
plot for [k = 1:6] "+" using (px[k]):(py[k]) every ::0::0 with points pt (k == 1 ? 5 : 7) ps 1.1 lc rgb ink
unset arrow
unset label

eval box(430, 710, 10, 294)
set label 92 "so its equations have three diagonals" at screen 0.791667, screen 0.95 center textcolor rgb ink font bold
set xrange [-1.6:8.4]
set yrange [7.6:-1.2]
array shade[3] = [orange, ink, blue]
do for [i = 0:6] {
  do for [j = 0:6] {
    n = 1 + 7 * i + j
    d = j - i
    set object n rectangle from j+0.06,i+0.06 to j+0.94,i+0.94 fc rgb (d == -1 ? orange : d == 0 ? grey : d == 1 ? blue : rule) fs solid (abs(d) < 2 ? 1 : 0.4) noborder
  }
}
set arrow 1 from -0.55,0.2 to -0.55,6.8 head filled size 0.3,22 lw 2 lc rgb ink
set arrow 2 from 7.55,6.8 to 7.55,0.2 head filled size 0.3,22 lw 2 lc rgb ink
set label 1 "down: each into the next" at -0.95,3.5 center rotate by 90 textcolor rgb ink
set label 2 "up: all are known" at 8.0,3.5 center rotate by 90 textcolor rgb ink
set label 3 "one row a link" at 3.5,7.4 center textcolor rgb quiet
plot NaN
unset multiplot
