# 08-blow.gp - gnuplot -e "csv='...'; png='...'" figures/08/08-blow.gp
set encoding utf8
set terminal pngcairo size 2000,900 font "DejaVu Sans,20" background "#f6f5f3"
set output png
set datafile separator whitespace
unset border
unset tics
unset key
unset colorbox
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set multiplot

# The colour of a strain: its size in powers of ten above 0.01 %, with a sign.
power(e) = abs(e) < 1e-4 ? 0 : log10(abs(e) / 1e-4)
shade(e) = e < 0 ? -power(e) : power(e)
set cbrange [-3.7:3.7]
set palette defined (-3.7 "#003a60", -2.3 "#0072b2", -1 "#56b4e9", 0 "#d6d3cd", \
                     1 "#e9b95c", 2.3 "#d55e00", 3.7 "#8a3200")

array row[2] = ["in the order\nof its list", "from the blow\noutwards"]
array after[5] = ["struck", "10 relaxations", "30", "100", "300"]
left = 0.11
width = (1 - left) / 5
set xrange [-7.7:7.7]
set yrange [-8.3:7.5]
do for [r = 0:1] {
  do for [k = 0:4] {
    i = 5 * r + k
    set size width, 0.42
    set origin left + k * width, 0.515 - r * 0.435
    unset label
    if (k == 0) { set label 1 row[r+1] at -8.1,0.5 right textcolor rgb "#404040" }
    if (r == 0) { set label 2 after[k+1] at 0,7.3 center textcolor rgb "#404040" }
    plot csv index i using 1:2:($3-$1):($4-$2):(shade($5)) with vectors nohead lw 2 lc palette, \
         csv index i using (abs($5) > 1e-2 ? $1 : NaN):2:($3-$1):($4-$2):(shade($5)) with vectors nohead lw 5 lc palette, \
         csv index i using 1:2 with points pt 7 ps 0.45 lc rgb "#8f8a82", \
         csv index i using 3:4 with points pt 7 ps 0.45 lc rgb "#8f8a82", \
         csv index i every ::0::0 using (0):(-7.5):(sprintf("%d off, the worst %.0f %%", $7, 100 * $6)) with labels textcolor rgb "#808080"
  }
}

# What the colours say, beneath all.
unset label
set size noratio 1, 0.08
set origin 0,0
set xrange [0:100]
set yrange [0:1]
set label 1 "too long" at 40,0.5 right textcolor rgb "#d55e00"
set label 2 "too short" at 42,0.5 textcolor rgb "#0072b2"
set label 3 "thick: by more than 1 %" at 51,0.5 textcolor rgb "#808080"
plot NaN
unset multiplot
