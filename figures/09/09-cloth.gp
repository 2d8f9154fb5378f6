# 09-cloth.gp - sh figures/draw/chart.sh figures/09/09-cloth.gp DATA.csv CHART.svg
# Blocks of the data: the cube as printed, mended, engine; the rope likewise.
high = 360
load "figures/draw/chart.gp"
set datafile separator comma
mended = blue; printed = orange; engine = green
most = 1e4                      # %, more than this is off the picture
strain(s) = s > most ? most : s
set logscale y 10
set xrange [18.5:41.5]
set xtics ("20 × 20" 20, "30 × 30" 30, "40 × 40" 40)
set xlabel "particles of the cloth" textcolor rgb ink
set multiplot

eval box(66, 350, 50, 324)
set title "Frames a second"
set yrange [40:20000]
set ytics ("60" 60, "100" 100, "200" 200, "500" 500, "1,000" 1000, "2,000" 2000, "5,000" 5000)
set label 9 "real time at 60 Hz" at 19,70 textcolor rgb quiet font small
set arrow 1 from 18.5,60 to 41.5,60 nohead lc rgb quiet lw 0.8 dt 3
set label 1 "as printed" at 34,480 textcolor rgb printed
set label 2 "as mended" at 19.2,1500 textcolor rgb mended font bold
set label 3 "the engine of Part II" at 26,4300 textcolor rgb engine
set label 10 "squares: on the cube\ncircles: on the rope" at 19,160 textcolor rgb ink font small
plot csv index 0 using 3:(1000/$4) with linespoints pt 4 ps 0.72 lc rgb printed lw 1.6 dt (8,5), \
     csv index 1 using 3:(1000/$4) with linespoints pt 5 ps 0.72 lc rgb mended lw 2.4, \
     csv index 2 using 3:(1000/$4) with linespoints pt 4 ps 0.72 lc rgb engine lw 1.6, \
     csv index 3 using 3:(1000/$4) with linespoints pt 6 ps 0.72 lc rgb printed lw 1.6 dt (8,5), \
     csv index 4 using 3:(1000/$4) with linespoints pt 7 ps 0.72 lc rgb mended lw 2.4, \
     csv index 5 using 3:(1000/$4) with linespoints pt 6 ps 0.72 lc rgb engine lw 1.6
unset label
unset arrow

eval box(460, 708, 50, 324)
set title "Largest strain in 5 s"
set yrange [0.04:30000]
set ytics ("0.1 %%" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100, "1,000 %%" 1000, "≥ 10,000 %%" most)
set label 1 "as printed" at 26,9000 textcolor rgb printed
set label 2 "as mended" at 20,22 textcolor rgb mended font bold
set label 3 "the engine of Part II" at 19.6,0.85 textcolor rgb engine
plot csv index 0 using 3:(strain($5)) with linespoints pt 4 ps 0.72 lc rgb printed lw 1.6 dt (8,5), \
     csv index 3 using 3:(strain($5)) with linespoints pt 6 ps 0.72 lc rgb printed lw 1.6 dt (8,5), \
     csv index 1 using 3:(strain($5)) with linespoints pt 5 ps 0.72 lc rgb mended lw 2.4, \
     csv index 4 using 3:(strain($5)) with linespoints pt 7 ps 0.72 lc rgb mended lw 2.4, \
     csv index 2 using 3:(strain($5)) with linespoints pt 4 ps 0.72 lc rgb engine lw 1.6, \
     csv index 5 using 3:(strain($5)) with linespoints pt 6 ps 0.72 lc rgb engine lw 1.6
unset multiplot
