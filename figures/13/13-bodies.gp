# 13-bodies.gp - sh figures/draw/chart.sh figures/13/13-bodies.gp DATA.csv CHART.svg
high = 346
load "figures/draw/chart.gp"
engine = blue; cold = orange; mended = green; printed = orange

# Labels stand at their points, wherever a machine's clock puts these.
array X[3]; array Y[3]; array J[3]
do for [k=1:3] {
    do for [c=2:4] {
        stats csv index k-1 using c every ::0::0 nooutput
        if (c == 2) { X[k] = STATS_max }
        if (c == 3) { Y[k] = STATS_max }
        if (c == 4) { J[k] = STATS_max }
    }
}
stats csv index 2 using 2 nooutput
end = STATS_max

set multiplot
set logscale xy 10
set xrange [0.6*X[1]:1.5*end]
set xtics (0.05, 0.1, 0.2, 0.5, 1, 2)
set xlabel "time of a step, ms" textcolor rgb ink

eval box(66, 345, 52, 312)
set title "Fifty bodies: overlap, of a radius"
set yrange [0.1:150]
set ytics ("0.1 %%" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100)
set label 1 "chapter 09,\nas printed" at 1.25*X[2],Y[2] left textcolor rgb printed
set label 2 "chapter 09,\nas mended" at 1.75*X[3],1.3*Y[3] left textcolor rgb mended
set label 3 "engine" at X[1],2*Y[1] left textcolor rgb engine font bold
plot csv index 1 using 2:3 with points pt 9 ps 1.43 lc rgb printed, \
     csv index 2 using 2:3 with linespoints pt 6 ps 0.85 lc rgb mended lw 1.6, \
     csv index 2 using 2:3:1 with labels font small textcolor rgb mended offset 1.4,0.5, \
     csv index 0 using 2:3 with linespoints pt 7 ps 0.85 lc rgb engine lw 2, \
     csv index 0 using 2:3:1 with labels font small textcolor rgb engine offset 0,-1.1
unset label

eval box(440, 706, 52, 312)
set title "Joules left after six seconds"
set yrange [1e-24:300]
set ytics ("10^{-24}" 1e-24, "10^{-18}" 1e-18, "10^{-12}" 1e-12, "10^{-6}" 1e-6, "1" 1)
set label 1 "as printed" at 1.3*X[2],J[2] left textcolor rgb printed
set label 2 "as mended" at 1.2*X[3],2e-4 left textcolor rgb mended
set label 3 "engine" at 1.9*X[1],1e-9 left textcolor rgb engine font bold
plot csv index 1 using 2:4 with points pt 9 ps 1.43 lc rgb printed, \
     csv index 2 using 2:4 with linespoints pt 6 ps 0.85 lc rgb mended lw 1.6, \
     csv index 0 using 2:4 with linespoints pt 7 ps 0.85 lc rgb engine lw 2, \
     csv index 0 using 2:4:1 with labels font small textcolor rgb engine offset -1.4,0.4
unset multiplot
