# 10-spacing.gp - sh figures/draw/chart.sh figures/10/10-spacing.gp DATA.csv CHART.svg
high = 460
load "figures/draw/chart.gp"
set logscale xy 10
set xrange [9.7656e-4:1.6777e7]
set yrange [1e-20:1e2]
set xtics ("1 mm" 1e-3, "1 m" 1, "1 km" 1e3, "1000 km" 1e6)
set ytics ("1 m" 1, "1 mm" 1e-3, "1 µm" 1e-6, "1 nm" 1e-9, "10^{−12} m" 1e-12, "10^{−15} m" 1e-15, "10^{−18} m" 1e-18)
set xlabel "distance from the origin" textcolor rgb ink
set title "The smallest move that a coordinate can make"
set label 1 "float" at 1.4e-3,1.2e-8 textcolor rgb orange font bold
set label 2 "double" at 1.4e-3,3e-17 textcolor rgb blue font bold
set label 3 "g dt², 60 steps a second"   at 1.4e-3,2.725e-3*6 textcolor rgb green
set label 4 "600 steps a second"  at 1.4e-3,2.725e-5*6 textcolor rgb green
set label 5 "6000 steps a second" at 1.4e-3,2.725e-7*6 textcolor rgb green
plot csv index 1 using (9.7656e-4):2:(1.6e7):(0) with vectors nohead lc rgb green lw 1.2 dt 2, \
     csv index 0 using 1:2 with steps lc rgb orange lw 2, \
     csv index 0 using 1:3 with steps lc rgb blue lw 2
