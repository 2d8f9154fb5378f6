# check_follow.sh - does make tell a reader how far he is, and what is next?
# Each trial sets up a small course, runs a command, and wants its sentence.

export LC_ALL=C
unset MAKEFLAGS MFLAGS      # a make that called us must not hand down its own
tree=$(mktemp -d)
watcher=
trap '[ -z "$watcher" ] || kill -s TERM -- -$watcher 2> /dev/null; rm -rf "$tree"' EXIT
EXERCISES=$tree/exercises; export EXERCISES
CHAPTERS=$tree/chapters; export CHAPTERS
BUILD=$tree/build; export BUILD
trials=0 failed=0

# A course of three chapters: two exercises in 01, one in 02, none in 03.
course() {
    rm -rf "$tree"; mkdir -p "$EXERCISES" "$CHAPTERS"
    for each in 01/sum 01/more 02/root; do
        dir=$EXERCISES/${each%/*}-${each#*/}
        mkdir "$dir"
        echo 'after  vec3' > "$dir/exercise"
        echo "# $each: about ${each#*/}" > "$dir/README.md"
    done
    # The chapter tells of them from the easy to the hard, not from A to Z.
    printf '# 01. Sums\n\n`make exercise 01/sum`\n\n`make exercise 01/more`\n' > "$CHAPTERS/01-sums.md"
    printf '# 02. Roots\n\n`make exercise 02/root`\n' > "$CHAPTERS/02-roots.md"
    printf '# 03. The end\n' > "$CHAPTERS/03-end.md"
}
begin() { : > "$EXERCISES/$1/mine.c"; }
progress=$EXERCISES/progress.txt

verdict() {     # NAME, and whether it went well
    trials=$((trials + 1))
    [ "$2" = yes ] || { failed=$((failed + 1)); echo "follow: $1: FAILED"; cat "$tree/said"; }
}
# says NAME SENTENCE COMMAND...: the command is content, and says so.
says() {
    name=$1 sentence=$2; shift 2
    if "$@" > "$tree/said" 2>&1 && grep -qF -- "$sentence" "$tree/said"
    then verdict "$name" yes; else verdict "$name" no; fi
}
refuses() {     # NAME SENTENCE COMMAND...
    name=$1 sentence=$2; shift 2
    if "$@" > "$tree/said" 2>&1; then verdict "$name" no; else also "$name" "$sentence"; fi
}
# also NAME SENTENCE: it said this, too.
also() { if grep -qF -- "$2" "$tree/said"; then verdict "$1" yes; else verdict "$1" no; fi; }
run() { sh exercises/run.sh "$@"; }

# ---- the end of make NN

course
says "a chapter names its file" "Chapter 01, Sums: $CHAPTERS/01-sums.md" run chapter 01
also "an exercise not begun"    'not begun         01/sum         about sum'
also "read first, then write"   "Next: read chapter 01 in book.md, and then  make exercise 01/sum"
begin 01-more
says "one that is begun"        'begun             01/more' run chapter 01
also "it is gone on with"       'Next: go on with  make exercise 01/more  (about more)'
echo '01/more passed 2026-11-21' > "$progress"
says "one that passed"          'passed 2026-11-21 01/more        about more' run chapter 01
also "then the other"           'Next: make exercise 01/sum  (about sum)'
echo '01/sum passed 2026-11-22' >> "$progress"
says "all passed: next chapter" "Next: chapter 02, Roots: read it in book.md, and  make 02" run chapter 01
says "each chapter has its own" 'not begun         02/root' run chapter 02
if grep -q '01/' "$tree/said"; then verdict "and no others" no; else verdict "and no others" yes; fi
says "no exercises"             'It has no exercises.' run chapter 03
also "the end"                  'This was the last chapter.'
if run chapter 04 > "$tree/said" 2>&1; then verdict "no such chapter" no; else also "no such chapter" 'There is no chapter 04: there are 01 to 03.'; fi

# A chapter that came later has a letter: 01b stands between 01 and 02.
later() {
    course
    dir=$EXERCISES/01b-carry; mkdir "$dir"
    echo 'after  vec3' > "$dir/exercise"; echo '# 01b/carry: about carry' > "$dir/README.md"
    printf '# 01b. Carrying\n\n`make exercise 01b/carry`\n' > "$CHAPTERS/01b-carrying.md"
}
later
printf '01/sum passed 2026-11-21\n01/more passed 2026-11-21\n' > "$progress"
says "a letter is next"         'Next: chapter 01b, Carrying: read it in book.md, and  make 01b' run chapter 01
if grep -q '01b/' "$tree/said"; then verdict "and is another chapter" no; else verdict "and is another chapter" yes; fi
says "it is a chapter"          'not begun         01b/carry' run chapter 01b
also "with its title"           "Chapter 01b, Carrying: $CHAPTERS/01b-carrying.md"
says "its own list"             '[ ] 01b/carry' run exercise 01b
if grep -q '] 01/' "$tree/said"; then verdict "without its neighbour's" no; else verdict "without its neighbour's" yes; fi
says "its neighbour's"          '[x] 01/sum' run exercise 01
if grep -q '] 01b/' "$tree/said"; then verdict "without its own" no; else verdict "without its own" yes; fi
refuses "of which of it"        'For example:  make hint 01b/carry' run hint 01b
echo '01b/carry passed 2026-11-22' >> "$progress"
says "then the next number"     'Next: chapter 02, Roots' run chapter 01b
says "its bar"                  '01b Carrying                             ####################  1 of 1' run progress
says "all, in the book's order" '01/sum 01/more 01b/carry 02/root' sh -c '. exercises/judge.sh; echo $(names)'

# ---- progress.txt, and make progress

course; begin 01-more
says "no file yet"              '01 Sums                                  ----------..........  0 of 2' run progress
also "one begun is gone on with" 'Next: go on with  make exercise 01/more'
printf '# my own\n\n  01/sum\tpassed 2026-11-21\r\n01/more pased 2026-11-21\n02/roots passed 2026-11-21\n01/sum passed 2026-11-23  # again\n' > "$progress"
says "one passed, one begun"    '01 Sums                                  ##########----------  1 of 2' run progress
also "none of another chapter"  '02 Roots                                 ....................  0 of 1'
also "a chapter without"        '03 The end                               no exercises'
also "all chapters"             'all                                      ######-------.......  1 of 3'
also "a line that is no line"   "$progress, line 4: this cannot be read, and is left as it is"
also "no such exercise"         "$progress, line 5: there is no exercise 02/roots"
if [ "$(grep -c ', line ' "$tree/said")" = 2 ]; then verdict "no other line is told" yes; else verdict "no other line is told" no; fi
says "the first day counts"     'passed 2026-11-21 01/sum ' run chapter 01
says "a list knows it, too"     '[x] 01/sum' run exercise
says "a chapter's list"         '[ ] 02/root' run exercise 02
if grep -q '01/sum ' "$tree/said"; then verdict "and no others in it" no; else verdict "and no others in it" yes; fi
says "a chapter without any"    'Chapter 03 has no exercises with tests.' run exercise 03

# The runner writes it, and takes out what begins again.
judged() { sh -c '. exercises/judge.sh; . exercises/follow.sh; $1 "$2"' sh "$@"; }
printf '04/no passed 2026-11-21\nkeep me\n01/sum passed 2026-11-20\n02/root' > "$progress"
judged write_passed 01/more
judged write_passed 01/sum
printf '04/no passed 2026-11-21\nkeep me\n01/sum passed 2026-11-20\n02/root\n01/more passed %s\n' "$(date +%Y-%m-%d)" > "$tree/said"
if cmp -s "$progress" "$tree/said"; then verdict "what passes is added, once" yes; else verdict "what passes is added, once" no; fi
judged forget_passed 01/sum
sed '/01.sum/d' "$tree/said" > "$tree/less"
if cmp -s "$progress" "$tree/less"; then verdict "what begins again is taken out" yes; else verdict "what begins again is taken out" no; fi
rm "$progress"; judged write_passed 01/sum
says "a new file says whose it is" 'This file is yours' cat "$progress"
also "and what passed"          "01/sum passed $(date +%Y-%m-%d)"
rm "$progress"; mkdir "$progress"
says "a file that cannot be"    'that 01/sum passed is not kept' judged write_passed 01/sum

unset EXERCISES CHAPTERS
says "make ends with it"        'Chapter 22, What the paper got wrong: chapters/22-errata.md' make -s 22
says "make progress"            '04 GJK ' make -s progress
says "of a chapter"             'Chapter 04, GJK: chapters/04-gjk.md' make -s progress 04

# ---- make watch: it runs, runs again when a file is saved, and ends with Ctrl-C.
# A shell starts what is in the background deaf to INT: env opens its ears, and
# setsid gives it a group of its own, as a terminal does.

says_after() {  # NAME SENTENCE: in the end it says so.
    tries=0
    until grep -qF -- "$2" "$tree/said"; do
        tries=$((tries + 1))
        [ $tries -lt 300 ] || { verdict "$1" no; return; }
        sleep 0.1
    done
    verdict "$1" yes
}
watch() {
    : > "$tree/said"
    setsid env --default-signal=INT make CFLAGS=-O0 BUILD="$tree/build" watch "$@" > "$tree/said" 2>&1 &
    watcher=$!
}
interrupt() {   # NAME
    kill -s INT -- -$watcher
    wait $watcher
    tries=0     # make does not always wait for its own
    while kill -s 0 -- -$watcher 2> /dev/null && [ $tries -lt 50 ]; do tries=$((tries + 1)); sleep 0.1; done
    # (Ctrl-C reaches make and its children at once; one that lost them says so.)
    if [ $tries -eq 50 ] || grep '\*\*\*' "$tree/said" | grep -qv 'No child processes\|Waiting for unfinished' || [ -n "$(ls "$TMPDIR")" ]
    then verdict "$1" no; else verdict "$1" yes; fi
}
if command -v setsid > /dev/null && env --default-signal=INT true 2> /dev/null; then
    TMPDIR=$tree/temporary; export TMPDIR
    mkdir "$TMPDIR"
    cp lib/particles/verlet.c "$tree/verlet.c"
    mine=$tree/exercises/01-sum/mine.c
    EXERCISES=$tree/exercises watch 01 MINE="$tree/verlet.c"
    says_after "it begins at once"      'Watching; Ctrl-C ends it.'
    also "with the tests"               'All passed: 1 programs'
    sleep 2.2
    if [ "$(grep -c '^----' "$tree/said")" = 1 ]; then verdict "and waits" yes; else verdict "and waits" no; fi
    sed 's|last_move, dt \* dt, a|last_move, -dt * dt, a|' lib/particles/verlet.c > "$tree/verlet.c"
    says_after "a save is seen"         'FAILED: check_verlet'
    : > "$tree/said"
    cp lib/particles/verlet.c "$tree/verlet.c"
    says_after "and the next one"       'All passed: 1 programs'
    : > "$mine"
    says_after "so is an exercise"      '01/sum: the tests could not be built'
    sleep 1     # that failed, and is over
    : > "$tree/said"
    interrupt "Ctrl-C ends it"
fi
refuses "one that is not there" 'There is no exercise 01/none' make exercise 01/none
if grep -qF '***' "$tree/said"; then verdict "make adds no word" no; else verdict "make adds no word" yes; fi
for name in 99/x nope 9 00/; do
    refuses "nor is $name"      "There is no exercise $name:" make hint $name
    if grep -qF '***' "$tree/said"; then verdict "no word about $name" no; else verdict "no word about $name" yes; fi
done
refuses "a nought is missing"   'There is no exercise 4/search; did you mean  make hint 04/search?' make hint 4/search
refuses "no such chapter"       'There is no chapter 99: there are 00 to ' make hint 99
if [ "$(grep -vc '^make' "$tree/said")" = 1 ]; then verdict "and no list" yes; else verdict "and no list" no; fi
refuses "the sentence is last"  'There is no exercise 04/none' make exercise 04/none
if [ "$(wc -l < "$tree/said")" -lt 9 ]; then verdict "and near" yes; else verdict "and near" no; fi
refuses "nor any bar for it"    'There is no chapter 99: there are 00 to ' make progress 99
refuses "nor its tests"         'There is no chapter 99: there are 00 to ' make -s watch 99
refuses "a hint for nothing"    'Of which exercise?  For example:  make hint 01/step' make hint
refuses "of which of the chapter"  'Of which exercise?  For example:  make hint 04/' make hint 04
if grep -q '  cc  \|  link' "$tree/said"; then verdict "and builds none" no; else verdict "and builds none" yes; fi
if make exercise 01/step 01/drag > "$tree/said" 2>&1; then verdict "two at a time" no; else also "two at a time" 'One exercise at a time.'; fi
says "on paper nothing is run" 'exercises/run.sh reset' make -n reset 01/step
says "what is well ends well"  '[ ] 01/step' make exercise 01
refuses "watch what?"     'Watch which chapter or exercise?' make -s watch
refuses "no such one"     'There is no exercise 01/none'     make -s watch 01/none

echo "the reader's way: $trials trials, $failed failed"
[ $failed -eq 0 ]
