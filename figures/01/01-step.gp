# 01-step.gp - gnuplot -e "csv='...'; png='...'" figures/01/01-step.gp
set encoding utf8
set terminal pngcairo size 1500,700 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
at(name, k) = real(system(sprintf("awk -F'\"' -v want='%s' '$2 == want { split($3, v, \" \"); print v[%d]; exit }' %s", name, k, csv)))
bx = at("before", 1); by = at("before", 2)
nx = at("now", 1); ny = at("now", 2)
sx = at("straight on", 1); sy = at("straight on", 2)
ex = at("after", 1); ey = at("after", 2)
unset border
unset tics
unset key
set multiplot layout 1,2 margins 0.02,0.985,0.05,0.89 spacing 0.05
set size ratio -1
set title "The next move is the last move, plus a Δt²" font "DejaVu Sans,23"
set xrange [-0.3:2.6]
set yrange [-0.5:1.95]
set style arrow 1 head filled size 0.08,20 lw 3
set arrow 1 from bx,by to nx,ny as 1 lc rgb "#808080"
set arrow 2 from nx,ny to sx,sy as 1 lc rgb "#808080" dt (6,4)
set arrow 3 from sx,sy to ex,ey as 1 lc rgb "#d55e00"
set label 1 "x_{before}" at bx+0.08,by-0.1 textcolor rgb "#0072b2"
set label 2 "x" at nx-0.02,ny-0.15 textcolor rgb "#0072b2"
set label 3 "x'" at ex+0.03,ey-0.15 textcolor rgb "#0072b2"
set label 4 "the last move" at (bx+nx)/2+0.1,(by+ny)/2-0.06 left textcolor rgb "#606060"
set label 5 "the same again" at (nx+sx)/2-0.08,(ny+sy)/2+0.05 right textcolor rgb "#606060"
set label 6 "a Δt²" at ex+0.06,(sy+ey)/2 textcolor rgb "#d55e00"
plot csv index 1 using 1:2 with lines lc rgb "#56b4e9" lw 1.5, \
     csv index 0 using ($0 == 2 ? NaN : column(2)):3 with points pt 7 ps 2.4 lc rgb "#0072b2"
unset arrow
unset label
set size noratio
set title "What position, velocity and acceleration say" font "DejaVu Sans,23"
set xrange [-1.4:2.75]
set yrange [-0.95:2.0]
set arrow 1 from 0,-0.75 to 0,0.64 nohead dt 3 lw 1 lc rgb "#808080"
set label 1 "t" at 0,-0.85 center textcolor rgb "#606060"
set label 2 "x(t)" at 1.93,0.0 right textcolor rgb "#000000"
set label 3 "x" at -1.3,0.74 left textcolor rgb "#009e73"
set label 4 "x + v Δt" at 1.3,1.72 right textcolor rgb "#e69f00"
set label 5 "x + v Δt + ½ a Δt²" at 2.7,1.2 right textcolor rgb "#0072b2"
plot csv index 2 using 1:3 with lines lc rgb "#009e73" lw 2, \
     csv index 2 using 1:($4 > -0.9 && $4 < 1.95 ? column(4) : NaN) with lines lc rgb "#e69f00" lw 2, \
     csv index 2 using 1:($5 > -0.9 && $5 < 1.95 ? column(5) : NaN) with lines lc rgb "#0072b2" lw 2, \
     csv index 2 using 1:2 with lines lc rgb "#000000" lw 3.5, \
     "+" using (0):(sin(0.7)) every ::0::0 with points pt 7 ps 2.2 lc rgb "#000000"
unset multiplot
