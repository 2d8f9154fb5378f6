# 13-avbd.gp - sh figures/draw/chart.sh figures/13/13-avbd.gp DATA.csv CHART.svg
high = 680
load "figures/draw/chart.gp"
set datafile missing "-"
soft = blue; slow = purple; ramp = orange

# Labels stand at their points, wherever a machine's clock puts these.
array X[3]; array Y[3]
do for [k=1:3] {
    at = k == 1 ? 1 : k == 2 ? 6 : 1
    stats csv index k-1 using 2 every ::at::at nooutput
    X[k] = STATS_max
    stats csv index k-1 using 3 every ::at::at nooutput
    Y[k] = STATS_max
}
stats csv index 0 using 2 nooutput
end = STATS_max

set multiplot
set bmargin 3.6
set tmargin 3
set logscale xy 10

set origin 0,0.5
set size 1,0.5
set lmargin 11
set rmargin 2
set title "Twenty boxes: overlap after ten seconds"
set xrange [0.5:1.5*end]
set xtics (1, 2, 5, 10, 20, 50, 100)
set xlabel "microseconds a frame" textcolor rgb ink
set yrange [0.001:500]
set ytics ("0.01 mm" 0.01, "0.1 mm" 0.1, "1 mm" 1, "1 cm" 10, "10 cm" 100)
set label 1 "soft contacts, by substeps" at 1.35*X[1],2*Y[1] textcolor rgb soft font bold
set label 2 "descent, β = 10" at 1.1*X[2],1.3*Y[2] textcolor rgb slow
set label 3 "descent, β = 1000,\nby iterations" at 0.45*X[3],0.12*Y[3] textcolor rgb ramp
plot csv index 0 using 2:3 with linespoints pt 7 ps 0.78 lc rgb soft lw 2, \
     csv index 1 using 2:3 with linespoints pt 6 ps 0.78 lc rgb slow lw 1.6, \
     csv index 2 using 2:3 with linespoints pt 6 ps 0.78 lc rgb ramp lw 1.6, \
     csv index 0 using 2:3:1 with labels offset 0.4,1 font small textcolor rgb soft, \
     csv index 2 using 2:3:1 with labels offset -0.4,-1 font small textcolor rgb ramp
unset label

set origin 0,0
set size 0.5,0.5
set title "Heavy on light: overlap"
set xrange [0.8:13000]
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000, "10,000" 10000)
set xlabel "mass of the upper box, of the lower"
set yrange [0.008:500]
set label 1 "8 substeps" at 220,60 right textcolor rgb soft font bold
set label 2 "32 substeps" at 1,0.13 textcolor rgb soft
set label 3 "10 iterations,\nβ = 10" at 1.2,6.5 textcolor rgb slow
set label 4 "10 iterations,\nβ = 1000" at 1100,1.1 textcolor rgb ramp
plot csv index 3 using 1:2 with linespoints pt 7 ps 0.78 lc rgb soft lw 2, \
     csv index 3 using 1:3 with linespoints pt 6 ps 0.78 lc rgb soft lw 1.6 dt (8,5), \
     csv index 3 using 1:4 with linespoints pt 6 ps 0.78 lc rgb slow lw 1.6, \
     csv index 3 using 1:5 with linespoints pt 6 ps 0.78 lc rgb ramp lw 1.6
unset label

set origin 0.5,0
set title "A box runs into nine: momentum lost"
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
