# 12-bend.gp - sh figures/draw/chart.sh figures/12/12-bend.gp DATA.csv CHART.svg
high = 510
load "figures/draw/chart.gp"
array colour[4] = [orange, purple, green, blue]
set multiplot
set logscale x 10
set xrange [0.09:400]
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100)
set lmargin at screen 0.1
set rmargin at screen 0.97
set tmargin at screen 0.93
set bmargin at screen 0.42
set title "A strip held level at one end: the sag of its free end, of its length"
set yrange [0:1.05]
set format x ""
set xtics ("" 0.1, "" 1, "" 10, "" 100)
set arrow 1 from 0.18,0 to 0.18,0.2 nohead lc rgb grey dt 2
set arrow 2 from 39,0 to 39,0.83 nohead lc rgb grey dt 2
set arrow 3 from 118,0 to 118,0.88 nohead lc rgb grey dt 2
set label 1 "card" at 0.195,0.16 textcolor rgb ink
set label 2 "denim" at 36,0.3 right textcolor rgb ink
set label 3 "silk" at 126,0.3 textcolor rgb ink
set label 4 "theory" at 3.4,0.31 textcolor rgb ink
set label 5 "5 links" at 0.42,0.93 textcolor rgb orange
set label 6 "10" at 0.42,0.86 textcolor rgb purple
set label 7 "20" at 0.42,0.79 textcolor rgb green
set label 8 "40" at 0.42,0.72 textcolor rgb blue
plot csv using 1:2 with lines lc rgb grey lw 3, \
     csv using 1:3 with points pt 7 ps 0.72 lc rgb orange, \
     csv using 1:4 with points pt 7 ps 0.65 lc rgb purple, \
     csv using 1:5 with points pt 7 ps 0.59 lc rgb green, \
     csv using 1:6 with points pt 7 ps 0.52 lc rgb blue
unset label
unset arrow
set title "Off theory"
set tmargin at screen 0.33
set bmargin at screen 0.1
set format x
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100)
set xlabel "load q L³ / (E I): weight against stiffness" textcolor rgb ink
set logscale y 10
set yrange [1e-5:0.5]
set ytics ("10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 1e-3, "0.01 %%" 1e-4)
plot for [k=3:6] csv using 1:(abs(column(k)/$2-1)) with linespoints pt 7 ps 0.45 lw 1.3 lc rgb colour[k-2]
unset multiplot
