# 09-bodies.gp - sh figures/draw/chart.sh figures/09/09-bodies.gp DATA.csv CHART.svg
high = 340
load "figures/draw/chart.gp"
set datafile separator comma
set logscale y 10
set xrange [0:208]
set xtics 0,50,200
set xlabel "bodies" textcolor rgb ink
mended = blue; printed = orange; engine = green
set multiplot

eval box(66, 350, 50, 304)
set title "Frames a second"
set yrange [10:300000]
set ytics ("10" 10, "20" 20, "60" 60, "100" 100, "1,000" 1000, "10,000" 10000, "100,000" 100000)
set label 1 "as printed" at 110,2300 textcolor rgb printed
set label 2 "as mended" at 20,420 textcolor rgb mended font bold
set label 3 "as published in 2005,\nPentium 4, 1.8 GHz" at 60,29 textcolor rgb printed font small
set label 4 "real time at 60 Hz" at 106,75 textcolor rgb quiet font small
set label 5 "the engine of Part II" at 60,45000 textcolor rgb engine
set arrow 1 from 0,60 to 208,60 nohead lc rgb quiet lw 0.8 dt 3
$published << EOD
50,20
EOD
plot csv using 1:(1000/$2) with linespoints pt 6 ps 0.72 lc rgb printed lw 1.6 dt (8,5), \
     csv using 1:(1000/$6) with linespoints pt 5 ps 0.72 lc rgb engine lw 1.6, \
     csv using 1:(1000/$4) with linespoints pt 7 ps 0.72 lc rgb mended lw 2.4, \
     $published using 1:2 with points pt 9 ps 1.43 lc rgb printed
unset label
unset arrow

eval box(430, 708, 50, 304)
set title "Deepest overlap, of a radius"
set yrange [0.04:250]
set ytics ("0.1 %%" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100)
set label 1 "as printed" at 100,38 textcolor rgb printed
set label 2 "as mended" at 100,6.2 textcolor rgb mended font bold
set label 5 "the engine of Part II" at 100,0.45 textcolor rgb engine
plot csv using 1:3 with linespoints pt 6 ps 0.72 lc rgb printed lw 1.6 dt (8,5), \
     csv using 1:7 with linespoints pt 5 ps 0.72 lc rgb engine lw 1.6, \
     csv using 1:5 with linespoints pt 7 ps 0.72 lc rgb mended lw 2.4
unset multiplot
