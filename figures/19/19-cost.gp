# 19-cost.gp - sh figures/draw/chart.sh figures/19/19-cost.gp DATA.csv CHART.svg
high = 390
load "figures/draw/chart.gp"
set datafile separator ","
set border 1 lc rgb grey lw 0.7
set grid xtics lc rgb rule lw 0.5
set lmargin 27
set rmargin 8
set yrange [8.7:-0.7] 
set xrange [0:1.75]
set xtics ("as long" 1, "0" 0, "half as long again" 1.5)
set xlabel "time of a step, beside the same 200 boxes with nothing more" textcolor rgb ink
set title "What one more thing costs a falling pile"
set style fill solid 1 noborder
bar(k) = 0.32
plot csv every ::1 using ($3/2):0:($3/2):(0.32):yticlabels(1) with boxxyerror lc rgb blue, \
     csv every ::1 using 3:0:(sprintf("  %.2f", $3)) with labels left textcolor rgb ink
