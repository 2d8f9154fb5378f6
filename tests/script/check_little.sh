# check_little.sh - every stage of the little program is cut, compiles alone without
# a warning, runs, and does what stages.txt says of it.  No stage is too long, no
# function, no line; and of the libraries it needs what every machine computes alike.
# Typed from the book, by the places that it names and in its order, each is the same.

export LC_ALL=C
here=chapters/little
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What a stage's program may call.
calls='printf|puts|putchar|sqrt|memcpy|memset|strcmp|__stack_chk_fail|main'

check_stage() {     # STAGE
    s=$1; c=$work/stage-$s.c; bad=
    case $s in 0*) most=900 ;; 1[0-5]*) most=1800 ;; *) most=2040 ;; esac
    awk -v stage=$s -f $here/cut.awk $here/*.c > "$c" || return 1
    awk -v most=$most -f $here/lines.awk "$c" || bad=1
    (cd "$work" && ${CC:-gcc} -std=c11 -ffp-contract=off -O1 -Wall -Wextra -Werror -c stage-$s.c -o $s.o \
        && objcopy --redefine-sym printf=printf_noted $s.o noted-$s.o && ${CC:-gcc} noted-$s.o printed.o -o $s -lm) || return 1
    nm -u "$work/$s.o" | awk '{ print $2 }' | sed 's/^_*\(printf\)_chk/\1/' | grep -v -x -E "$calls" | sed 's/^/  it calls /' > "$work/$s.calls"
    [ ! -s "$work/$s.calls" ] || { cat "$work/$s.calls"; bad=1; }
    timeout 60 "$work/$s" > "$work/$s.txt" 2> "$work/$s.hash" || { echo "  it ends badly"; return 1; }
    awk -v stage=$s -f $here/claims.awk $here/stages.txt "$work/$s.txt" || bad=1
    sum=$(cksum < "$c")
    { echo "= $s ${sum%% *} $(cat "$work/$s.hash")"; cat "$work/$s.txt"; } > "$work/$s.printed"
    awk -v head="= $s " '/^= / { own = index($0, head) == 1 } own' $here/printed.txt | cmp -s - "$work/$s.printed" \
        || { echo "  it prints other numbers, or has other bits, than printed.txt: make little-measured"; bad=1; }
    sed 1,3d "$c" | grep -v -e '^$' -e '^// ---' | cmp -s - "$work/typed/$s" || { echo "  typed from the book it is another program"; bad=1; }
    [ ! "$bad" ]
}

${CC:-gcc} -std=c11 -O1 -c figures/workshop/printed.c -o "$work/printed.o" || exit 1
sh chapters/weave.sh "$work" && mkdir "$work/typed" || { echo "FAILED: there is no book to type from"; exit 1; }
failed=
awk -v out="$work/typed" -f tests/script/type_little.awk "$work"/woven/[0-9]*.md "$work/woven/lib-little.md" || failed=" typing"

n=0
for s in $(sed -n 's/^\([0-9][0-9][a-z]\) .*/\1/p' $here/stages.txt); do
    n=$((n + 1))
    (check_stage $s) > "$work/said" 2>&1 || { echo "stage $s:"; cat "$work/said"; failed="$failed $s"; }
done
# A reader's program is judged: ours is right, and that of the stage before is not.
judge() { MINE=$work/stage-$1.c BUILD=$work CC=${CC:-gcc} sh $here/little.sh run 01b > "$work/said" 2>&1; }
judge 01b; grep -q '4 of 4 lines are the same' "$work/said" && grep -q 'all that stage 01b claims holds for yours' "$work/said" \
    || { echo "make little does not know a right program:"; cat "$work/said"; failed="$failed judge"; }
judge 01a; grep -q 'highest: yours 1.785 m, ours 1.000 m' "$work/said" && grep -q 'does not hold: highest <= 1.001 m, and it is 1.785' "$work/said" \
    || { echo "make little does not know a wrong program:"; cat "$work/said"; failed="$failed judge"; }

sh $here/little.sh measured | cmp -s - $here/measured.csv \
    || { echo "measured.csv is another than printed.txt: make little-measured"; failed="$failed measured"; }
BUILD=$work sh $here/little.sh table | cmp -s - figures/tables/stages.csv \
    || { echo "figures/tables/stages.csv is another than the stages': make little-measured"; failed="$failed table"; }
sh $here/little.sh films-of | cmp -s - figures/little/films.txt \
    || { echo "figures/little/*.webp were made of other stages: make little-films"; failed="$failed films"; }
[ "$n" -gt 0 ] || { echo "FAILED: there are no stages"; exit 1; }
[ "$(sed -n 's/^# of //p' figures/little/beside.csv)" = "$(sh figures/little/beside.sh of)" ] || {
    echo "figures/little/beside.csv is older than the little program or lib/: make little-beside"; failed="$failed beside"; }
[ "$(sed -n 's/^# of //p' figures/little/rows.csv)" = "$(sh figures/little/rows.sh of)" ] || {
    echo "figures/little/rows.csv is older than the little program or the lists: make little-rows"; failed="$failed rows"; }
[ ! "$failed" ] || { echo "FAILED:$failed of the little program"; exit 1; }
echo "100%: $n stages of the little program do as they say"
