# check_bits.sh - short films, and the live figures of the book, end in the
# places, to the last bit, where they ended when tests/bits/bits.txt was written.
# A change of lib/ that means to move them renews that file:
#     make checks && sh tests/script/check_bits.sh --renew
# The program that makes the films is $1, or build/bits; the figures' stand in
# live/ beside it.

renew=
[ "$1" != --renew ] || { renew=1; shift; }
program=${1:-${BUILD:-build}/bits}
now=$(mktemp)
trap 'rm -f "$now"' EXIT
{
    "$program" || echo "$program failed"
    for figure in $(grep -l '^const live_figure figure' figures/live/*.c); do
        figure=$(dirname "$program")/live/$(basename "$figure" .c)
        "$figure" || echo "$figure failed"
    done
} > "$now"
! grep ' failed$' "$now" || exit 1
[ -z "$renew" ] || cp "$now" tests/bits/bits.txt
diff tests/bits/bits.txt "$now" && echo "the bits: $(grep -vc ^live "$now") films and $(grep -c ^live "$now") live figures end as tests/bits/bits.txt says"
