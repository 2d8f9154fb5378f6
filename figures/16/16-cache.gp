# 16-cache.gp - gnuplot -e "csv='...'; png='...'" figures/16/16-cache.gp
set encoding utf8
set terminal pngcairo size 1500,640 font "DejaVu Sans,21" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics lc rgb "#e4e4e4" lw 0.5
set xlabel "s" textcolor rgb "#404040"
unset key
orange = "#d55e00"; blue = "#0072b2"
set multiplot layout 1,2
set logscale y 10
set yrange [0.5:20000]
set title "room of 1,000: questions a frame" font "DejaVu Sans,24"
set label 1 "asked in every frame" at 5.8,9000 center textcolor rgb orange
set label 2 "kept" at 4.2,300 textcolor rgb blue
plot csv index 1 using 1:($3>0?$3:0.5) with lines lc rgb orange lw 1.5, \
     csv index 1 using 1:($2>0?$2:0.5) with lines lc rgb blue lw 1.5
unset label
set title "pyramid of 210: questions a frame" font "DejaVu Sans,24"
set label 1 "asked in every frame" at 5,1800 center textcolor rgb orange
set label 2 "kept" at 2.2,40 textcolor rgb blue
plot csv index 2 using 1:($3>0?$3:0.5) with lines lc rgb orange lw 1.5, \
     csv index 2 using 1:($2>0?$2:0.5) with lines lc rgb blue lw 1.5
