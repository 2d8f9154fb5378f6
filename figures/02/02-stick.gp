# 02-stick.gp - sh figures/draw/chart.sh figures/02/02-stick.gp DATA.csv CHART.svg
high = 410
load "figures/draw/chart.gp"
set border 2 lc rgb grey lw 0.7
unset xtics
unset grid
set lmargin 18
set rmargin 16
set yrange [3.6:-0.6]
set xrange [0:*]
set ytics scale 0 ("bare loop" 0, "PBD,\nexact root" 1, "PBD,\napproximate root" 2, "SHAKE" 3)
set title "The time of one relaxation: a rope, stick after stick, and even sticks first"
set style fill solid 1 noborder
w = 0.17
plot csv using (0):0:(0):4:($0-0.19-w):($0-0.19+w) with boxxyerror lc rgb orange, \
     csv using (0):0:(0):5:($0+0.19-w):($0+0.19+w) with boxxyerror lc rgb blue, \
     csv using 4:($0-0.19):(sprintf("%.1f ns%s", column(2), $0==0 ? ",\nstick after stick" : "")) with labels left offset 0.5,0 textcolor rgb orange, \
     csv using 5:($0+0.19):(sprintf("%.1f ns%s", column(3), $0==0 ? ", even sticks first" : "")) with labels left offset 0.5,0 textcolor rgb blue
