# 04-rules.gp - sh figures/draw/chart.sh figures/04/04-rules.gp DATA.csv CHART.svg
high = 440
load "figures/draw/chart.gp"
set datafile separator comma
set style fill solid 1 noborder
unset grid
set lmargin at screen 0.41
set rmargin at screen 0.97
set tmargin at screen 0.86
set bmargin at screen 0.02
set border 2 lc rgb grey lw 0.7
unset xtics
set xrange [0:1050]
set yrange [12.6:-0.6]
set ytics nomirror scale 0 textcolor rgb ink
set label 3 "Wrong answers without one rule, of 21,076 hard pairs" at screen 0.02,0.955 textcolor rgb ink font bold
set label 1 "overlap or apart mistaken" at screen 0.41,0.895 textcolor rgb orange
set label 2 "distance wrong" at screen 0.80,0.895 textcolor rgb blue
# Two bars are too long for the picture: they are cut, and their numbers tell.
cut(x) = x > 940 ? 940 : x
sign(x) = cut(x)
plot csv every ::1 using (0.5*sign($3+$5)):0:(0.5*sign($3+$5)):(0.36):ytic(1) with boxxyerror lc rgb orange, \
     csv every ::1 using (0.5*(sign($3+$5)+cut($2+$4))):0:(0.5*(cut($2+$4)-sign($3+$5))):(0.36) with boxxyerror lc rgb blue, \
     csv every ::1 using (cut($2+$4)+8):0:(sprintf("%d", $2+$4)) with labels left textcolor rgb ink
