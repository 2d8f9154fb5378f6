# 02-gradient.gp - sh figures/draw/chart.sh figures/02/02-gradient.gp DATA.csv CHART.svg
high = 410
load "figures/draw/chart.gp"
at(name, k) = real(system(sprintf("awk -F'\"' -v want='%s' '$2 == want { split($3, v, \" \"); print v[%d]; exit }' %s", name, k, csv)))
bx = at("before", 1); by = at("before", 2)
nx = at("now", 1); ny = at("now", 2)
sx = at("straight on", 1); sy = at("straight on", 2)
px = at("PBD", 1); py = at("PBD", 2)
hx = at("SHAKE", 1); hy = at("SHAKE", 2)
unset border
unset tics
set size ratio -1
set lmargin 1
set rmargin 1
set tmargin 1
set bmargin 1
set xrange [-0.75:1.55]
set yrange [-0.13:1.2]
set style arrow 1 head filled size 0.045,20 lw 3
set parametric
set trange [0.5:2.05]
set arrow 1 from bx,by to nx,ny as 1 lc rgb grey
set arrow 2 from nx,ny to sx,sy as 1 lc rgb grey dt (6,4)
set arrow 3 from sx,sy to px,py as 1 lc rgb blue
set arrow 4 from sx,sy to hx,hy as 1 lc rgb orange
set arrow 5 from 0,0 to bx,by nohead lw 2 lc rgb pale(grey, 0.4)
set arrow 6 from 0,0 to nx,ny nohead lw 4 lc rgb ink
set arrow 7 from 0,0 to px,py nohead lw 4 lc rgb pale(blue, 0.5)
set arrow 8 from 0,0 to hx,hy nohead lw 4 lc rgb orange
set label 1 "one step\nearlier" at bx-0.05,by+0.06 right textcolor rgb grey
set label 2 "before the step" at nx-0.02,ny+0.08 center textcolor rgb ink
set label 3 "Verlet: straight on" at sx-0.06,sy+0.17 left textcolor rgb quiet
set label 4 "PBD: along\nthe stick as it lies\nafter the step" at 0.93,0.99 left textcolor rgb blue
set label 5 "SHAKE: along\nthe stick as it lay\nbefore the step" at 0.86,0.6 left textcolor rgb orange
set label 6 "pinned" at 0.04,-0.05 left textcolor rgb ink
plot cos(t), sin(t) with lines dt 3 lw 1.2 lc rgb grey, \
     csv using 2:3 with points pt 7 ps 1.04 lc rgb ink, \
     "+" using (0):(0) every ::0::0 with points pt 7 ps 1.56 lc rgb ink
