# 02-stick.gp - sh figures/draw/chart.sh figures/02/02-stick.gp DATA.csv CHART.svg
high = 410
load "figures/draw/chart.gp"
set border 2 lc rgb grey lw 0.7
unset xtics
unset grid
set lmargin 18
set rmargin 16
set tmargin 4
set yrange [3.6:-0.6]
set xrange [0:*]
set ytics scale 0 ("bare loop" 0, "PBD,\nexact root" 1, "PBD,\napproximate root" 2, "SHAKE" 3)
set title "The time of one relaxation in a rope" offset 0,0.8
set label 1 "stick after stick" at graph 0,1.04 textcolor rgb orange
set label 2 "even sticks first" at graph 0.36,1.04 textcolor rgb blue
set style fill solid 1 noborder
w = 0.17
plot csv using (0):0:(0):4:($0-0.19-w):($0-0.19+w) with boxxyerror lc rgb orange, \
     csv using (0):0:(0):5:($0+0.19-w):($0+0.19+w) with boxxyerror lc rgb blue, \
     csv using 4:($0-0.19):(sprintf("%.1f ns", column(2))) with labels left offset 0.5,0 textcolor rgb orange, \
     csv using 5:($0+0.19):(sprintf("%.1f ns", column(3))) with labels left offset 0.5,0 textcolor rgb blue
