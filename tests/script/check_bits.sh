# check_bits.sh - short films end in the places, to the last bit, where they
# ended when tests/bits/bits.txt was written.  A change of lib/ that means to move
# them renews that file:  build/bits > tests/bits/bits.txt
# The program is $1, or build/bits.

program=${1:-${BUILD:-build}/bits}
now=$(mktemp)
trap 'rm -f "$now"' EXIT
"$program" > "$now" || { echo "check_bits: $program failed"; exit 1; }
diff tests/bits/bits.txt "$now" && echo "the bits: the films end as tests/bits/bits.txt says"
