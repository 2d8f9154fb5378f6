# 09-order.gp - sh figures/draw/chart.sh figures/09/09-order.gp DATA.csv CHART.svg
# Blocks of the data: as listed; along the paper's lists.
high = 320
load "figures/draw/chart.gp"
set datafile separator comma
listed = quiet; ordered = orange
set xrange [0:108]
set xtics 0,20,100
set xlabel "bodies" textcolor rgb ink
set multiplot

eval box(62, 350, 50, 284)
set title "Constraints relaxed a step"
set yrange [0:4000]
set ytics ("0" 0, "1,000" 1000, "2,000" 2000, "3,000" 3000, "4,000" 4000)
set label 1 "as listed" at 66,1750 textcolor rgb listed
set label 2 "along the paper’s lists" at 6,3000 textcolor rgb ordered font bold
set label 3 "half of “as listed”, as\nthe paper reports" at 52,620 textcolor rgb listed font small
plot csv index 0 using 2:($3/2) with lines lc rgb listed lw 1 dt 3, \
     csv index 0 using 2:3 with linespoints pt 6 ps 0.72 lc rgb listed lw 1.6, \
     csv index 1 using 2:3 with linespoints pt 7 ps 0.72 lc rgb ordered lw 2.4
unset label

eval box(430, 708, 50, 284)
set title "Constraints looked at a step"
set yrange [0:20000]
set ytics ("0" 0, "5,000" 5000, "10,000" 10000, "15,000" 15000, "20,000" 20000)
set label 1 "as listed" at 66,7800 textcolor rgb listed
set label 2 "along the paper’s lists" at 6,14800 textcolor rgb ordered font bold
plot csv index 0 using 2:4 with linespoints pt 6 ps 0.72 lc rgb listed lw 1.6, \
     csv index 1 using 2:4 with linespoints pt 7 ps 0.72 lc rgb ordered lw 2.4
unset multiplot
