# 17-joint.gp - gnuplot -e "csv='...'; png='...'" figures/17/17-joint.gp
set encoding utf8
set terminal pngcairo size 1800,700 font "DejaVu Sans,21" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
a = "#e69f00"; b = "#56b4e9"; ink = "#404040"; red = "#d55e00"; green = "#009e73"
unset border
unset tics
unset key
set size ratio -1
set style fill solid 0.22 noborder
set lmargin 0.5
set rmargin 0.5
set tmargin 2.6
set bmargin 0.5
set style arrow 2 head filled size screen 0.009,24 lc rgb ink lw 1.6
set style arrow 3 head filled size screen 0.011,22 lc rgb green lw 2.4
set style arrow 4 head filled size screen 0.009,22 lc rgb red lw 2
set multiplot layout 1,2

set xrange [-1.5:1.5]
set yrange [-0.4:1.4]
set title "two points that should be one" font "DejaVu Sans,24" textcolor rgb ink
set label 1 "A" at -1.08,0.62 center font "DejaVu Sans Bold,28" textcolor rgb "#9a6a00" front
set label 2 "B" at 1.05,0.62 center font "DejaVu Sans Bold,28" textcolor rgb "#1f6f9f" front
set label 3 "r_A" at -0.52,0.58 textcolor rgb ink front
set label 4 "r_B" at 0.46,0.5 textcolor rgb ink front
set label 5 "λ" at 0.58,0.2 textcolor rgb green front
set label 6 "– λ" at -0.66,0.38 right textcolor rgb green front
plot csv index 0 with filledcurves closed lc rgb a, csv index 1 with filledcurves closed lc rgb b, \
     csv index 0 with lines lc rgb a, csv index 1 with lines lc rgb b, \
     csv index 4 using 1:2:3:4 with vectors as 2, \
     csv index 5 every ::0::0 using 1:($2+0.07):3:4 with vectors as 3, \
     csv index 5 every ::1::1 using 1:($2-0.07):3:4 with vectors as 3, \
     csv index 2 with points pt 7 ps 1 lc rgb ink, \
     csv index 3 with points pt 7 ps 1.4 lc rgb ink
unset label

set title "from the tips to the root"
set xrange [-1.5:1.5]
set yrange [-0.6:1.35]
set label 1 "root" at 0,0.55 center textcolor rgb ink front
plot csv index 6 with filledcurves closed lc rgb b, csv index 6 with lines lc rgb b, \
     csv index 8 using 1:2:3:4 with vectors as 4, \
     csv index 7 with points pt 7 ps 1.3 lc rgb ink
unset multiplot
