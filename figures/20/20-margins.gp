# 20-margins.gp - sh figures/draw/chart.sh figures/20/20-margins.gp DATA.csv CHART.svg
stats csv index 0 using 2 nooutput
rows = STATS_records
high = 100 + 22 * rows
load "figures/draw/chart.gp"
set border 1 lc rgb grey lw 0.7
set lmargin at screen 0.372
set rmargin at screen 0.965
set tmargin at screen 1 - 50.0 / high
set bmargin at screen 32.0 / high
set logscale x 10
set xrange [7e-10:2e3]
set yrange [0.3:rows + 0.7]
set ytics 1 format "" scale 0
set grid xtics ytics lt 1 lc rgb rule lw 0.8
set xtics nomirror ("0" 1e-9, "10^{−6}" 1e-6, "10^{−4}" 1e-4, "1 %%" 1e-2, "target" 1, "100 times" 100)
set label 2 "Every number, as a part of its target" at screen 0.372,1 - 18.0 / high left font bold textcolor rgb ink
set object 1 rectangle from 1,graph 0 to 2e3,graph 1 fc rgb pale(orange, 0.15) fs solid noborder behind
set arrow 1 from 1,graph 0 to 1,graph 1 nohead lc rgb orange lw 1.2 back
set label 1 "falls short" at 30,rows + 1.2 center textcolor rgb orange
ours = number(blue)
theirs = number(orange)
plot csv index 0 using (7e-10):2:(sprintf("%d.  %s", $1, strcol(3))) with labels right offset -1,0 textcolor rgb ink, \
     csv index 1 using 2:1 with points pt 7 ps 0.49 lc rgb pale(blue, 0.35), \
     csv index 2 using 2:1:($2 > 1 ? theirs : ours) with points pt 7 ps 1.17 lc rgb variable
