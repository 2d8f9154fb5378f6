# 18-both.gp - gnuplot -e "csv='...'; png='...'" figures/18/18-both.gp
set encoding utf8
set terminal pngcairo size 1400,900 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set logscale xy 10
set xrange [0.012:6]
set yrange [1e-3:3000]
set xtics ("0.01 ms" 0.01, "0.1 ms" 0.1, "1 ms" 1)
set ytics ("0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1, "1,000 %%" 10, "10,000 %%" 100)
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set xlabel "time of a step, the median" textcolor rgb "#404040"
set ylabel "largest error in any frame" textcolor rgb "#404040"
set title "The plain system and the engine" font "DejaVu Sans,26" offset 0,-0.3
unset key
orange = "#d55e00"; blue = "#0072b2"; green = "#009e73"
set label 1 "fifty icosahedra: overlap,\nin parts of a radius" at 0.016,0.2 textcolor rgb blue font "DejaVu Sans Bold,20"
set label 2 "cloth on a cube: strain" at 0.12,120 textcolor rgb orange font "DejaVu Sans Bold,20"
set label 3 "cloth on a\nrope: strain" at 2.3,2.2 textcolor rgb green font "DejaVu Sans Bold,20"
set label 4 "○ plain, as printed   ● plain, as mended   ■ engine" at graph 0.02,0.96 textcolor rgb "#404040" font "DejaVu Sans,20"
plot csv index 0 using 2:($3/0.5) with lines lc rgb blue lw 1, \
     csv index 1 using 2:5 with lines lc rgb orange lw 1, \
     csv index 2 using 2:5 with lines lc rgb green lw 1, \
     for [k=0:2] csv index k using ($1==0 ? $2 : 1/0):(k==0 ? $3/0.5 : $5) with points pt 6 ps 2.2 lw 1.5 lc rgb (k==0 ? blue : k==1 ? orange : green), \
     for [k=0:2] csv index k using ($1==1 ? $2 : 1/0):(k==0 ? $3/0.5 : $5) with points pt 7 ps 2.2 lc rgb (k==0 ? blue : k==1 ? orange : green), \
     for [k=0:2] csv index k using ($1==2 ? $2 : 1/0):(k==0 ? $3/0.5 : $5) with points pt 5 ps 2.2 lc rgb (k==0 ? blue : k==1 ? orange : green)
