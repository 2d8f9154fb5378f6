# 01-spring.gp - sh figures/draw/chart.sh figures/01/01-spring.gp DATA.csv CHART.svg
high = 290
load "figures/draw/chart.gp"
set border 0
set zeroaxis lt 1 lc rgb grey lw 1
unset tics
set size ratio -1
set multiplot layout 1,3 margins 0.01,0.99,0.03,0.86 spacing 0.01
set label 8 "x_k" textcolor rgb quiet
set label 9 "x_{k+1}" textcolor rgb quiet
# The curve X^2 - c X Y + Y^2 = I, turned by 45 degrees: p and q along the diagonals.
I(w) = 1 + (1 - w * w / 2)**2 - (2 - w * w) * (1 - w * w / 2)
P(w) = sqrt(abs(I(w)) / (1 - (2 - w * w) / 2))
Q(w) = sqrt(abs(I(w) / (1 + (2 - w * w) / 2)))
set parametric
set samples 400
r = 1.55
set xrange [-r:r]; set yrange [-r:r]
set label 8 at r*0.9,-r*0.1
set label 9 at r*0.06,r*0.94
set title "ω Δt = 1.2"
set trange [0:2*pi]
x(p, q) = (p + q) / sqrt(2)
y(p, q) = (p - q) / sqrt(2)
plot x(P(1.2)*cos(t), Q(1.2)*sin(t)), y(P(1.2)*cos(t), Q(1.2)*sin(t)) with lines lc rgb pale(blue, 0.5) lw 1.2, \
     csv index 0 using 1:2 with points pt 7 ps 0.85 lc rgb blue
r = 1.55
set xrange [-r:r]; set yrange [-r:r]
set label 8 at r*0.9,-r*0.1
set label 9 at r*0.06,r*0.94
set title "ω Δt = 1.9"
plot x(P(1.9)*cos(t), Q(1.9)*sin(t)), y(P(1.9)*cos(t), Q(1.9)*sin(t)) with lines lc rgb pale(blue, 0.5) lw 1.2, \
     csv index 1 using 1:2 with points pt 7 ps 0.85 lc rgb blue
r = 4.2
set xrange [-r:r]; set yrange [-r:r]
set label 8 at r*0.9,-r*0.1
set label 9 at r*0.06,r*0.94
set title "ω Δt = 2.05"
set trange [-3.2:3.2]
plot x(P(2.05)*sinh(t), Q(2.05)*cosh(t)), y(P(2.05)*sinh(t), Q(2.05)*cosh(t)) with lines lc rgb purple lw 1.2, \
     x(P(2.05)*sinh(t), -Q(2.05)*cosh(t)), y(P(2.05)*sinh(t), -Q(2.05)*cosh(t)) with lines lc rgb purple lw 1.2, \
     csv index 2 using 1:2 with lines lc rgb pale(orange, 0.4) lw 0.6, \
     csv index 2 using 1:2 with points pt 7 ps 0.85 lc rgb orange
unset multiplot
