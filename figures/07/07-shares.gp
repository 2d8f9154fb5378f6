# 07-shares.gp - a drawing: sh figures/draw/chart.sh figures/07/07-shares.gp - CHART.svg
high = 260
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
eval box(0, 720, 0, 260)
set xrange [0:720]
set yrange [0:260]
# K of a feature: the sum of w a^2; a share of the depth is K over the sum of both.
left = 282; right = 700
share(KA, KB) = KA / (1.0 * KA + KB)
row(n, y, KA, KB) = sprintf("set object %d rectangle from %g,%g to %g,%g fc rgb '%s' fs solid 1 noborder; set object %d rectangle from %g,%g to %g,%g fc rgb '%s' fs solid 1 noborder", \
  2 * n, left, y - 14, left + (right - left) * share(KA, KB), y + 14, blue, 2 * n + 1, left + (right - left) * share(KA, KB), y - 14, right, y + 14, orange)
says(n, y, what, KA, KB) = sprintf("set label %d \"%s\" at %g,%g right textcolor rgb ink; set label %d \"%.0f %%\" at %g,%g left textcolor rgb page", \
  3 * n, what, left - 12, y, 3 * n + 1, 100 * share(KA, KB), left + 8, y)
other(n, y, KA, KB) = share(KA, KB) > 0.95 ? "" : sprintf("set label %d \"%.0f %%\" at %g,%g right textcolor rgb page", 3 * n + 2, 100 * (1 - share(KA, KB)), right - 8, y)
array what[5] = ["vertex against vertex", "vertex against the middle of an edge", "vertex against the middle of a face", "the same, with B ten times as heavy", "vertex against a pinned edge"]
array K[5] = [1, 1.0 / 2, 1.0 / 3, 1.0 / 30, 0]
do for [n = 1:5] {
  y = 235 - 42 * n
  eval row(n, y, 1, K[n])
  eval says(n, y, what[n], 1, K[n])
  eval other(n, y, 1, K[n])
}
set label 100 "A’s share of the depth" at left,236 textcolor rgb blue font bold
set label 101 "B’s share" at right,236 right textcolor rgb orange font bold
plot NaN
