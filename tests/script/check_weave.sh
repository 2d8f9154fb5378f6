# check_weave.sh - does the weave refuse what would let book and code drift?
# Each test builds a small tree with one fault, and wants the sentence for it.
# The same for check-book.awk, which reads a finished book.

export LC_ALL=C
root=$(pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
tests=0 failed=0

# A sound tree: four regions, a table, two chapters.
sound() {
    rm -rf "$tree"; mkdir -p "$tree/lib" "$tree/tests" "$tree/chapters" "$tree/figures"; cd "$tree" || exit 1
    printf '//> head\n#include "a.h"\n//<\n\n//> body\nint a(void)\n{\n\n    return 1;\n}\n//<\n' > lib/a.c
    printf '//> one-line\nint a(void);\n//<\n' > lib/a.h
    printf '# 01. A\n\n## The code\n\n@@ head\n\nThen:\n\n@@ one-line\n' > chapters/01-a.md
    printf '//> slow\nint slow(void);\n//<\n' > tests/oracle.c
    printf '# made by hand\ncase,what\n# in between\n1,"strain, mean"\n2,\n' > figures/t.csv
    printf '# 02. B\n\n## The code\n\n![p](../figures/p.png) [A](01-a.md)\n\n@@ slow\n\n%%%% figures/t.csv\n\n@@ body\n\n%%%% functions\n\n```\n@@ no region\n```\n' > chapters/02-b.md
    echo picture > figures/p.png
}
weave() { $awk -v pages="$pages" -f "$root/chapters/numbers.awk" -f "$root/chapters/pieces.awk" -f "$root/chapters/weave.awk" lib/*.h lib/*.c tests/oracle.[hc] chapters/[0-9]*.md; }
check() { $awk -f "$root/chapters/check-book.awk" lib/*.h lib/*.c tests/oracle.[hc] book.md; }

verdict() {     # NAME, and whether it went well
    tests=$((tests + 1))
    [ "$2" = yes ] || { failed=$((failed + 1)); echo "$awk: $1: FAILED"; cat said; }
}
# refuses NAME COMMAND SENTENCE: it fails, prints no book, and says SENTENCE.
refuses() {
    if $2 > printed 2> said || [ -s printed ] || ! grep -qF -- "$3" said
    then verdict "$1" no; else verdict "$1" yes; fi
}
# accepts NAME COMMAND
accepts() {
    if "$2" > printed 2> said && ! [ -s said ]; then verdict "$1" yes; else verdict "$1" no; fi
}

all() {
    sound; accepts "a sound tree is woven" weave
    cp printed book.md; accepts "a sound book is true" check
    grep -qF '[lib/a.c, lines 6 to 10: a](lib/a.c#L6-L10)' book.md &&
    grep -qF '[lib/a.h, line 2: a](lib/a.h#L2)' book.md &&
    verdict "captions name file, lines and functions" yes || verdict "captions name file, lines and functions" no
    grep -qF '[The code](#the-code-1)' book.md && grep -qF '[A](#01-a)' book.md && grep -qF '](figures/p.png)' book.md &&
    verdict "links are the book's" yes || verdict "links are the book's" no
    printf '%s\n' '[figures/t.csv](figures/t.csv)' '' '| case | what |' '|---|---|' '| 1 | strain, mean |' '| 2 |  |' '' > wanted
    $awk '/^.figures.t.csv/ { left = 7 } left-- > 0' book.md > told
    cmp -s wanted told && verdict "a table is the CSV's" yes || verdict "a table is the CSV's" no
    grep -qxF '**a**, [chapter 01](#01-a): [`a`](lib/a.h#L2)' book.md &&
    verdict "functions are listed" yes || verdict "functions are listed" no
    rm -rf pages; mkdir pages; pages=pages weave > printed; cmp -s printed book.md &&
    grep -qF '[lib/a.h, line 2: a](../../lib/a.h#L2)' pages/01-a.md &&
    grep -qF '![p](../../figures/p.png) [A](01-a.md)' pages/02-b.md &&
    [ "$(tail -n 1 pages/01-a.md)" = '[Contents](../../README.md#read) · [02. B](02-b.md)' ] &&
    ! grep -q '^# 02' pages/01-a.md && cat pages/*.md | grep -c '^```c$' | grep -qx 4 &&
    verdict "each chapter is a page" yes || verdict "each chapter is a page" no
    if grep -q '//[<>]' book.md; then verdict "markers are not shown" no; else verdict "markers are not shown" yes; fi

    # Under a picture that stands alone its words stand on the page, and not in the book.
    sound; printf '\n![One of *two*.](../figures/p.png)\n\n![See it.](../figures/live/p.webp)\n' >> chapters/01-a.md
    rm -rf pages; mkdir pages; pages=pages weave > book.md 2> said
    grep -qxF '<sub>One of *two*.</sub>' pages/01-a.md && grep -qxF '<sub>See it. <em>It moves in the pages that `make site` makes.</em></sub>' pages/01-a.md &&
    ! grep -q '<sub>' pages/02-b.md book.md && verdict "a picture has its words under it" yes || verdict "a picture has its words under it" no

    # What came later stands between two chapters, with a letter.
    sound; mkdir -p figures/01b
    printf '# n cost\n1 0.5\n' > figures/01b/01b-n.csv
    printf '# 01b. C\n\nIt costs {{01b-n; 1; cost}}, see [B](02-b.md).\n' > chapters/01b-c.md; echo '[C](01b-c.md)' >> chapters/01-a.md
    rm -rf pages; mkdir pages; pages=pages weave > book.md 2> said
    grep -qxF 'It costs 0.50, see [B](#02-b).' book.md && grep -qxF '[C](#01b-c)' book.md &&
    [ "$(tail -n 1 pages/01b-c.md)" = '[01. A](01-a.md) · [Contents](../../README.md#read) · [02. B](02-b.md)' ] &&
    verdict "a chapter may have a letter" yes || verdict "a chapter may have a letter" no

    # A program in Python has markers of its own.
    sound; mkdir -p figures/manual; printf '#> py-a\n# a.py - one.\n\n\ndef a(x):\n    return 1  #< no marker\n#<\n' > figures/manual/a.py
    printf '\n@@ py-a\n' >> chapters/01-a.md
    python() { $awk -v pages="$pages" -f "$root/chapters/numbers.awk" -f "$root/chapters/pieces.awk" -f "$root/chapters/weave.awk" lib/*.h lib/*.c tests/oracle.[hc] figures/manual/a.py chapters/[0-9]*.md; }
    check_python() { $awk -f "$root/chapters/check-book.awk" lib/*.h lib/*.c tests/oracle.[hc] figures/manual/a.py book.md; }
    pages=; python > book.md 2> said
    printf '%s\n' '[figures/manual/a.py, lines 2 to 6: a](figures/manual/a.py#L2-L6)' '' '```python' '# a.py - one.' '' '' 'def a(x):' '    return 1  #< no marker' '```' > wanted
    sed -n '/^.figures.manual.a.py/,/^```$/p' book.md | cmp -s - wanted && [ ! -s said ] &&
    check_python > /dev/null 2>> said &&
    verdict "Python is shown as Python" yes || verdict "Python is shown as Python" no
    sed -i.old 's/return 1/return 2/' figures/manual/a.py
    refuses "changed Python" check_python 'this is not line 6 of figures/manual/a.py'

    # The little program's pieces say where they go.
    little() {
        sound; mkdir -p chapters/little
        printf '00a | one | x > 1\n01a | two | x < 1\n' > chapters/little/stages.txt
        printf '//> little_a 00a\nint x;\n//<\n\n//> little_b 00a 00z\nint old(void)\n{\n    return 1;\n}\n//<\n\n//> little_c 01a\nint new(void)\n{\n    return 2;\n}\n//<\n\n//> little_d 00a\nint main(void) { return 0; }\n//<\n' > chapters/little/a.c
        echo '@@ little_c' >> chapters/01-a.md
    }
    weave_little() { $awk -v pages="$pages" -f "$root/chapters/numbers.awk" -f "$root/chapters/pieces.awk" -f "$root/chapters/weave.awk" lib/*.h lib/*.c tests/oracle.[hc] chapters/little/*.c chapters/[0-9]*.md; }
    little; weave_little > book.md 2> said
    grep -qxF '*Stage 01a*, in place of `old`:' book.md && [ ! -s said ] &&
    verdict "a piece says where it goes" yes || verdict "a piece says where it goes" no
    little; sed -i.old 's/little_c$/little_c little_d/' chapters/01-a.md; weave_little > book.md 2> said
    printf '%s\n' '*Stage 01a*, in place of `old`:' '' '[chapters/little/a.c, lines 13 to 16: new](chapters/little/a.c#L13-L16)' '[chapters/little/a.c, line 20: main](chapters/little/a.c#L20)' '' '```c' 'int new(void)' '{' '    return 2;' '}' '' 'int main(void) { return 0; }' '```' > wanted
    sed -n '/^.Stage 01a/,/^```$/p' book.md | cmp -s - wanted && [ ! -s said ] &&
    $awk -f "$root/chapters/check-book.awk" lib/*.h lib/*.c tests/oracle.[hc] chapters/little/*.c book.md > /dev/null 2>> said &&
    verdict "pieces that are typed together share a block" yes || verdict "pieces that are typed together share a block" no
    little; sed -i.old 's/little_c 01a/little_c 02a/' chapters/little/a.c
    refuses "a piece of no stage" weave_little 'chapters/little/a.c:12: 02a is no stage of stages.txt'

    # --- the weave ---
    sound; printf '\n@@ gone\n' >> chapters/01-a.md
    refuses "unknown region" weave 'chapters/01-a.md:11: there is no region gone'
    sound; printf '\n@@ head\n' >> chapters/02-b.md
    refuses "region used twice" weave 'chapters/02-b.md:19: region head is already pulled in by chapters/01-a.md, line 5'
    sound; sed -i.old '/@@ head/d' chapters/01-a.md
    refuses "region in no chapter, without a sentence" weave 'lib/a.c:1: region head is in no chapter, and has no sentence for the reference'
    sed -i.old 's|^//> head$|&\n//>   What a needs,\n//>   line by line:|' lib/a.c
    rm -rf pages; mkdir pages; pages=pages weave > book.md 2> said && check > /dev/null 2>> said &&
    printf '%s\n' 'From [line 2](../../lib/a.h#L2) of lib/a.h to line 2: [chapter 01](01-a.md).' '' 'What a needs, line by line:' '' '[lib/a.c, line 4](../../lib/a.c#L4)' '' '```c' '#include "a.h"' '```' '' 'From [line 8](../../lib/a.c#L8) of lib/a.c to line 12: [chapter 02](02-b.md).' > wanted &&
    sed -n '7,17p' pages/lib-a.md | cmp -s - wanted && grep -qF '[a](#a-line-by-line)' book.md &&
    verdict "what no chapter shows is in the reference" yes || verdict "what no chapter shows is in the reference" no
    sound; sed -i.old '/@@ body/d' chapters/02-b.md; sed -i.old 's|^//> body$|&\n//>   It returns one.|' lib/a.c
    weave > book.md 2> said; grep -v '^It returns one' book.md > other; mv other book.md; sed -i.old 's/return 1/return 2/' lib/a.c
    refuses "reference older than the code" check 'this is not line 10 of lib/a.c'
    sound; echo 'int b;' >> lib/a.c
    refuses "line in no region" weave 'lib/a.c:12: this line is in no region'
    sound; sed -i.old '$d' lib/a.c
    refuses "unclosed region" weave 'lib/a.c:5: region body is never closed'
    sound; sed -i.old '$d' lib/a.h
    refuses "region unclosed at the end of a file" weave 'lib/a.h:1: region one-line is never closed'
    sound; sed -i.old 's|^{|//> inner|' lib/a.c
    refuses "nested region" weave 'lib/a.c:7: region inner opens inside region body'
    sound; sed -i.old 's|//> one-line|//> body|; ' lib/a.h
    refuses "two regions of one name" weave 'lib/a.c:5: region body already stands in lib/a.h, line 1'
    sound; echo '//<' >> lib/a.c
    refuses "a close that closes nothing" weave 'lib/a.c:12: this closes no region'
    sound; sed -i.old '/include/d' lib/a.c
    refuses "empty region" weave 'lib/a.c:2: region head is empty'
    sound; sed -i.old 's|^{|  //> Inner|' lib/a.c
    refuses "malformed marker" weave 'lib/a.c:7: a marker is //> name or //<'
    sound; sed -i.old 's|@@ head|@@ head and more|' chapters/01-a.md
    refuses "malformed code line" weave 'chapters/01-a.md:5: there is no region and'
    sound; sed -i.old 's|@@ head|@@ head body|' chapters/01-a.md
    refuses "a block of two regions" weave 'chapters/01-a.md:5: only pieces of the little program share a block'
    sound; echo '```' >> chapters/01-a.md
    refuses "unclosed block" weave 'chapters/01-a.md:10: this ``` block is never closed'
    sound; echo '![p](figures/p.png)' >> chapters/01-a.md
    refuses "link that breaks in chapters/" weave 'chapters/01-a.md:10: a chapter links from its own folder'
    sound; echo '[C](03-c.md)' >> chapters/01-a.md
    refuses "link to no chapter" weave 'there is no chapter 03-c.md'

    sound; echo 'int b;' >> tests/oracle.c
    refuses "line of the oracle in no region" weave 'tests/oracle.c:4: this line is in no region'
    sound; sed -i.old '/@@ slow/d' chapters/02-b.md
    refuses "region of the oracle in no chapter" weave 'tests/oracle.c:1: region slow is in no chapter'
    sound; echo '%% figures/u.csv' >> chapters/01-a.md
    refuses "lost table" weave 'chapters/01-a.md:10: there is no file figures/u.csv'
    sound; echo '%% figures/t.csv and more' >> chapters/01-a.md
    refuses "malformed table line" weave 'chapters/01-a.md:10: a table is pulled in by %% figures/name.csv'
    sound; printf '#two| a,b\n0 1\n#one| x\n#two| 1,2\n' > figures/u.csv; echo '%% figures/u.csv two' >> chapters/01-a.md; weave > book.md
    printf '%s\n' '| a | b |' '|---|---|' '| 1 | 2 |' > wanted
    grep -A 4 '^.figures/u.csv, two.(figures/u.csv)$' book.md | tail -n 3 | cmp -s - wanted &&
    verdict "a named table is its own rows" yes || verdict "a named table is its own rows" no
    sed -i.old 's/1,2/1,3/' figures/u.csv
    refuses "named table older than its CSV" check 'this is not what figures/u.csv says now'
    sound; echo '%% figures/t.csv lost' >> chapters/01-a.md
    refuses "lost named table" weave 'chapters/01-a.md:10: there is no table lost in figures/t.csv'
    sound; echo '# nothing' > figures/t.csv
    refuses "empty table" weave 'chapters/02-b.md:9: there is no table in figures/t.csv'
    sound; echo '3,4,5' >> figures/t.csv
    refuses "ragged table" weave 'figures/t.csv:6: this row has 3 cells, the head has 2'
    sound; echo '3,a|b' >> figures/t.csv
    refuses "a cell that would end itself" weave 'figures/t.csv:6: a cell may hold no "'
    # Numbers in a sentence: two blocks, the second with commas, and a comment.
    numbers() {
        sound; mkdir -p figures/01
        printf '# strain 0.0123 with 10 steps\n# n cost "mean error"\n"a b" 1 2e-7\n"a c" 1234.5 8\n\n\nwhat,"error, mm"\nx,0.26\n' > figures/01/01-n.csv
        echo "$1" >> chapters/01-a.md
    }
    numbers 'A {{01-n; a b; mean error}}, {{01-n 0; a c; cost; 3}}, {{01-n 1; x; error, mm; 1 %}}.'
    weave > book.md; grep -qxF 'A $`2.0\cdot 10^{-7}`$, 1,230, 30 %.' book.md &&
    verdict "numbers are the CSV's" yes || verdict "numbers are the CSV's" no
    numbers 'B {{01-n; a c; cost / 01-n; a c; mean error; 4}}, {{01-n #; strain; %}}, {{01-n #; with}}.'
    weave > book.md; grep -qxF 'B 154.3, 1.2 %, 10.' book.md &&
    verdict "quotients and comments are the CSV's" yes || verdict "quotients and comments are the CSV's" no
    numbers '{{01-n 2; x; cost}}'; refuses "number of no block" weave 'chapters/01-a.md:10: in figures/01/01-n.csv, 2, 0 rows open with x'
    numbers '{{01-n; a; cost}}'; refuses "number of two rows" weave 'in figures/01/01-n.csv, 0, 2 rows open with a'
    numbers '{{01-n; a b; price}}'; refuses "number of no column" weave 'no number stands under price'
    numbers '{{01-n 1; x; what}}'; refuses "a cell that is no number" weave 'no number stands under what'
    numbers '{{01-n #; weight}}'; refuses "number in no comment" weave 'no comment of figures/01/01-n.csv has a number after weight'
    numbers 'C {{01-n #; steps .. error; 2}}{{claim: 01-n; a c; cost > 1000}}, {{01-n #; settled .. balls:}}.'; sed -i.old '1i # 3: settled; 50 balls: -0.25 m\
# with 12 steps: error 7' figures/01/01-n.csv
    weave > book.md; grep -qxF 'C 7.0, −0.25.' book.md &&
    verdict "words before words, signs and true claims" yes || verdict "words before words, signs and true claims" no
    numbers 'D {{01-n 1; x; error, mm; 3 mm}}, {{01-n 1; x; error, mm / 01-n 1; y; error, mm}}.'
    printf 'x,0.26 m\ny,130 mm\n' | cat figures/01/01-n.csv - | sed '/^x,0.26$/d' > u; mv u figures/01/01-n.csv
    weave > book.md; grep -qxF 'D 260 mm, 2.0.' book.md &&
    verdict "units are one" yes || verdict "units are one" no
    numbers '{{01-n 1; x; error, mm; 3 mm}}'; refuses "a unit of nothing" weave 'has no unit to become mm'
    numbers '{{01-n #; settled; 50 balls:; 2}}'; sed -i.old '1i # 3: settled; 50 balls: 0.25 m' figures/01/01-n.csv
    refuses "separator in a key" weave '{{01-n #; settled; 50 balls:}} has 3 fields'
    numbers '{{01-n; a b; c; cost}}'; refuses "separator in a row" weave '{{01-n; a b; c; cost}} has 4 fields'
    numbers '{{01-n #; with}}'; sed -i.old '1i # with 9' figures/01/01-n.csv
    refuses "words that stand twice" weave 'the comments of figures/01/01-n.csv have with 2 times'
    numbers '{{01-n #; gcc}}'; sed -i.old '1i # gcc 12.2.0' figures/01/01-n.csv
    refuses "a version for a number" weave 'what follows gcc in the comments of figures/01/01-n.csv is no number'
    numbers '{{01-n; a c; cost}}'; sed -i.old 's/1234.5/3x/' figures/01/01-n.csv
    refuses "text for a number" weave 'no number stands under cost'
    numbers '{{01-n; a c; cost}}'; sed -i.old 's/1234.5/nan/' figures/01/01-n.csv
    refuses "no number for a number" weave 'no number stands under cost'
    numbers '{{claim: 01-n; a c; cost < 1000}}'; refuses "a false claim" weave 'this is not so: 01-n; a c; cost < 1000 (1234.5 and 1000)'
    numbers '{{claim: 01-n; a c; cost}}'; refuses "a claim of nothing" weave 'a claim is a < b or a > b'
    numbers '{{01-m; a; cost}}'; refuses "number of no file" weave 'there is no file figures/01/01-m.csv'

    # --- the finished book ---
    sound; weave > book.md; sed -i.old 's/return 1/return 2/' book.md
    refuses "changed code" check 'this is not line 9 of lib/a.c'
    sound; weave > book.md; sed -i.old 's/return 1/return 2/' lib/a.c
    refuses "changed library" check 'this is not line 9 of lib/a.c'
    sound; weave > book.md; echo 'int b;' >> lib/a.c
    refuses "line not in the book" check 'lib/a.c:12: this line is not in the book'
    sound; weave > book.md; grep -v 'a.h' book.md > b; mv b book.md
    refuses "lost caption" check 'lib/a.h:2: this line is not in the book'
    sound; weave > book.md; tail -n 20 book.md > b; cat b >> book.md
    refuses "code shown twice" check 'was shown before'
    sound; weave > book.md; sed -i.old 's/#L6-L10/#L6-L11/' book.md
    refuses "wrong link in a caption" check 'the caption and its link disagree'
    sound; weave > book.md; sed -i.old 's/to 10: a]/to 10: b]/' book.md
    refuses "a function that is not there" check 'b is not in these lines of lib/a.c'
    sound; weave > book.md; sed -i.old 's/lines 6 to 10/lines 6 to 9/; s/#L6-L10/#L6-L9/' book.md
    refuses "block longer than claimed" check 'here the block of code should close'
    sound; weave > book.md; sed -i.old 's/mean/rms/' figures/t.csv
    refuses "table older than its CSV" check 'book.md:43: this is not what figures/t.csv says now'
    sound; weave > book.md; echo '3,4' >> figures/t.csv
    refuses "row missing in a table" check 'book.md:45: here a row of figures/t.csv is missing'
    sound; weave > book.md; sed -i.old '$d' figures/t.csv
    refuses "row too many in a table" check 'book.md:44: this is not what figures/t.csv says now'
    sound; weave > book.md; rm figures/t.csv
    refuses "lost CSV" check 'there is no file figures/t.csv'
    sound; weave > book.md; echo 'int b;' >> tests/oracle.c
    refuses "line of the oracle not in the book" check 'tests/oracle.c:4: this line is not in the book'
    sound; weave > book.md; rm figures/p.png
    refuses "lost picture" check 'there is no file figures/p.png'
    sound; weave > book.md; sed -i.old 's/^## The code/## Code/' book.md
    refuses "lost heading" check 'no heading has the anchor #the-code'
    sound; rm -f book.md; : > book.md
    refuses "empty book" check 'there is no book'
    cd "$root" || exit 1
}

awks=
for awk in $(sh tests/script/awks.sh); do
    awks="$awks $awk"; all
done
echo "weave and check-book: $tests trials ($awks ), $failed failed"
[ $failed -eq 0 ]
