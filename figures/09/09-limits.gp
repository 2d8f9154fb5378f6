# 09-limits.gp - sh figures/draw/chart.sh figures/09/09-limits.gp DATA.csv CHART.svg
# Blocks: strain (mended; engine), speed, mass ratio, slope, rest, number.
high = 680
load "figures/draw/chart.gp"
set datafile separator comma
mended = blue; printed = orange; engine = green
set multiplot
set style line 1 lc rgb mended lw 2.4 pt 7 ps 0.78
set style line 2 lc rgb engine lw 1.6 pt 5 ps 0.78
set style line 3 lc rgb printed lw 1.6 pt 6 ps 0.72 dt (8,5)
none(y, least) = y > least ? y : least

eval box(66, 335, 508, 648)
set title "1. Cloth: strain"
set logscale y 10
set xrange [0:4]
set yrange [0.1:30]
set ytics ("0.1 %%" 0.1, "1 %%" 1, "10 %%" 10)
set xlabel "time of a step, ms (4 to 32 substeps)" textcolor rgb ink
set label 1 "as mended" at 2.2,7 textcolor rgb mended font bold
set label 2 "the engine" at 1.3,0.3 textcolor rgb engine
plot csv index 0 using 2:3 with linespoints ls 1, \
     csv index 1 using 2:3 with points ls 2
unset label

eval box(440, 706, 508, 648)
set title "2. Fast bodies: overlap, of a radius"
set logscale x 10
set xrange [0.8:130]
set yrange [0.08:400]
set ytics ("none" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100)
set xtics ("1 m/s" 1, "2" 2, "5" 5, "10" 10, "20" 20, "50" 50, "100" 100)
set xlabel "closing speed" textcolor rgb ink
set label 1 "as mended" at 1.5,30 textcolor rgb mended font bold
set label 2 "the engine" at 2.4,0.25 textcolor rgb engine
plot csv index 2 using 1:(none($2, 0.1)) with linespoints ls 1, \
     csv index 2 using 1:(none($3, 0.1)) with linespoints ls 2
unset label

eval box(66, 335, 282, 422)
set title "3. Heavy on light: the upper box moves"
set xrange [0.7:1500]
set yrange [0.001:10]
set xtics ("1 : 1" 1, "10 : 1" 10, "100 : 1" 100, "1,000 : 1" 1000)
set ytics ("1 mm" 0.001, "1 cm" 0.01, "10 cm" 0.1, "1 m" 1, "10 m" 10)
set xlabel "its mass, to that of the lower one" textcolor rgb ink
set label 1 "as mended" at 20,0.12 textcolor rgb mended font bold
set label 2 "the engine" at 60,0.0045 textcolor rgb engine
plot csv index 3 using 1:2 with linespoints ls 1, \
     csv index 3 using 1:3 with linespoints ls 2
unset label

eval box(440, 706, 282, 422)
set title "4. Creep of a box on a slope"
unset logscale
set xrange [0:0.5]
set yrange [-0.2:6]
set xtics 0,0.1
set ytics ("0" 0, "2 mm/s" 2, "4 mm/s" 4, "6 mm/s" 6)
set xlabel "slope; friction 0.5 holds them all" textcolor rgb ink
set label 1 "as mended" at 0.13,3.2 textcolor rgb mended font bold
set label 2 "the engine" at 0.3,0.55 textcolor rgb engine
plot csv index 4 using 1:2 with linespoints ls 1, \
     csv index 4 using 1:3 with linespoints ls 2
unset label

eval box(66, 335, 56, 196)
set title "5. Kinetic energy of fifty bodies"
set logscale y 10
set xrange [0:20.5]
set yrange [1e-4:2000]
set xtics 0,5
set ytics ("0.1 mJ" 1e-4, "10 mJ" 0.01, "1 J" 1, "100 J" 100)
set xlabel "seconds" textcolor rgb ink
set label 1 "as mended" at 13,6e-4 textcolor rgb mended font bold
set label 2 "the engine sleeps" at 3.4,3e-3 textcolor rgb engine
set label 3 "as printed" at 10,15 textcolor rgb printed
plot csv index 5 using 1:4 with lines ls 3, \
     csv index 5 using 1:2 with lines ls 1, \
     csv index 5 using 1:($3 > 1e-4 ? $3 : 1e-4) with lines ls 2
unset label

eval box(440, 706, 56, 196)
set title "6. Many bodies: time of a step"
set logscale x 10
set xrange [8:1300]
set yrange [0.001:100]
set xtics ("10" 10, "100" 100, "1,000" 1000)
set ytics ("1 µs" 0.001, "0.01 ms" 0.01, "0.1 ms" 0.1, "1 ms" 1, "10 ms" 10, "0.1 s" 100)
set xlabel "bodies in the room" textcolor rgb ink
set label 1 "as mended" at 13,2.5 textcolor rgb mended font bold
set label 2 "the engine" at 130,0.04 textcolor rgb engine
plot csv index 6 using 1:2 with linespoints ls 1, \
     csv index 6 using 1:3 with linespoints ls 2
unset multiplot
