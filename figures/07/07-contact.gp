# 07-contact.gp - gnuplot -e "csv='...'; png='...'" figures/07/07-contact.gp
set encoding utf8
set terminal pngcairo size 1600,660 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
unset border
unset tics
unset key
set size ratio -1
set xrange [-2.9:3.0]
set yrange [-1.95:2.0]
set lmargin 0
set rmargin 0
set tmargin 3
set bmargin 0
set style fill solid 1 noborder
blue = "#0072b2"; red = "#d55e00"; green = "#009e73"; ink = "#404040"
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
set title "A contact: two points, a normal, a depth" font "DejaVu Sans,24" textcolor rgb ink
set arrow 1 from bx,by to bx+1.5*nx,by+1.5*ny lw 2 lc rgb ink head size 0.13,22 filled front
set label 1 "n" at bx+1.5*nx+0.1,by+1.5*ny+0.05 font "DejaVu Sans Bold,22" textcolor rgb ink front
set arrow 2 from ax+0.42*tx,ay+0.42*ty to bx+0.42*tx,by+0.42*ty heads size 0.1,22 filled lw 1.5 lc rgb ink front
set label 2 "d" at (ax+bx)/2+0.42*tx+0.1,(ay+by)/2+0.42*ty font "DejaVu Sans Italic,22" textcolor rgb ink front
set arrow 3 from ax,ay to bx,by nohead lw 1.5 dt 3 lc rgb ink front
set label 3 "p_A" at ax+0.1,ay-0.2 left textcolor rgb blue front
set label 4 "p_B" at bx-0.1,by+0.24 right textcolor rgb red front
set label 5 "A" at -1.55,1.05 font "DejaVu Sans Bold,24" textcolor rgb blue front
set label 6 "B" at -1.8,-1.45 font "DejaVu Sans Bold,24" textcolor rgb red front
set label 7 "weight 0.7" at -1.93,-1.02 textcolor rgb red front
set label 8 "weight 0.3" at 2.12,-0.05 right textcolor rgb red front
plot csv index 1 using 1:2 with filledcurves closed fc rgb "#f6dccb", \
     csv index 0 using 1:2 with filledcurves closed fc rgb "#bcd9ea" fs transparent solid 0.75, \
     csv index 1 using 1:2 with lines lw 1.5 lc rgb red, \
     csv index 0 using 1:2 with lines lw 1.5 lc rgb blue, \
     csv index 1 using 1:2 every ::0::1 with points pt 7 ps 1.8 lc rgb red, \
     csv index 4 using 1:2 every ::0::0 with points pt 7 ps 1.8 lc rgb blue, \
     csv index 4 using 1:2 every ::1::1 with points pt 6 ps 1.8 lw 2 lc rgb red

unset arrow
unset label
set origin 0.5,0
set title "The least move that closes it" font "DejaVu Sans,24" textcolor rgb ink
part(i) = sprintf("%.0f %%", 100 * i)
set label 5 "A" at -1.55,1.05 font "DejaVu Sans Bold,24" textcolor rgb blue front
set label 6 "B" at -1.8,-1.45 font "DejaVu Sans Bold,24" textcolor rgb red front
set label 9 "q" at qx+0.14,qy-0.02 font "DejaVu Sans Italic,22" textcolor rgb ink front
plot csv index 3 using 1:2 with filledcurves closed fc rgb "#f6dccb", \
     csv index 2 using 1:2 with filledcurves closed fc rgb "#bcd9ea", \
     csv index 1 using 1:2 with lines lw 1 dt 2 lc rgb "#c9a58f", \
     csv index 0 using 1:2 with lines lw 1 dt 2 lc rgb "#8fb0c4", \
     csv index 3 using 1:2 with lines lw 1.5 lc rgb red, \
     csv index 2 using 1:2 with lines lw 1.5 lc rgb blue, \
     csv index 6 using 1:2:3:4 every ::0::0 with vectors head size 0.12,24 filled lw 3 lc rgb blue, \
     csv index 6 using 1:2:3:4 every ::1::2 with vectors head size 0.12,24 filled lw 3 lc rgb red, \
     csv index 3 using 1:2 every ::0::1 with points pt 7 ps 1.8 lc rgb red, \
     csv index 4 using 1:2 every ::2::2 with points pt 7 ps 1.8 lc rgb ink, \
     csv index 6 using ($1+0.12):($2+0.1):(part($5)) every ::0::0 with labels left textcolor rgb blue, \
     csv index 6 using ($1-0.1):($2-0.5*0.28-0.1):(part($5)) every ::1::1 with labels right textcolor rgb red, \
     csv index 6 using ($1+0.1):($2-0.14):(part($5)) every ::2::2 with labels left textcolor rgb red
unset multiplot
