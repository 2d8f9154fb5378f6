# 01-step.gp - sh figures/draw/chart.sh figures/01/01-step.gp DATA.csv CHART.svg
high = 340
load "figures/draw/chart.gp"
at(name, k) = real(system(sprintf("awk -F'\"' -v want='%s' '$2 == want { split($3, v, \" \"); print v[%d]; exit }' %s", name, k, csv)))
bx = at("before", 1); by = at("before", 2)
nx = at("now", 1); ny = at("now", 2)
sx = at("straight on", 1); sy = at("straight on", 2)
ex = at("after", 1); ey = at("after", 2)
unset border
unset tics
set multiplot layout 1,2 margins 0.02,0.985,0.05,0.89 spacing 0.05
set size ratio -1
set title "The next move is the last move, plus a Δt²"
set xrange [-0.3:2.6]
set yrange [-0.5:1.95]
set style arrow 1 head filled size 0.08,20 lw 3
set arrow 1 from bx,by to nx,ny as 1 lc rgb grey
set arrow 2 from nx,ny to sx,sy as 1 lc rgb grey dt (6,4)
set arrow 3 from sx,sy to ex,ey as 1 lc rgb orange
set label 1 "x_{before}" at bx+0.08,by-0.1 textcolor rgb blue
set label 2 "x" at nx-0.02,ny-0.15 textcolor rgb blue
set label 3 "x'" at ex+0.03,ey-0.15 textcolor rgb blue
set label 4 "the last move" at (bx+nx)/2+0.1,(by+ny)/2-0.06 left textcolor rgb quiet
set label 5 "the same again" at (nx+sx)/2-0.08,(ny+sy)/2+0.05 right textcolor rgb quiet
set label 6 "a Δt²" at ex+0.06,(sy+ey)/2 textcolor rgb orange
plot csv index 1 using 1:2 with lines lc rgb pale(blue, 0.5) lw 1.5, \
     csv index 0 using ($0 == 2 ? NaN : column(2)):3 with points pt 7 ps 1.56 lc rgb blue
unset arrow
unset label
set size noratio
set title "What x, v and a say of the curve"
set xrange [-1.4:2.75]
set yrange [-0.95:2.0]
set arrow 1 from 0,-0.75 to 0,0.64 nohead dt 3 lw 1 lc rgb grey
set label 1 "t" at 0,-0.85 center textcolor rgb quiet
set label 2 "x(t)" at 1.93,0.0 right textcolor rgb ink
set label 3 "x" at -1.3,0.74 left textcolor rgb green
set label 4 "x + v Δt" at 1.15,1.72 right textcolor rgb purple
set label 5 "x + v Δt + ½ a Δt²" at 2.7,1.2 right textcolor rgb blue
plot csv index 2 using 1:3 with lines lc rgb green lw 2, \
     csv index 2 using 1:($4 > -0.9 && $4 < 1.95 ? column(4) : NaN) with lines lc rgb purple lw 2, \
     csv index 2 using 1:($5 > -0.9 && $5 < 1.95 ? column(5) : NaN) with lines lc rgb blue lw 2, \
     csv index 2 using 1:2 with lines lc rgb ink lw 3.5, \
     "+" using (0):(sin(0.7)) every ::0::0 with points pt 7 ps 1.43 lc rgb ink
unset multiplot
