# 08-blow.gp - sh figures/draw/chart.sh figures/08/08-blow.gp DATA.csv CHART.svg
high = 400
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set multiplot

# A stick is right, off by more than 0.01 %, than 1 % or than 10 %.
level(e) = abs(e) < 1e-4 ? 0 : abs(e) < 1e-2 ? 1 : abs(e) < 0.1 ? 2 : 3
array wide[4] = [0.8, 1.2, 2, 3]
array share[4] = [1, 0.45, 0.75, 1]
array row[2] = ["in the order\nof its list", "from the blow\noutwards"]
array after[5] = ["struck", "10 relaxations", "30", "100 relaxations", "300 relaxations"]
array shown[4] = [0, 1, 3, 4]
left = 0.155
width = (1 - left) / 4
set xrange [-7.7:7.7]
set yrange [-8.9:7.5]
do for [r = 0:1] {
  do for [k = 1:4] {
    i = 5 * r + shown[k]
    set size width, 0.44
    set origin left + (k - 1) * width, 0.5 - r * 0.43
    unset label
    if (k == 1) { set label 1 row[r+1] at -8.1,0.9 right textcolor rgb ink }
    if (r == 0) { set label 2 after[shown[k]+1] at 0,8.2 center textcolor rgb ink }
    plot csv index i using (level($5) == 0 ? $1 : NaN):2:($3-$1):($4-$2) with vectors nohead lc rgb rule lw 0.8, \
         for [l = 1:3] csv index i using ($5 < 0 && level($5) == l ? $1 : NaN):2:($3-$1):($4-$2) with vectors nohead lc rgb pale(blue, share[l+1]) lw wide[l+1], \
         for [l = 1:3] csv index i using ($5 > 0 && level($5) == l ? $1 : NaN):2:($3-$1):($4-$2) with vectors nohead lc rgb pale(orange, share[l+1]) lw wide[l+1], \
         csv index i every ::0::0 using (0):(-8.2):(sprintf("%d off, worst %.0f %%", $7, 100 * $6)) with labels font small textcolor rgb quiet
  }
}

# What the colours say, beneath all.
unset label
set size noratio 1, 0.07
set origin 0,0
set xrange [0:100]
set yrange [0:1]
set label 1 "too long" at 42,0.5 right textcolor rgb orange
set label 2 "too short" at 44,0.5 textcolor rgb blue
set label 3 "thick: by more than 1 %, and than 10 %" at 56,0.5 textcolor rgb quiet
plot NaN
unset multiplot
