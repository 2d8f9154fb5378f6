# 02-stick.gp - gnuplot -e "csv='...'; png='...'" figures/02/02-stick.gp
set encoding utf8
set terminal pngcairo size 1400,800 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 2 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
unset xtics
unset key
set lmargin 26
set rmargin 22
set yrange [3.6:-0.6]
set xrange [0:*]
set ytics scale 0 ("bare loop" 0, "PBD,\nexact root" 1, "PBD,\napproximate root" 2, "SHAKE" 3)
set title "The time of one relaxation: a rope, stick after stick, and even sticks first" font "DejaVu Sans,24" offset -4,0
set style fill solid 1 noborder
w = 0.17
plot csv using (0):0:(0):4:($0-0.19-w):($0-0.19+w) with boxxyerror lc rgb "#e69f00", \
     csv using (0):0:(0):5:($0+0.19-w):($0+0.19+w) with boxxyerror lc rgb "#0072b2", \
     csv using 4:($0-0.19):(sprintf("%.1f ns%s", column(2), $0==0 ? ",\nstick after stick" : "")) with labels left offset 0.5,0 textcolor rgb "#b07800", \
     csv using 5:($0+0.19):(sprintf("%.1f ns%s", column(3), $0==0 ? ", even sticks first" : "")) with labels left offset 0.5,0 textcolor rgb "#0072b2"
