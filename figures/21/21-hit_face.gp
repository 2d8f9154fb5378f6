# 21-hit_face.gp - sh figures/draw/chart.sh figures/21/21-hit_face.gp DATA.csv CHART.svg
high = 640
load "figures/draw/chart.gp"
tried = orange; face = blue
array shade[4] = [pale(orange, 0.4), pale(orange, 0.6), pale(orange, 0.8), orange]
set logscale xy 10
set xrange [1.5e2:6e6]
set xtics ("1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6)
set xlabel "time of a query" textcolor rgb ink
set multiplot

# The hull's own depth, to rounding, is drawn at the bottom.
none = 2e-3
eval box(72, 345, 336, 606)
set title "Error of the depth of two hulls"
set yrange [1.3e-3:4]
set ytics ("rounding" none, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
set label 1 "16 to 1024\ndirections tried" at 1.8e6,1.6 right textcolor rgb tried
set label 2 "the hit face" at 1.3e5,none*1.25 left textcolor rgb face font bold
plot for [k = 1:4] csv index k using 2:3 with linespoints pt 7 ps 0.65 lc rgb shade[k] lw 1.5, \
     csv index 0 using 2:(none) with points pt 7 ps 0.91 lc rgb face, \
     csv index 0 using 2:(none):1 with labels font small textcolor rgb face offset 0,1, \
     csv index 1 using 2:3:("12 corners") every 1::3::3 with labels font small textcolor rgb shade[1] offset 4,0.7, \
     csv index 2 using 2:3:("42") every 1::3::3 with labels font small textcolor rgb shade[2] offset 1.9,0.3, \
     csv index 3 using 2:3:("162") every 1::3::3 with labels font small textcolor rgb shade[3] offset 2.2,0.3, \
     csv index 4 using 2:3:("642") every 1::3::3 with labels font small textcolor rgb shade[4] offset 2,0.5
unset label

eval box(430, 700, 336, 606)
set title "The same, beside two true balls"
set yrange [3e-3:2]
set ytics ("1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
set label 1 "directions tried,\n642 corners" at 1.8e6,0.9 right textcolor rgb shade[4]
set label 2 "gjk and\nthe hit face,\nby corners" at 2e2,0.025 left textcolor rgb face font bold
plot csv index 4 using 2:4 with linespoints pt 7 ps 0.65 lc rgb shade[4] lw 1.5, \
     csv index 4 using 2:4:1 with labels font small textcolor rgb shade[4] offset 2.2,0.5, \
     csv index 0 using 2:4 with linespoints pt 7 ps 0.91 lc rgb face lw 2, \
     csv index 0 using 2:4:1 with labels font small textcolor rgb face offset 1.8,0.6
unset label

eval box(72, 700, 52, 232)
set title "Share of the hit faces that are not found by then"
unset logscale
set xrange [0:26]
set xtics 0,5,25
set xlabel "points of A − B asked for"
set yrange [0:1.05]
set ytics ("0" 0, "half" 0.5, "all" 1)
set label 1 "12" at 3.1,0.55 left textcolor rgb face font small
set label 2 "42" at 7.15,0.55 left textcolor rgb face font small
set label 3 "162" at 12.1,0.65 left textcolor rgb face font small
set label 4 "642 corners" at 19.1,0.65 left textcolor rgb face font small
plot for [k = 5:8] csv index k using 1:2 with steps lc rgb face lw (1 + 0.5 * (k - 5))
unset multiplot
