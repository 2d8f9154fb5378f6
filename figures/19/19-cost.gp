# 19-cost.gp - sh figures/draw/chart.sh figures/19/19-cost.gp DATA.csv CHART.svg
high = 390
load "figures/draw/chart.gp"
set datafile separator ","
set border 1 lc rgb grey lw 0.7
set grid xtics lc rgb rule lw 0.5
unset ytics
set ytics scale 0
set grid noytics
eval box(200, 660, 52, high - 36)
set yrange [8.7:-0.7] 
set xrange [0:1.5]
set xtics 0,0.5,1
set xlabel "time of a step, the same 200 boxes with nothing more = 1" textcolor rgb ink
set title "What one more thing costs a falling pile"
set style fill solid 1 noborder
bar(k) = 0.32
plot csv every ::1 using ($3/2):0:($3/2):(0.32):yticlabels(1) with boxxyerror lc rgb blue, \
     csv every ::1 using 3:0:(sprintf(" %.2f", $3)) with labels left offset 0.3,0 textcolor rgb ink
