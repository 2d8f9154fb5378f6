# 21-hit_face.gp - gnuplot -e "csv='...'; png='...'" figures/21/21-hit_face.gp
set encoding utf8
set terminal pngcairo size 1700,1500 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
unset key
tried = "#d55e00"; face = "#0072b2"; grey = "#606060"
bold = "DejaVu Sans Bold,22"
small = "DejaVu Sans,20"
array shade[4] = ["#f0b48a", "#e69f00", "#d55e00", "#8c3b00"]
set logscale xy 10
set xrange [1.5e2:2e6]
set xtics ("1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6)
set xlabel "time of a query" textcolor rgb "#404040"
set multiplot
set lmargin 10
set rmargin 3
set size 0.5,0.56

# The hull's own depth, to rounding, is drawn at the bottom.
none = 2e-3
set origin 0,0.44
set title "Error of the depth of the two hulls" font "DejaVu Sans,26" offset 0,-0.3
set yrange [1.3e-3:4]
set ytics ("rounding" none, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
set label 1 "16 to 1024\ndirections tried" at 1e6,1.3 right textcolor rgb tried
set label 2 "the hit face" at 1.3e5,none*1.25 left textcolor rgb face font bold
plot for [k = 1:4] csv index k using 2:3 with linespoints pt 7 ps 1 lc rgb shade[k] lw 1.5, \
     csv index 0 using 2:(none) with points pt 7 ps 1.4 lc rgb face, \
     csv index 0 using 2:(none):1 with labels font small textcolor rgb face offset 0,1, \
     csv index 1 using 2:3:("12 corners") every 1::3::3 with labels font small textcolor rgb shade[1] offset 4.5,0.7, \
     csv index 2 using 2:3:("42") every 1::3::3 with labels font small textcolor rgb shade[2] offset 1.9,0.3, \
     csv index 3 using 2:3:("162") every 1::3::3 with labels font small textcolor rgb shade[3] offset 2.2,0.3, \
     csv index 4 using 2:3:("642") every 1::3::3 with labels font small textcolor rgb shade[4] offset 2,0.5
unset label

set origin 0.5,0.44
set title "The same, beside two true balls" offset 0,-0.3
set yrange [3e-3:2]
set ytics ("1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
set label 1 "directions tried,\n642 corners" at 1.5e6,0.6 right textcolor rgb shade[4]
set label 2 "gjk and\nthe hit face,\nby corners" at 2e2,0.025 left textcolor rgb face font bold
plot csv index 4 using 2:4 with linespoints pt 7 ps 1 lc rgb shade[4] lw 1.5, \
     csv index 4 using 2:4:1 with labels font small textcolor rgb shade[4] offset 2.2,0.5, \
     csv index 0 using 2:4 with linespoints pt 7 ps 1.4 lc rgb face lw 2, \
     csv index 0 using 2:4:1 with labels font small textcolor rgb face offset 1.8,0.6
unset label

set origin 0,0
set size 1,0.44
set title "Hit faces not found by then" offset 0,-0.3
unset logscale
set xrange [0:26]
set xtics 0,5,25
set xlabel "points of A - B asked for"
set yrange [0:1.05]
set ytics ("0" 0, "half of all" 0.5, "all" 1)
set label 1 "12" at 3.1,0.55 left textcolor rgb face font small
set label 2 "42" at 7.15,0.55 left textcolor rgb face font small
set label 3 "162" at 12.1,0.65 left textcolor rgb face font small
set label 4 "642 corners" at 19.1,0.65 left textcolor rgb face font small
plot for [k = 5:8] csv index k using 1:2 with steps lc rgb face lw (1 + 0.5 * (k - 5))
unset multiplot
