# 21-avbd.gp - sh figures/draw/chart.sh figures/21/21-avbd.gp DATA.csv CHART.svg
high = 636
load "figures/draw/chart.gp"
set datafile missing "-"
soft = blue; slow = purple; ramp = orange

stats csv index 0 using 2 nooutput
end = STATS_max

set multiplot
set logscale xy 10

eval box(72, 700, 372, 602)
set title "Twenty boxes: overlap after ten seconds"
set xrange [0.5:1.5*end]
set xtics (1, 2, 5, 10, 20, 50, 100)
set xlabel "time of a frame, µs" textcolor rgb ink
set yrange [0.0003:500]
set ytics ("0.01 mm" 0.01, "0.1 mm" 0.1, "1 mm" 1, "1 cm" 10, "10 cm" 100)
set label 1 "soft contacts, by substeps" at 9,30 textcolor rgb soft font bold
set label 2 "descent, β = 10" at 26,3.6 textcolor rgb slow
set label 3 "descent, β = 1000,\nby iterations" at 0.9,0.013 textcolor rgb ramp
plot csv index 0 using 2:3 with linespoints pt 7 ps 0.78 lc rgb soft lw 2, \
     csv index 1 using 2:3 with linespoints pt 6 ps 0.78 lc rgb slow lw 1.6, \
     csv index 2 using 2:3 with linespoints pt 6 ps 0.78 lc rgb ramp lw 1.6, \
     csv index 0 using ($1 < 8 ? $2 : NaN):3:1 with labels offset 0.6,0.8 font small textcolor rgb soft, \
     csv index 0 using ($1 < 8 ? NaN : $2):3:1 with labels offset -0.7,-0.9 font small textcolor rgb soft, \
     csv index 2 using 2:3:1 with labels offset -0.4,-1 font small textcolor rgb ramp
unset label

eval box(72, 340, 52, 282)
set title "Heavy on light: overlap"
set xrange [0.8:13000]
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000, "10,000" 10000)
set xlabel "upper mass, in lower masses"
set yrange [0.008:500]
set label 1 "8 substeps" at 250,60 right textcolor rgb soft font bold
set label 2 "32 substeps" at 60,0.05 textcolor rgb soft
set label 3 "10 iterations,\nβ = 10" at 1,14 textcolor rgb slow
set label 4 "10 iterations,\nβ = 1000" at 900,0.45 textcolor rgb ramp
plot csv index 3 using 1:2 with linespoints pt 7 ps 0.78 lc rgb soft lw 2, \
     csv index 3 using 1:3 with linespoints pt 6 ps 0.78 lc rgb soft lw 1.6 dt (8,5), \
     csv index 3 using 1:4 with linespoints pt 6 ps 0.78 lc rgb slow lw 1.6, \
     csv index 3 using 1:5 with linespoints pt 6 ps 0.78 lc rgb ramp lw 1.6
unset label

eval box(440, 706, 52, 282)
set title "Momentum lost in a blow"
set logscale x 2
set xrange [0.8:160]
set xtics (1, 2, 4, 8, 16, 32, 64, 128)
set xlabel "iterations"
set yrange [0.0005:20]
set ytics ("0.001 %%" 0.001, "0.01 %%" 0.01, "0.1 %%" 0.1, "1 %%" 1, "10 %%" 10)
set label 1 "descent" at 10,1.6 textcolor rgb slow
set label 2 "soft contacts lose none" at 1.1,0.001 textcolor rgb soft font bold
plot csv index 4 using 1:3 with linespoints pt 6 ps 0.78 lc rgb slow lw 1.6
unset multiplot
