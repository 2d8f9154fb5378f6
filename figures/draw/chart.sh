# chart.sh - draws a chart: sh figures/draw/chart.sh CHART.gp DATA.csv CHART.svg
# gnuplot draws it, and chart.awk gives it colours that follow the page.

gnuplot=$3.part
trap 'rm -f "$gnuplot" "$3.new"' EXIT
LC_ALL=C.UTF-8 gnuplot -e "csv='$2'" "$1" > "$gnuplot" &&
LC_ALL=C awk -f figures/draw/chart.awk "$gnuplot" > "$3.new" && mv "$3.new" "$3"
