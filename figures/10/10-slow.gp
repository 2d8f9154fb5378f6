# 10-slow.gp - sh figures/draw/chart.sh figures/10/10-slow.gp DATA.csv CHART.svg
high = 460
load "figures/draw/chart.gp"
set datafile separator ","
set logscale xy 10
set xrange [3.6:80]
set yrange [100:1e8]
set xtics (4, 6, 8, 12, 16, 24)
set ytics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6, "10 ms" 1e7, "0.1 s" 1e8)
set xlabel "points of each body" textcolor rgb ink
set title "Every feature with every other, and the quick way"
set label 1 "depth: all normals and\ncrossings of edges" at 26,2.6e7 textcolor rgb orange font bold
set label 2 "distance: all pairs\nof features" at 26,4e6 textcolor rgb purple font bold
set label 3 "depth: the hit face" at 26,6e3 textcolor rgb blue font bold
set label 4 "distance: GJK" at 26,1.1e3 textcolor rgb green font bold
plot csv using 1:3 every ::1 with linespoints pt 7 ps 0.91 lc rgb orange lw 1.5, \
     csv using 1:2 every ::1 with linespoints pt 7 ps 0.91 lc rgb purple lw 1.5, \
     csv using 1:5 every ::1 with linespoints pt 7 ps 0.91 lc rgb blue lw 1.5, \
     csv using 1:4 every ::1 with linespoints pt 7 ps 0.91 lc rgb green lw 1.5
