# 05-rules.gp - sh figures/draw/chart.sh figures/05/05-rules.gp DATA.csv CHART.svg
high = 390
load "figures/draw/chart.gp"
set datafile separator comma
set style fill solid 1 noborder
unset grid
set lmargin at screen 0.40
set rmargin at screen 0.96
set tmargin at screen 0.84
set bmargin at screen 0.02
set border 2 lc rgb grey lw 0.7
unset xtics
set xrange [0:720]
set yrange [9.6:-0.6]
set ytics nomirror scale 0 textcolor rgb ink
set label 3 "Wrong answers without one rule, of some 7,000 hard pairs" at screen 0.02,0.95 textcolor rgb ink font bold
set label 1 "depth wrong" at screen 0.40,0.88 textcolor rgb orange
set label 2 "depth right, normal or points off" at screen 0.58,0.88 textcolor rgb blue
plot csv every ::1 using (0.5*($4+0)):0:(0.5*($4+0)):(0.36):ytic(1) with boxxyerror lc rgb orange, \
     csv every ::1 using ($4+0.5*$6):0:(0.5*$6):(0.36) with boxxyerror lc rgb blue, \
     csv every ::1 using ($4+$6+8):0:(sprintf("%d", $4+$6)) with labels left textcolor rgb ink
