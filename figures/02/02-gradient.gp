# 02-gradient.gp - gnuplot -e "csv='...'; png='...'" figures/02/02-gradient.gp
set encoding utf8
set terminal pngcairo size 1400,800 font "DejaVu Sans,23" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
at(name, k) = real(system(sprintf("awk -F'\"' -v want='%s' '$2 == want { split($3, v, \" \"); print v[%d]; exit }' %s", name, k, csv)))
bx = at("before", 1); by = at("before", 2)
nx = at("now", 1); ny = at("now", 2)
sx = at("straight on", 1); sy = at("straight on", 2)
px = at("PBD", 1); py = at("PBD", 2)
hx = at("SHAKE", 1); hy = at("SHAKE", 2)
unset border
unset tics
unset key
set size ratio -1
set lmargin 1
set rmargin 1
set tmargin 1
set bmargin 1
set xrange [-0.75:1.68]
set yrange [-0.13:1.2]
set style arrow 1 head filled size 0.045,20 lw 3
set parametric
set trange [0.5:2.05]
set arrow 1 from bx,by to nx,ny as 1 lc rgb "#a0a0a0"
set arrow 2 from nx,ny to sx,sy as 1 lc rgb "#a0a0a0" dt (6,4)
set arrow 3 from sx,sy to px,py as 1 lc rgb "#0072b2"
set arrow 4 from sx,sy to hx,hy as 1 lc rgb "#d55e00"
set arrow 5 from 0,0 to bx,by nohead lw 2 lc rgb "#d0d0d0"
set arrow 6 from 0,0 to nx,ny nohead lw 4 lc rgb "#404040"
set arrow 7 from 0,0 to px,py nohead lw 4 lc rgb "#56b4e9"
set arrow 8 from 0,0 to hx,hy nohead lw 4 lc rgb "#e69f00"
set label 1 "one step earlier" at bx-0.03,by+0.05 right textcolor rgb "#909090"
set label 2 "before the step" at nx+0.02,ny+0.08 center textcolor rgb "#404040"
set label 3 "Verlet: straight on" at sx+0.03,sy+0.06 left textcolor rgb "#707070"
set label 4 "PBD: along the stick\nas it lies after the step" at 0.83,0.955 left textcolor rgb "#0072b2"
set label 5 "SHAKE: along the stick\nas it lay before the step" at 0.79,0.71 left textcolor rgb "#d55e00"
set label 6 "pinned" at 0.04,-0.05 left textcolor rgb "#404040"
plot cos(t), sin(t) with lines dt 3 lw 1.2 lc rgb "#808080", \
     csv using 2:3 with points pt 7 ps 1.6 lc rgb "#404040", \
     "+" using (0):(0) every ::0::0 with points pt 7 ps 2.4 lc rgb "#404040"
