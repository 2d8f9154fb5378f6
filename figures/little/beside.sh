# beside.sh - the little program's engine, stage 18b, beside the library, on ten scenes and
# five that were held out; both awake, in one process, with the same flags:
#   sh figures/little/beside.sh > figures/little/beside.csv
#   sh figures/little/beside.sh of      a checksum of all that it is made of
# BUILD: where libtumble.a is.  CFLAGS: those of the library.

export LC_ALL=C
if [ "$1" = of ]; then
    cat chapters/little/*.c figures/little/scenes.inc figures/little/beside.inc figures/little/beside.sh lib/tumble.h lib/*/*.[ch] |
        sed '/^# of /d; /^ *\/\//d' | cksum | sed 's/ .*//'
    exit
fi
echo "# of $(sh "$0" of)"
build=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
last=18b
awk -v stage=$last -f chapters/little/cut.awk chapters/little/*.c | sed 's/^int main(void)/int show_all(void)/' > "$work/beside.c"
cat figures/little/scenes.inc figures/little/beside.inc >> "$work/beside.c"
${CC:-cc} -std=c11 -ffp-contract=off -fno-math-errno -fno-trapping-math ${CFLAGS:--O3} -Ilib \
    "$work/beside.c" "$build/libtumble.a" -o "$work/beside" -lm && "$work/beside"
