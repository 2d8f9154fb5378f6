# 21-world.gp - sh figures/draw/chart.sh figures/21/21-world.gp DATA.csv CHART.svg
high = 680
load "figures/draw/chart.gp"
ours = blue
array size[4] = [orange, blue, green, purple]
array name[4] = ["20 × 20", "40 × 40", "80 × 80", "160 × 160"]
set logscale xy 10
set multiplot

eval box(72, 345, 392, 646)
set title "Rooms: overlap, of a radius"
set xlabel "time of a step" textcolor rgb ink
set xrange [0.02:700]
set xtics ("0.1 ms" 0.1, "1 ms" 1, "10 ms" 10, "100 ms" 100)
none = 1e-3
shown(x) = x > none ? x : none
set yrange [4e-4:4]
set ytics ("none" none, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
printed = orange; mended = purple
set label 1 "plain, as printed" at 0.03,2.2 left textcolor rgb printed
set label 2 "plain, as mended" at 0.03,9e-2 left textcolor rgb mended
set label 4 "engine" at 60,1.6e-3 left textcolor rgb ours font bold
plot csv index 5 using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb printed lw 1.5, \
     csv index 6 using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb mended lw 1.5, \
     csv index 0 using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb ours lw 2, \
     csv index 0 using ($1 == 100 || $1 == 300 || $1 == 10000 ? $2 : NaN):(shown($3)):1 with labels font small textcolor rgb ours offset 0.6,0.8, \
     csv index 0 using ($1 == 100 || $1 == 300 || $1 == 10000 ? NaN : $2):(shown($3)):1 with labels font small textcolor rgb ours offset 2,-0.7
unset label
eval box(432, 706, 392, 646)
set title "Rooms: time of a step"
set xlabel "bodies"
set xrange [8:15000]
set xtics (10, 100, 1000, 10000)
set yrange [0.01:1000]
set ytics ("0.01 ms" 0.01, "0.1 ms" 0.1, "1 ms" 1, "10 ms" 10, "100 ms" 100)
set label 3 "in proportion" at 1.3e4,0.04 right textcolor rgb quiet font small
plot 0.0001*x with lines lc rgb quiet dt 3 lw 1, \
     csv index 5 using 1:2 with linespoints pt 7 ps 0.78 lc rgb printed lw 1.5, \
     csv index 6 using 1:2 with linespoints pt 7 ps 0.78 lc rgb mended lw 1.5, \
     csv index 0 using 1:2 with linespoints pt 7 ps 0.78 lc rgb ours lw 2
unset label

eval box(72, 345, 52, 302)
set title "Cloths; 9, 18, 36 substeps: strain"
set xlabel "time of a step"
set xrange [0.1:400]
set xtics ("0.1 ms" 0.1, "1 ms" 1, "10 ms" 10, "100 ms" 100)
set yrange [4e-4:0.2]
set ytics ("0.01 %%" 1e-4, "0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
plot for [k = 1:4] csv index k using 2:3 with linespoints pt 7 ps 0.78 lc rgb size[k] lw 1.8, \
     for [k = 1:4] csv index k using 2:3:(name[k]) every 1::1::1 with labels textcolor rgb size[k] offset 0,(k % 2 ? 1 : -1.1)

eval box(432, 706, 52, 302)
set title "Cloths: time of a step, 36 substeps"
set xlabel "particles"
set xrange [300:40000]
set xtics ("20²" 400, "40²" 1600, "80²" 6400, "160²" 25600)
set yrange [0.1:400]
set ytics ("0.1 ms" 0.1, "1 ms" 1, "10 ms" 10, "100 ms" 100)
set label 3 "in proportion" at 7e3,9 left textcolor rgb quiet font small
plot 0.0025*x with lines lc rgb quiet dt 3 lw 1, \
     for [k = 1:4] csv index k using ((10*2**k)**2):2 every 1::2::2 with points pt 7 ps 1.04 lc rgb size[k], \
     '+' using (NaN):(NaN) with points
unset multiplot
