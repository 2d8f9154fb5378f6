# 18-both.gp - sh figures/draw/chart.sh figures/18/18-both.gp DATA.csv CHART.svg
high = 430
load "figures/draw/chart.gp"
set logscale xy 10
set xrange [0.012:6]
set yrange [1e-3:3000]
set xtics ("0.01 ms" 0.01, "0.1 ms" 0.1, "1 ms" 1)
set ytics ("0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1, "1,000 %%" 10, "10,000 %%" 100)
set xlabel "time of a step, the median" textcolor rgb ink
set title "The plain system and the engine: the largest error in any frame"

set label 1 "fifty icosahedra: overlap,\nin parts of a radius" at 0.016,0.2 textcolor rgb blue font bold
set label 2 "cloth on a cube: strain" at 0.12,25 textcolor rgb orange font bold
set label 3 "cloth on a\nrope: strain" at 2.3,2.2 textcolor rgb green font bold
set label 4 "○ plain, as printed    ● plain, as mended    ■ engine" at graph 0.02,0.96 textcolor rgb ink
plot csv index 0 using 2:($3/0.5) with lines lc rgb blue lw 1, \
     csv index 1 using 2:5 with lines lc rgb orange lw 1, \
     csv index 2 using 2:5 with lines lc rgb green lw 1, \
     for [k=0:2] csv index k using ($1==0 ? $2 : 1/0):(k==0 ? $3/0.5 : $5) with points pt 6 ps 1.43 lw 1.5 lc rgb (k==0 ? blue : k==1 ? orange : green), \
     for [k=0:2] csv index k using ($1==1 ? $2 : 1/0):(k==0 ? $3/0.5 : $5) with points pt 7 ps 1.43 lc rgb (k==0 ? blue : k==1 ? orange : green), \
     for [k=0:2] csv index k using ($1==2 ? $2 : 1/0):(k==0 ? $3/0.5 : $5) with points pt 5 ps 1.43 lc rgb (k==0 ? blue : k==1 ? orange : green)
