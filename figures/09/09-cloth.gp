# 09-cloth.gp - gnuplot -e "csv='...'; png='...'" figures/09/09-cloth.gp
# Blocks of the data: cube ours, cube the paper's, rope ours, rope the paper's.
set encoding utf8
set terminal pngcairo size 1800,860 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator comma
ours = "#0072b2"; paper = "#d55e00"; grey = "#606060"

# Where each curve ends: its name goes there.
most = 1e4                      # %, more than this is off the picture
strain(s) = s > most ? most : s
array fps[4]; array end[4]; array last[4]
do for [k = 0:3] {
    stats csv index k using 3 nooutput
    last[k + 1] = STATS_max
    stats csv index k using ($3 == last[k + 1] ? 1000 / $4 : NaN) nooutput
    fps[k + 1] = STATS_max
    stats csv index k using ($3 == last[k + 1] ? strain($5) : NaN) nooutput
    end[k + 1] = STATS_max
}
# A name moves by this much (characters) out of the way of each other name.
apart(a, b) = abs(log10(a / b)) < 0.16 ? (a > b ? 0.55 : -0.55) : 0

set logscale y 10
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
set xrange [18.5:52]
set xtics ("20 × 20" 20, "30 × 30" 30, "40 × 40" 40)
set xlabel "particles of the cloth" textcolor rgb "#404040" offset -3,0
unset key
set multiplot
set bmargin 3.6
set tmargin 3

set origin 0,0
set size 0.5,1
set lmargin 11
set rmargin 1
set title "Speed: frames a second" font "DejaVu Sans,26" offset 0,-0.3
set yrange [20:4000]
set ytics ("20" 20, "60" 60, "100" 100, "200" 200, "500" 500, "1,000" 1000, "2,000" 2000)
set label 9 "real time at 60 Hz" at 19,70 textcolor rgb grey font "DejaVu Sans,19"
set arrow 1 from 18.5,60 to 52,60 nohead lc rgb grey lw 0.8 dt 3
do for [k = 1:4] {
    name = k < 3 ? "on the cube" : "on the rope"
    shift = 0
    do for [o = 1:4] { if (o != k) { shift = shift + apart(fps[k], fps[o]) } }
    set label k name at last[k] + 1, fps[k] \
        offset 0, shift textcolor rgb (k % 2 ? ours : paper)
}
set label 11 "the paper’s way: dashed" at graph 0.97,0.95 right textcolor rgb paper
set label 12 "ours: solid" at graph 0.97,0.895 right textcolor rgb ours font "DejaVu Sans Bold,22"
plot csv index 1 using 3:(1000/$4) with linespoints pt 4 ps 1.1 lc rgb paper lw 1.6 dt (8,5), \
     csv index 3 using 3:(1000/$4) with linespoints pt 6 ps 1.1 lc rgb paper lw 1.6 dt (8,5), \
     csv index 0 using 3:(1000/$4) with linespoints pt 5 ps 1.1 lc rgb ours lw 2, \
     csv index 2 using 3:(1000/$4) with linespoints pt 7 ps 1.1 lc rgb ours lw 2
unset label
unset arrow

set origin 0.5,0
set title "Error: largest strain in 5 s" offset 0,-0.3
set yrange [0.04:*]
set ytics ("0.1 %%" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100, "1,000 %%" 1000, "≥ 10,000 %%" most)
do for [k = 1:4] {
    name = k < 3 ? "on the cube" : "on the rope"
    shift = 0
    do for [o = 1:4] { if (o != k) { shift = shift + apart(end[k], end[o]) } }
    set label k name at last[k] + 1, end[k] \
        offset 0, shift textcolor rgb (k % 2 ? ours : paper)
}
plot csv index 1 using 3:(strain($5)) with linespoints pt 4 ps 1.1 lc rgb paper lw 1.6 dt (8,5), \
     csv index 3 using 3:(strain($5)) with linespoints pt 6 ps 1.1 lc rgb paper lw 1.6 dt (8,5), \
     csv index 0 using 3:(strain($5)) with linespoints pt 5 ps 1.1 lc rgb ours lw 2, \
     csv index 2 using 3:(strain($5)) with linespoints pt 7 ps 1.1 lc rgb ours lw 2
unset multiplot
