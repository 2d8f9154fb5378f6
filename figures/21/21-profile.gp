# 21-profile.gp - gnuplot -e "csv='...'; png='...'" figures/21/21-profile.gp
set encoding utf8
set terminal pngcairo size 1800,800 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
unset key
set style fill solid 1 noborder
array phase[7] = ["pairs", "contacts", "prepare", "solve", "cloth", "move", "sleep"]
array colour[7] = ["#999999", "#56b4e9", "#f0e442", "#009e73", "#e69f00", "#0072b2", "#cc79a7"]
array title[3] = ["Room of 50: ms a step", "Cloth on a cube", "Cloth on a rope"]
set multiplot
set lmargin 6
set rmargin 1
set tmargin 3
set bmargin 3.6
set xrange [0:6]
set yrange [0:*]
set xtics 2
set xlabel "seconds of the scene" textcolor rgb "#404040"
set size 0.275,1
do for [k = 0:2] {
  set origin 0.277 * k,0
  set title title[k+1] font "DejaVu Sans,26" offset 0,-0.3
  plot for [i = 7:1:-1] csv index k using 1:(sum [j = 2:i+1] column(j)) with filledcurves x1 lc rgb colour[i]
}
set origin 0.83,0
set size 0.17,1
unset border
unset tics
unset xlabel
unset title
set lmargin 0
set xrange [0:1]
set yrange [0:1]
do for [i = 1:7] {
  set label i phase[i] at 0.22,0.2+0.1*i textcolor rgb "#404040"
  set object i rectangle from 0.02,0.17+0.1*i to 0.16,0.23+0.1*i fillcolor rgb colour[i] fillstyle solid noborder
}
plot NaN
unset multiplot
