# check_numbers.sh - does a number that is older than its source, or was changed
# by hand, fail?  In a small tree each fault in turn; the sentence must name it.
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
    printf '# 01. A\n\nIt is 3 m long, ![p](../figures/01/01-n.svg) and {{01-n; 1; b}} wide. It took 5 ms.\n' > chapters/01-a.md
    printf '# A\n\n![m](figures/moving/moving.webp) It takes 2.0<!--{{01-n; 1; b}}--> ms.\n' > README.md
    sh figures/draw/stamp.sh 01-n hard speed moving
}
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

cd "$root" || exit 1
echo "numbers: $tests trials, $failed failed"
[ $failed -eq 0 ]
