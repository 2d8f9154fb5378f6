# 13-relax.gp - a drawing: sh figures/draw/chart.sh figures/13/13-relax.gp - CHART.svg
high = 240
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 240)
set xrange [0:720]
set yrange [0:240]
set style arrow 1 head filled size screen 0.011,22 lc rgb orange lw 2.4
set style arrow 2 nohead lc rgb ink lw 1.8
set style arrow 3 nohead lc rgb quiet lw 1.2 dt 2
set style arrow 4 heads filled size screen 0.008,22 lc rgb red lw 1.6
solid(n, x, y, w, c, how) = sprintf("set object %d rectangle from %g,%g to %g,%g fc rgb '%s' fs %s border lc rgb '%s'", n, x, y, x+w, y+w, c, how, c)
f = 70      # the floor
w = 66
set label 1 "push, move, relax" at 210,222 center font bold textcolor rgb ink
set arrow 1 from 18,f to 402,f arrowstyle 2
names = "overlap push move relax"
do for [i = 0:3] {
    x = 32 + 96 * i
    y = i < 2 ? f - 26 : f - 12
    eval solid(10+i, x, y, w, blue, "solid 0.22")
    if (i == 2) { eval solid(20, x, f-26, w, quiet, "empty") }
    set label 10+i word(names, i+1) at x+w/2,f-48 center textcolor rgb ink
}
set arrow 2 from 32+96+w/2,f+22 to 32+96+w/2,f+86 arrowstyle 1
set arrow 3 from 32+192+w/2,f+36 to 32+192+w/2,f+100 arrowstyle 1

# The same weight on the springs of two substeps.
set label 2 "the sag of h and of h/2" at 572,222 center font bold textcolor rgb ink
top = 150
set arrow 10 from 440,f-30 to 704,f-30 arrowstyle 2
set arrow 11 from 440,top to 704,top arrowstyle 3
set label 20 "h" at 500,f-52 center textcolor rgb ink
set label 21 "h/2" at 640,f-52 center textcolor rgb ink
eval solid(30, 470, top-48, 60, blue, "solid 0.22")
eval solid(31, 610, top-12, 60, blue, "solid 0.22")
set arrow 12 from 546,top to 546,top-48 arrowstyle 4
set arrow 13 from 686,top to 686,top-12 arrowstyle 4
set parametric
set samples 400
set trange [0:1]
turn(t) = 12 * sin(2*pi*7*t)
plot 500+turn(t),f-30+(top-48-f+30)*t with lines lc rgb purple lw 1.6, 640+turn(t),f-30+(top-12-f+30)*t with lines lc rgb purple lw 2.8
