# 05-rules.gp - gnuplot -e "csv='...'; png='...'" figures/05/05-rules.gp
set encoding utf8
set terminal pngcairo size 1400,760 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator comma
unset key
set style fill solid 0.9 noborder
set lmargin at screen 0.40
set rmargin at screen 0.96
set tmargin at screen 0.84
set bmargin at screen 0.02
set border 2 lc rgb "#808080" lw 0.7
unset xtics
set xrange [0:720]
set yrange [9.6:-0.6]
set ytics nomirror scale 0 textcolor rgb "#404040"
set label 3 "Wrong answers without one rule, of some 7,000 hard pairs" at screen 0.02,0.95 textcolor rgb "#404040" font "DejaVu Sans,26"
set label 1 "depth wrong" at screen 0.40,0.88 textcolor rgb "#d55e00" font "DejaVu Sans Bold,22"
set label 2 "depth right, normal or points off" at screen 0.58,0.88 textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
plot csv every ::1 using (0.5*($4+0)):0:(0.5*($4+0)):(0.36):ytic(1) with boxxyerror lc rgb "#d55e00", \
     csv every ::1 using ($4+0.5*$6):0:(0.5*$6):(0.36) with boxxyerror lc rgb "#0072b2", \
     csv every ::1 using ($4+$6+8):0:(sprintf("%d", $4+$6)) with labels left textcolor rgb "#404040"
