# 21-sphere_tree.gp - sh figures/draw/chart.sh figures/21/21-sphere_tree.gp DATA.csv CHART.svg
high = 400
load "figures/draw/chart.gp"
faces = orange; points = blue
set logscale xy 10
set multiplot

# Nothing at all is drawn at the bottom.
none = 1e-3
shown(e) = e > none ? e : none
eval box(62, 345, 52, 364)
set title "A folded cloth: near triangles missed"
set xlabel "time of refit and traversal" textcolor rgb ink
set xrange [60:6e3]
set xtics ("0.1 ms" 1e2, "0.3 ms" 3e2, "1 ms" 1e3, "3 ms" 3e3)
set yrange [5e-4:1]
set ytics ("none" none, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
set label 1 "balls around\nparticles" at 66,0.014 left textcolor rgb points font bold
set label 2 "triangles,\nthickened" at 2.8e3,0.3 center textcolor rgb faces
set label 3 "labels: radius or thickness, of a mesh width" at 65,6.5e-4 left textcolor rgb quiet font small
plot csv index 0 using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb points lw 2, \
     csv index 0 using ($1 == 0.2 || $1 == 0.3 || $1 == 0.4 || $1 == 1 ? $2 : NaN):(shown($3)):1 with labels font small textcolor rgb points offset 1.6,0.6, \
     csv index 1 using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb faces lw 1.5, \
     csv index 1 using 2:(shown($3)):1 every 2::0::4 with labels font small textcolor rgb faces offset 2,0.6
unset label

eval box(430, 706, 52, 364)
set title "Balls in contact: strain it can take"
set xlabel "time of refresh and traversal"
set xrange [9:1000]
set xtics ("20 µs" 20, "50 µs" 50, "150 µs" 1.5e2, "500 µs" 5e2)
still = 3e-4
set yrange [2e-4:0.5]
set ytics ("0" still, "0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 0.1)
strain(e) = e > still ? e : still
set label 1 "wrapped, slack\nof twice\nthe strain" at 50,0.006 left textcolor rgb points font bold
set label 2 "layered" at 560,0.02 right textcolor rgb faces
plot csv index 2 using 2:(strain($1)) with linespoints pt 7 ps 0.78 lc rgb points lw 2, \
     csv index 3 using 2:(strain($1)) with linespoints pt 7 ps 0.78 lc rgb faces lw 1.5
unset multiplot
