# check_numbers.sh - does a number that is older than its source, was changed by
# hand, or was typed by hand, fail?  In a small tree each fault in turn; the
# sentence must name it.  Then the book itself: is each numeral of it a reference,
# given, or quoted (chapters/numerals.sh)?
# (What a reference may not be: check_weave.sh.)

export LC_ALL=C
unset SETTINGS TUMBLE_QUICK
root=$(pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
tests=0 failed=0

# A figure, a module, a table and one that is gathered from the figure.
sound() {
    rm -rf "$tree"/*; cd "$tree" || exit 1
    mkdir -p lib/a figures/01 figures/tables figures/peers figures/moving figures/measure figures/draw tests/hard tests/script chapters
    cp "$root"/figures/draw/*.awk "$root"/figures/draw/*.sh "$root"/figures/draw/chart.gp figures/draw/
    cp "$root"/chapters/*.awk "$root"/chapters/*.sh chapters/
    printf 'EXACT    := -std=c11\nCFLAGS ?= -O3\nSPEED := 01-n\n' > Makefile
    printf '// a.h - what it is\nint a(void);\n' > lib/a/a.h
    printf '#include "a.h"\n/* two\n lines */ int a(void) { return 1; }   // one\n' > lib/a/a.c
    printf '#include "a.h"\nint main(void) { return a(); }\n' | tee figures/01/01-n.c > tests/hard/hard.c
    printf '# a b\n1 2\n#= n,2\n' > figures/01/01-n.csv
    echo 'plot csv' > figures/01/01-n.gp; echo '<svg/>' > figures/01/01-n.svg
    printf 'number,error\n1,0.5\n' > figures/tables/hard.csv; printf 'what\nn,2\n' > figures/tables/speed.csv
    echo x > figures/moving/moving.webp; echo 'int main(void) {}' > figures/moving/moving.c
    : > figures/tables/made.txt
    printf '# given\n' > chapters/given.txt; printf '# quoted\n' > chapters/quoted.txt
    printf '# 01. A\n\nIt is 3 m long, ![p](../figures/01/01-n.svg) and {{01-n; 1; b}} wide. It took 5 ms.\n' > chapters/01-a.md
    printf '# A\n\n![m](figures/moving/moving.webp) It takes <!--{{01-n; 1; b}}-->2.0<!----> ms.\n' > README.md
    sh chapters/numerals.sh given 01
    sh figures/draw/stamp.sh 01-n hard speed moving
}
numerals() { sh chapters/numerals.sh; }
readme() { awk -f chapters/numbers.awk -f chapters/readme.awk README.md > fresh && cmp fresh README.md; }
stamps() { sh figures/draw/stamp.sh; }
verdict() {
    tests=$((tests + 1))
    [ "$2" = yes ] || { failed=$((failed + 1)); echo "$1: FAILED"; cat said; }
}
accepts() { if $2 > said 2>&1; then verdict "$1" yes; else verdict "$1" no; fi; }
refuses() { if $2 > said 2>&1 || ! grep -qF -- "$3" said; then verdict "$1" no; else verdict "$1" yes; fi; }

sound; accepts "what is as it was made passes" stamps
echo '// a remark' >> lib/a/a.c; sed -i.old 's/return 1/return   1/' lib/a/a.c
accepts "a comment and white space age nothing" stamps
sound; sed -i.old 's/return 1/return 2/' lib/a/a.c
refuses "a module is changed" stamps 'figures/01/01-n.csv is older than lib/a: run make figure-01-n'
grep -qF 'figures/tables/hard.csv is older than lib/a: run make hard' said; verdict "its table, too" $([ $? = 0 ] && echo yes)
sound; echo 'int b;' >> figures/01/01-n.c
refuses "a program is changed" stamps 'figures/01/01-n.csv is older than its program'
mkdir figures/01b; echo 'int main(void) {}' > figures/01b/01b-n.c; printf '1 2\n' > figures/01b/01b-n.csv
sed -i.old 's/SPEED := .*/SPEED := 01b-n/' Makefile; sh figures/draw/stamp.sh 01b-n speed; echo '1 3' > figures/01b/01b-n.csv
refuses "a figure of a chapter with a letter" stamps 'figures/01b/01b-n.csv is not what its program wrote'
refuses "and a table that is gathered from it" stamps 'figures/tables/speed.csv is older than the tables that it is gathered from'
sound; sed -i.old 's/1 2/1 3/' figures/01/01-n.csv
refuses "a CSV is changed by hand" stamps 'figures/01/01-n.csv is not what its program wrote'
sh figures/draw/stamp.sh -d 01-n
refuses "and drawn again" stamps 'figures/01/01-n.csv is not what its program wrote'
sound; sed -i.old 's/0.5/0.4/' figures/tables/hard.csv
refuses "a table is changed by hand" stamps 'figures/tables/hard.csv is not what its program wrote: run make hard'
sound; sed -i.old 's/1 2/1 3/' figures/01/01-n.csv; sh figures/draw/stamp.sh 01-n
refuses "a table is older than what it is gathered from" stamps 'figures/tables/speed.csv is older than the tables that it is gathered from: run make tables'
sound; SETTINGS='-std=c11 -O0' sh figures/draw/stamp.sh 01-n
refuses "other flags" stamps 'figures/01/01-n.csv was made with other settings than those of make'
sound; TUMBLE_QUICK=1 sh figures/draw/stamp.sh hard
refuses "a quick run" stamps 'figures/tables/hard.csv was made with other settings'
sound; echo 'set x' >> figures/01/01-n.gp
refuses "a chart is older than its script" stamps 'figures/01/01-n.svg is older than its data or its .gp: run make chart-01-n'
sound; printf 'a\n1\n' > figures/peers/box3d.csv
refuses "a table without a program" stamps 'figures/peers/box3d.csv has no stamp: run make box3d BOX3D=FOLDER'

sound; accepts "numerals that are given pass" numerals; accepts "README says what its table says" readme
sed -i.old 's/It is 3 m long/It is 3 m\
    long/' chapters/01-a.md; accepts "lines may be broken elsewhere" numerals
sound; echo 'A rope stretches by 2.5 %.' >> chapters/01-a.md
refuses "a numeral typed by hand" numerals '01:3: typed by hand: 2.5 %, in: A rope stretches by 2.5 %.'
sound; printf '# 01b. B\n\nA rope stretches by 2.5 %%.\n' > chapters/01b-b.md
refuses "a numeral of a chapter with a letter" numerals '01b:3: typed by hand: 2.5 %'
sh chapters/numerals.sh given 01b; accepts "and given there" numerals
sound; sed -i.old 's/5 ms/6 ms/' chapters/01-a.md
refuses "a numeral changed by hand" numerals '01:3: typed by hand: 6 ms'
sound; echo 'It is 1.3 times as fast.' >> README.md
refuses "a numeral typed by hand in README" numerals 'README.md:3: typed by hand: 1.3 times'
sound; sed -i.old 's/2[.]0<!---->/1.9<!---->/' README.md
refuses "a number of README changed by hand" readme 'differ'
sound; echo 'A rope stretches by 2.5 %.' >> chapters/01-a.md; sh chapters/numerals.sh quoted 01
refuses "a quoted line without a source" numerals 'quoted.txt:2: no source: 01'
sed -i.old 's/ |  |  |  | ?.*/ | a machine | abc | 2026-01-01 | make n/' chapters/quoted.txt
accepts "a quoted line with all of it" numerals
sed -i.old '$d' chapters/01-a.md
refuses "a quoted line of no sentence" numerals 'lists what is not in the book: 01'

cd "$root" || exit 1
sh chapters/numerals.sh || failed=$((failed + 1))
echo "numbers: $tests trials, $failed failed"
[ $failed -eq 0 ]
