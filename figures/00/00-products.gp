# 00-products.gp - sh figures/draw/chart.sh figures/00/00-products.gp DATA.csv CHART.svg
high = 310
load "figures/draw/chart.gp"
at(name, column_, block) = real(system(sprintf("awk -v want='\"%s\"' -v block=%d '/^\"/ && $1 == want { if (n++ == block) print $%d }' %s", name, block, column_ + 1, csv)))
ax = at("a", 1, 0); ay = at("a", 2, 0); bx = at("b", 1, 0); by = at("b", 2, 0)
px = at("along", 1, 0); py = at("along", 2, 0)
ux = at("a", 1, 1); uy = at("a", 2, 1); vx = at("b", 1, 1); vy = at("b", 2, 1); cz = at("cross", 3, 0)
unset border
unset tics
set size ratio -1
set multiplot layout 1,2 margins 0.02,0.98,0.03,0.87 spacing 0.02
set style arrow 1 head filled size 0.11,18 lw 3
set title "The dot product"
set xrange [-0.25:3.05]
set yrange [-0.75:1.75]
set arrow 1 from 0,0 to bx,by as 1 lc rgb blue
set arrow 2 from 0,0 to ax,ay as 1 lc rgb orange
set arrow 3 from px,py to ax,ay nohead dt 2 lw 1.5 lc rgb grey
ox = 0.045 * by / sqrt(bx * bx + by * by); oy = -0.045 * bx / sqrt(bx * bx + by * by)
set arrow 4 from 3*ox,3*oy to px+3*ox,py+3*oy heads size 0.07,20 lw 2 lc rgb green
# the right angle
l = sqrt(bx * bx + by * by); ex = bx / l * 0.12; ey = by / l * 0.12
set object 1 polygon from px,py to px-ex,py-ey to px-ex-ey,py-ey+ex to px-ey,py+ex to px,py fillstyle empty border lc rgb grey lw 1.2
set label 1 "a" at ax-0.16,ay+0.09 textcolor rgb orange font bold
set label 2 "b" at bx+0.07,by+0.03 textcolor rgb blue font bold
set label 3 "how far a reaches along b" at px/2+6*ox,py/2+6*oy-0.12 center textcolor rgb green
set label 4 "a · b = |b| × this length" at px/2+6*ox,py/2+6*oy-0.33 center textcolor rgb ink
set label 5 "θ" at 0.33,0.17 textcolor rgb ink
plot NaN
unset arrow
unset label
unset object
set title "The cross product"
# A view from the side: x to the right and a little down, y into the page, z up.
X(x, y) = x + 0.55 * y
Y(x, y, z) = -0.12 * x + 0.42 * y + z
set xrange [-0.4:2.9]
set yrange [-0.75:1.75]
set object 2 polygon from X(0,0),Y(0,0,0) to X(ux,uy),Y(ux,uy,0) to X(ux+vx,uy+vy),Y(ux+vx,uy+vy,0) to X(vx,vy),Y(vx,vy,0) to X(0,0),Y(0,0,0) fillcolor rgb pale(green, 0.15) fillstyle solid 1 noborder behind
set arrow 1 from X(0,0),Y(0,0,0) to X(ux,uy),Y(ux,uy,0) as 1 lc rgb orange
set arrow 2 from X(0,0),Y(0,0,0) to X(vx,vy),Y(vx,vy,0) as 1 lc rgb blue
set arrow 3 from X(0,0),Y(0,0,0) to X(0,0),Y(0,0,cz) as 1 lc rgb green
set label 1 "a" at X(ux,uy)+0.08,Y(ux,uy,0)-0.05 textcolor rgb orange font bold
set label 2 "b" at X(vx,vy)-0.08,Y(vx,vy,0)+0.17 textcolor rgb blue font bold
set label 3 "a × b" at 0.12,cz-0.02 textcolor rgb green font bold
set label 4 "its length is the area of the parallelogram" at X(ux,uy)-0.15,-0.42 center textcolor rgb ink
plot NaN
unset multiplot
