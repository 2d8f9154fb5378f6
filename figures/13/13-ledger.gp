# 13-ledger.gp - gnuplot -e "csv='...'; png='...'" figures/13/13-ledger.gp
set encoding utf8
set terminal pngcairo size 1400,560 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
unset border
unset key
contacts = "#0072b2"; friction = "#e69f00"; sticks = "#d55e00"; grey = "#606060"
set lmargin 4
set rmargin 4
set title "Joules given and taken in six seconds" font "DejaVu Sans,26" offset 0,-0.3
set xrange [-950:550]
set yrange [1.55:-0.75]
unset xtics
unset ytics
set arrow 1 from 0,-0.35 to 0,1.4 nohead lc rgb "#808080" lw 0.8
set label 1 "contacts" at 15,-0.28 textcolor rgb contacts
set label 2 "friction" at 15,0 textcolor rgb friction
set label 3 "sticks" at 110,0.28 textcolor rgb sticks
set label 4 "took" at -15,-0.58 right textcolor rgb grey
set label 5 "gave" at 15,-0.58 textcolor rgb grey
set style fill solid 0.85 noborder
side(x) = x < 0 ? x - 15 : x + 15
number(x) = sprintf(abs(x) < 10 ? "%+.2f" : "%+.0f", x)
plot for [k = 0:2] csv using (column(2 + k) / 2):($0 + 0.28 * (k - 1)):(abs(column(2 + k)) / 2):(0.11) \
       with boxxyerror lc rgb word(contacts . " " . friction . " " . sticks, k + 1), \
     for [k = 0:2] csv using (side(column(2 + k))):($0 + 0.28 * (k - 1)):(column(2 + k) < 0 ? number(column(2 + k)) : "") \
       with labels right textcolor rgb grey font "DejaVu Sans,18", \
     for [k = 0:2] csv using (side(column(2 + k))):($0 + 0.28 * (k - 1)):(column(2 + k) < 0 ? "" : number(column(2 + k))) \
       with labels left textcolor rgb grey font "DejaVu Sans,18", \
     csv using (540):0:1 with labels right textcolor rgb "#202020"
