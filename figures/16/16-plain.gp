# 16-plain.gp - sh figures/draw/chart.sh figures/16/16-plain.gp DATA.csv CHART.svg
high = 460
load "figures/draw/chart.gp"
set multiplot

# The drawing: two edges, what they sweep over, and half of it.
unset border; unset tics; unset grid
eval box(0, 720, 270, 460)
set xrange [0:720]
set yrange [0:190]
set style arrow 1 nohead lc rgb blue lw 3
set style arrow 2 nohead lc rgb orange lw 3
set style arrow 3 head filled size screen 0.009,22 lc rgb quiet lw 1.2
sweep(n, x, y, u, v, p, q, r, s, c) = sprintf("set object %d polygon from %g,%g to %g,%g to %g,%g to %g,%g to %g,%g fc rgb '%s' fs transparent solid 0.18 border lc rgb '%s'", n, x,y, u,v, p,q, r,s, x,y, c, c)
set label 1 "apart: they never meet" at 120,178 center font bold textcolor rgb ink
set label 2 "not apart: who knows?" at 360,178 center font bold textcolor rgb ink
set label 3 "half as far: apart" at 610,178 center font bold textcolor rgb ink
eval sweep(1, 40,110, 60,150, 150,155, 130,115, blue)
eval sweep(2, 60,40, 85,20, 200,70, 175,90, orange)
set arrow 1 from 40,110 to 60,150 arrowstyle 1
set arrow 2 from 60,40 to 85,20 arrowstyle 2
set arrow 3 from 50,130 to 138,134 arrowstyle 3
set arrow 4 from 72,30 to 186,79 arrowstyle 3
eval sweep(3, 290,110, 310,150, 410,95, 390,55, blue)
eval sweep(4, 300,40, 325,20, 440,90, 415,110, orange)
set arrow 5 from 290,110 to 310,150 arrowstyle 1
set arrow 6 from 300,40 to 325,20 arrowstyle 2
set arrow 7 from 300,130 to 398,76 arrowstyle 3
set arrow 8 from 312,30 to 426,99 arrowstyle 3
eval sweep(5, 540,110, 560,150, 610,122, 590,82, blue)
eval sweep(6, 550,40, 575,20, 632,55, 607,75, orange)
set arrow 9 from 540,110 to 560,150 arrowstyle 1
set arrow 10 from 550,40 to 575,20 arrowstyle 2
set arrow 11 from 550,130 to 598,103 arrowstyle 3
set arrow 12 from 562,30 to 618,64 arrowstyle 3
plot NaN notitle
unset object; unset arrow; unset label
eval axes

eval box(80, 330, 52, 224)
set title "What is kept of the moves?"
set xlabel "asked for, in gaps between the sheets"
set logscale x 2
set xrange [0.05:20]
set yrange [0:1.1]
set xtics ("1/16" 0.0625, "1/4" 0.25, "1" 1, "4" 4, "16" 16)
set ytics ("0" 0, "50 %%" 0.5, "100 %%" 1)
set label 1 "plain form" at 1.6,0.72 textcolor rgb green font bold
set label 2 "the library" at 0.14,0.2 textcolor rgb blue font bold
plot csv index 0 using 1:2 with linespoints pt 7 ps 0.52 lc rgb green lw 2, \
     csv index 0 using 1:3 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
unset label

eval box(440, 690, 52, 224)
set title "How long does a frame take?"
set xlabel "vertices of two sheets"
set logscale x 2
set logscale y 10
set xrange [26:600]
set yrange [0.001:2000]
set xtics ("32" 32, "98" 98, "200" 200, "512" 512)
set ytics ("1 µs" 1e-3, "100 µs" 0.1, "10 ms" 10, "1 s" 1000)
set label 1 "plain form" at 36,200 textcolor rgb green font bold
set label 2 "the library, at first" at 110,0.2 textcolor rgb purple
set label 3 "a frame later" at 110,0.0042 textcolor rgb blue font bold
plot csv index 1 using 1:2 with linespoints pt 7 ps 0.52 lc rgb green lw 2, \
     csv index 1 using 1:3 with linespoints pt 7 ps 0.52 lc rgb purple lw 2, \
     csv index 1 using 1:4 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
