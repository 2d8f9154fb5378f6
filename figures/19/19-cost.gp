# 19-cost.gp - gnuplot -e "csv='...'; png='...'" figures/19/19-cost.gp
set encoding utf8
set terminal pngcairo size 1400,760 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator ","
set border 1 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid xtics lc rgb "#e4e4e4" lw 0.5
unset key
set lmargin 27
set rmargin 8
set yrange [8.7:-0.7] 
set xrange [0:1.75]
set xtics ("as long" 1, "0" 0, "half as long again" 1.5)
set xlabel "time of a step, beside the same 200 boxes with nothing more" textcolor rgb "#404040"
set title "What one more thing costs a falling pile" font "DejaVu Sans,26" offset 0,-0.3
set style fill solid 1 noborder
bar(k) = 0.32
plot csv every ::1 using ($3/2):0:($3/2):(0.32):yticlabels(1) with boxxyerror lc rgb "#0072b2", \
     csv every ::1 using 3:0:(sprintf("  %.2f", $3)) with labels left textcolor rgb "#404040"
