# rows.sh - rows of chapter 20's lists, of the little program (stage 18b), each beside
# its target, and beside what the library's row says in figures/tables:
#   sh figures/little/rows.sh > figures/little/rows.csv
#   sh figures/little/rows.sh of      a checksum of all that it is made of

export LC_ALL=C
lists='figures/tables/hard.csv figures/tables/families.csv'
if [ "$1" = of ]; then
    { cat chapters/little/*.c figures/little/scenes.inc figures/little/rows.inc figures/little/rows.sh | sed '/^ *\/\//d'
      sed -n 's/^\([0-9]*\),.*,\([a-zA-Z ]*\)$/\1 \2/p' $lists; } | cksum | sed 's/ .*//'
    exit
fi
echo "# of $(sh "$0" of)"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk -v stage=18b -f chapters/little/cut.awk chapters/little/*.c |
    sed 's/^int main(void)/int show_all(void)/; s/^static const vec3 gravity/static vec3 gravity/' > "$work/rows.c"
cat figures/little/scenes.inc figures/little/rows.inc >> "$work/rows.c"
${CC:-cc} -std=c11 -ffp-contract=off -O2 "$work/rows.c" -o "$work/rows" -lm && "$work/rows" > "$work/rows.csv" || exit 1
awk -F, 'FILENAME !~ /rows.csv$/ { if ($1 ~ /^[0-9]+$/) library[$1] = $NF; next }
    FNR == 1 { print $0 ",library"; next }
    { print $0 "," library[$1] }' $lists "$work/rows.csv" | sort -s -t, -k1,1n
