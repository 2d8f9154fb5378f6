# 03-half.gp - sh figures/draw/chart.sh figures/03/03-half.gp DATA.csv CHART.svg
high = 340
load "figures/draw/chart.gp"
unset border
unset tics
set multiplot
set size ratio -1

set lmargin at screen 0.01
set rmargin at screen 0.52
set bmargin at screen 0.02
set tmargin at screen 0.88
set xrange [-0.6:4.0]
set yrange [-0.5:3.1]
set title "Every edge is cut into two half-edges" textcolor rgb ink
set style arrow 1 head filled size 0.13,22 lw 2.2 lc rgb blue
set style arrow 2 head filled size 0.13,22 lw 3.4 lc rgb orange
set style arrow 3 head filled size 0.13,22 lw 3.4 lc rgb green
set label 1 "h" at 1.98,1.18 center textcolor rgb orange font bold
set label 2 "twin" at 1.52,1.72 center textcolor rgb green rotate by 38
set label 3 "next" at 1.58,0.38 center textcolor rgb purple
set label 4 "face 0" at 2.3,0.78 center textcolor rgb quiet
set label 5 "face 1" at 1.05,1.9 center textcolor rgb quiet
set label 6 "2: origin of h" at 3.75,2.86 right textcolor rgb orange
# The data say which is which: half-edges 4 (from 2 to 0), 5 (its twin), 0.
plot csv index 0 using 1:2:($3-$1):($4-$2) with vectors nohead lw 1.2 lc rgb grey, \
     csv index 1 using ($5==4||$5==5||$5==0 ? NaN : $1):2:3:4 with vectors as 1, \
     csv index 1 using ($5==4 ? $1 : NaN):2:3:4 with vectors as 2, \
     csv index 1 using ($5==5 ? $1 : NaN):2:3:4 with vectors as 3, \
     csv index 1 using ($5==0 ? $1 : NaN):2:3:4 with vectors head filled size 0.13,22 lw 3.4 lc rgb purple, \
     csv index 2 using 1:2 with points pt 7 ps 1.69 lc rgb ink, \
     csv index 2 using ($1 + ($3==0||$3==3 ? -0.22 : 0.22)):($2 + ($3<2 ? -0.2 : 0.16)):($3==2 ? "" : sprintf("%d", $3)) with labels textcolor rgb ink
unset label

set lmargin at screen 0.54
set rmargin at screen 0.99
set xrange [-0.5:3.6]
set yrange [-0.5:3.1]
set title "A volume is a sum of signed pieces" textcolor rgb ink
set label 1 "o" at -0.2,-0.15 center textcolor rgb ink
set label 2 "+" at 2.45,0.95 center textcolor rgb blue font ":Bold,16"
set label 3 "+" at 0.42,1.35 center textcolor rgb blue font ":Bold,16"
set label 4 "−" at 2.0,1.53 center textcolor rgb orange font ":Bold,16"
set style fill transparent solid 0.22 noborder
plot csv index 4 using 1:($3>0 ? $2 : NaN) with filledcurves closed lc rgb blue, \
     csv index 4 using 1:($3<0 ? $2 : NaN) with filledcurves closed lc rgb orange, \
     csv index 4 using 1:2 with lines lw 0.8 dt 2 lc rgb grey, \
     csv index 3 using 1:2 with lines lw 2.4 lc rgb ink, \
     csv index 3 using 1:2 with points pt 7 ps 1.43 lc rgb ink
unset multiplot
