# 07-contact.gp - sh figures/draw/chart.sh figures/07/07-contact.gp DATA.csv CHART.svg
high = 300
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
set xrange [-2.9:3.0]
set yrange [-1.95:2.0]
set lmargin 0
set rmargin 0
set tmargin 3
set bmargin 0
set style fill solid 1 noborder

stats csv index 4 every ::0::0 using 1:2 nooutput prefix "A"
stats csv index 4 every ::1::1 using 1:2 nooutput prefix "B"
stats csv index 4 every ::2::2 using 1:2 nooutput prefix "Q"
stats csv index 5 using 1:2 nooutput prefix "N"
ax = A_min_x; ay = A_min_y; bx = B_min_x; by = B_min_y; qx = Q_min_x; qy = Q_min_y
nx = N_min_x; ny = N_min_y
# Along the edge, for the rulers.
tx = ny; ty = -nx

set multiplot
set size 0.5,1
set origin 0,0
set title "A contact: two points, a normal, a depth" textcolor rgb ink
set arrow 1 from bx,by to bx+1.5*nx,by+1.5*ny lw 2 lc rgb ink head size 0.13,22 filled front
set label 1 "n" at bx+1.5*nx+0.1,by+1.5*ny+0.05 font bold textcolor rgb ink front
set arrow 2 from ax+0.42*tx,ay+0.42*ty to bx+0.42*tx,by+0.42*ty heads size 0.1,22 filled lw 1.5 lc rgb ink front
set label 2 "d" at (ax+bx)/2+0.42*tx+0.1,(ay+by)/2+0.42*ty font ":Italic" textcolor rgb ink front
set arrow 3 from ax,ay to bx,by nohead lw 1.5 dt 3 lc rgb ink front
set label 3 "p_A" at ax+0.1,ay-0.2 left textcolor rgb blue front
set label 4 "p_B" at bx-0.1,by+0.24 right textcolor rgb orange front
set label 5 "A" at -1.55,1.05 font bold textcolor rgb blue front
set label 6 "B" at -1.8,-1.45 font bold textcolor rgb orange front
set label 7 "weight 0.7" at -1.93,-1.02 textcolor rgb orange front
set label 8 "weight 0.3" at 2.12,-0.05 right textcolor rgb orange front
plot csv index 1 using 1:2 with filledcurves closed fc rgb pale(orange, 0.2), \
     csv index 0 using 1:2 with filledcurves closed fc rgb pale(blue, 0.25) fs transparent solid 0.75, \
     csv index 1 using 1:2 with lines lw 1.5 lc rgb orange, \
     csv index 0 using 1:2 with lines lw 1.5 lc rgb blue, \
     csv index 1 using 1:2 every ::0::1 with points pt 7 ps 1.17 lc rgb orange, \
     csv index 4 using 1:2 every ::0::0 with points pt 7 ps 1.17 lc rgb blue, \
     csv index 4 using 1:2 every ::1::1 with points pt 6 ps 1.17 lw 2 lc rgb orange

unset arrow
unset label
set origin 0.5,0
set title "The least move that closes it" textcolor rgb ink
part(i) = sprintf("%.0f %%", 100 * i)
set label 5 "A" at -1.55,1.05 font bold textcolor rgb blue front
set label 6 "B" at -1.8,-1.45 font bold textcolor rgb orange front
set label 9 "q" at qx+0.14,qy-0.02 font ":Italic" textcolor rgb ink front
plot csv index 3 using 1:2 with filledcurves closed fc rgb pale(orange, 0.2), \
     csv index 2 using 1:2 with filledcurves closed fc rgb pale(blue, 0.25), \
     csv index 1 using 1:2 with lines lw 1 dt 2 lc rgb pale(orange, 0.5), \
     csv index 0 using 1:2 with lines lw 1 dt 2 lc rgb pale(blue, 0.5), \
     csv index 3 using 1:2 with lines lw 1.5 lc rgb orange, \
     csv index 2 using 1:2 with lines lw 1.5 lc rgb blue, \
     csv index 6 using 1:2:3:4 every ::0::0 with vectors head size 0.12,24 filled lw 3 lc rgb blue, \
     csv index 6 using 1:2:3:4 every ::1::2 with vectors head size 0.12,24 filled lw 3 lc rgb orange, \
     csv index 3 using 1:2 every ::0::1 with points pt 7 ps 1.17 lc rgb orange, \
     csv index 4 using 1:2 every ::2::2 with points pt 7 ps 1.17 lc rgb ink, \
     csv index 6 using ($1+0.12):($2+0.1):(part($5)) every ::0::0 with labels left textcolor rgb blue, \
     csv index 6 using ($1-0.1):($2-0.5*0.28-0.1):(part($5)) every ::1::1 with labels right textcolor rgb orange, \
     csv index 6 using ($1+0.1):($2-0.14):(part($5)) every ::2::2 with labels left textcolor rgb orange
unset multiplot
