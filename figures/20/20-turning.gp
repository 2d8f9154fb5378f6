# 20-turning.gp - sh figures/draw/chart.sh figures/20/20-turning.gp DATA.csv CHART.svg
high = 680
load "figures/draw/chart.gp"
set multiplot
ours = blue
theirs = orange

set logscale xy 10
set tmargin at screen 0.925
set bmargin at screen 0.61
set xrange [1.8e-4:2.5e-2]
set yrange [2e-7:1]
set xtics ("1/3840" 1.0/3840, "1/960" 1.0/960, "1/240" 1.0/240, "1/60 s" 1.0/60)
set ytics ("1 µm" 1e-6, "0.1 mm" 1e-4, "1 cm" 1e-2, "1 m" 1)
set lmargin at screen 0.095
set rmargin at screen 0.48
set title "4.  A pendulum: the error falls with dt²" offset 0,0.2
set label 1 "along the new stick" at 1.9e-3,8e-2 right textcolor rgb theirs
set label 2 "along the\nold stick" at 2.6e-3,1.5e-5 textcolor rgb ours font bold
set label 3 "target" at 1.0/69,3.6e-3 right textcolor rgb ink
set label 5 "slope 2" at 4.1e-4,1.2e-6 textcolor rgb grey
set label 4 "" at 1.0/60,3e-3 point pt 6 ps 1.69 lw 1.2 lc rgb ink
plot csv index 1 using 1:2 with linespoints pt 7 ps 0.65 lc rgb theirs lw 1.5, \
     csv index 0 using 1:2 with linespoints pt 7 ps 0.78 lc rgb ours lw 2
unset label

set lmargin at screen 0.585
set rmargin at screen 0.97
set title "6.  A double pendulum’s, too"
plot csv index 3 using 1:2 with linespoints pt 7 ps 0.65 lc rgb theirs lw 1.5, \
     csv index 2 using 1:2 with linespoints pt 7 ps 0.78 lc rgb ours lw 2
unset logscale
unset label

set tmargin at screen 0.475
set bmargin at screen 0.06
set lmargin at screen 0.095
set rmargin at screen 0.57
set xrange [0:20]
set yrange [-6.4:6.4]
set xtics 0,5,20
set xtics add ("20 s" 20)
set ytics ("5 rad/s" 5, "0" 0, "−5" -5)
set title "11.  A box about its middle axis flips on time"
set label 1 "exact" at 0.5,5.75 textcolor rgb quiet
set label 2 "old gradient, 8 substeps" at 9.6,5.75 center textcolor rgb ours font bold
set label 3 "new gradient" at 9.7,-4.1 textcolor rgb theirs
plot csv index 4 using 1:2 with lines lc rgb pale(grey, 0.4) lw 7, \
     csv index 6 using 1:2 with lines lc rgb theirs lw 1.5, \
     csv index 5 using 1:2 with lines lc rgb ours lw 1.5
unset label

set lmargin at screen 0.625
set rmargin at screen 0.985
set size ratio -1
set xrange [-1.03:1.03]
set yrange [-1.03:1.03]
unset border
unset tics
unset title
set label 6 "12.  A top keeps its circle" at screen 0.805,0.517 center font bold textcolor rgb ink
set object 1 circle at 0,0 size 1 fc rgb rule fs empty border rgb pale(grey, 0.4) lw 1.5
set label 1 "L" at 0.05,0.06 textcolor rgb quiet font ":Italic"
set label 2 "" at 0,0 point pt 7 ps 0.78 lc rgb quiet
set label 3 "old gradient" at 0,0.66 center textcolor rgb ours font bold
set label 4 "new gradient" at 0,-1.08 center textcolor rgb theirs
set label 5 "2 substeps, 10 s" at 0,-0.2 center textcolor rgb quiet
plot csv index 8 using 1:2 with lines lc rgb theirs lw 1.2, \
     csv index 7 using 1:2 with lines lc rgb ours lw 2.2
unset multiplot
