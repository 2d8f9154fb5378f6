# piles.gp - sh figures/draw/chart.sh figures/peers/piles.gp DATA.csv CHART.svg
high = 660
load "figures/draw/chart.gp"
array color[4] = [blue, orange, green, purple]
array mark[4] = [7, 5, 13, 9]
array thick[4] = [2.6, 1.6, 1.6, 1.6]
array up[4] = [0.8, -0.8, 0.8, 0.8]
set logscale xy 10
set multiplot
set xlabel "time of a step" textcolor rgb ink
set label 1 "● tumble, by substeps" at screen 0.03,0.98 font bold textcolor rgb color[1]
set label 2 "■ ODE, by iterations" at screen 0.29,0.98 textcolor rgb color[2]
set label 3 "♦ ODE, dWorldStep" at screen 0.53,0.98 textcolor rgb color[3]
set label 4 "▲ Bullet, by iterations" at screen 0.755,0.98 textcolor rgb color[4]

# Where it lies on the ground how far it rolled says nothing.
fallen = 3000
way(x) = x > 1000 ? fallen : x < 1 ? 1 : x
named(x) = x > 1000 ? NaN : way(x)
# With 1 and 2 substeps the engine takes as many as with 4: one label for all.
single(m, n) = m == 1 && (n == 1 || n == 2) ? NaN : 1
eval box(66, 335, 370, 584)
set title "Pyramid of 210: farthest way in 20 s"
set xrange [0.1:40]
set xtics ("0.1 ms" 0.1, "1 ms" 1, "10 ms" 10)
set yrange [1:6000]
set ytics ("1 mm" 1, "1 cm" 10, "10 cm" 100, "1 m" 1e3, "fallen" fallen)
plot for [m = 1:4] csv index m - 1 using 2:(way($4)) with linespoints pt mark[m] ps 0.85 lc rgb color[m] lw thick[m], \
     for [m = 1:4] csv index m - 1 using 2:(single(m, $1) * named($4)):1 with labels font small textcolor rgb color[m] offset 0.9,up[m]
unset label

eval box(436, 690, 370, 584)
set title "Tower of 20: farthest way in 20 s"
set xrange [0.01:10]
set xtics ("0.01 ms" 0.01, "0.1 ms" 0.1, "1 ms" 1, "10 ms" 10)
plot for [m = 1:4] csv index m + 3 using 2:(way($4)) with linespoints pt mark[m] ps 0.85 lc rgb color[m] lw thick[m], \
     for [m = 1:4] csv index m + 3 using 2:(single(m, $1) * named($4)):1 with labels font small textcolor rgb color[m] offset 0.9,up[m]

eval box(66, 335, 52, 278)
set title "1,000 boxes dropped: deepest overlap"
set xrange [1:100]
set xtics ("1 ms" 1, "3 ms" 3, "10 ms" 10, "30 ms" 30, "100 ms" 100)
set yrange [8:1800]
set ytics ("1 cm" 10, "3 cm" 30, "10 cm" 100, "30 cm" 300, "1 m" 1e3)
plot for [m = 1:4] csv index m + 7 using 2:3 with linespoints pt mark[m] ps 0.85 lc rgb color[m] lw thick[m], \
     for [m = 2:4] csv index m + 7 using (m == 4 && ($1 == 10 || $1 == 20) ? NaN : $2):3:1 with labels font small textcolor rgb color[m] offset 0.9,up[m], \
     csv index 1 + 7 using ($1 == 16 ? NaN : $2):3:1 with labels font small textcolor rgb color[1] offset -1.6,0, \
     csv index 1 + 7 using ($1 == 16 ? $2 : NaN):3:1 with labels font small textcolor rgb color[1] offset 1.7,0

eval box(436, 690, 52, 278)
set title "200 boxes thrown: deepest overlap"
set xrange [0.15:30]
set xtics ("0.3 ms" 0.3, "1 ms" 1, "3 ms" 3, "10 ms" 10, "30 ms" 30)
plot for [m = 1:4] csv index m + 11 using 2:3 with linespoints pt mark[m] ps 0.85 lc rgb color[m] lw thick[m], \
     for [m = 2:4] csv index m + 11 using (m == 4 && $1 == 10 ? NaN : $2):3:1 with labels font small textcolor rgb color[m] offset 0.9,up[m], \
     csv index 1 + 11 using ($1 == 16 || $1 == 2 ? NaN : $2):3:1 with labels font small textcolor rgb color[1] offset -1.6,0, \
     csv index 1 + 11 using ($1 == 16 ? $2 : NaN):3:1 with labels font small textcolor rgb color[1] offset 1.7,0
unset multiplot
