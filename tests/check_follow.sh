# check_follow.sh - does make tell a reader how far he is, and what is next?
# Each trial sets up a small course, runs a command, and wants its sentence.

export LC_ALL=C
unset MAKEFLAGS MFLAGS      # a make that called us must not hand down its own
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
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
pass() { begin "$1"; : > "$EXERCISES/$1/mine.passed"; }

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
# also NAME SENTENCE: it said this, too.
also() { if grep -qF -- "$2" "$tree/said"; then verdict "$1" yes; else verdict "$1" no; fi; }
run() { sh exercises/run.sh "$@"; }

# ---- the end of make NN

course
says "a chapter names its file" "Chapter 01, Sums: $CHAPTERS/01-sums.md" run chapter 01
also "an exercise not begun"    'not begun  01/sum         about sum'
also "read first, then write"   "Next: read $CHAPTERS/01-sums.md, and then  make exercise 01/sum"
begin 01-more
says "one that is begun"        'begun      01/more' run chapter 01
also "it is gone on with"       'Next: go on with  make exercise 01/more  (about more)'
pass 01-more
says "one that passed"          'passed     01/more' run chapter 01
also "then the other"           'Next: make exercise 01/sum  (about sum)'
pass 01-sum
says "all passed: next chapter" "Next: chapter 02, Roots: read $CHAPTERS/02-roots.md, and  make 02" run chapter 01
says "each chapter has its own" 'not begun  02/root' run chapter 02
if grep -q '01/' "$tree/said"; then verdict "and no others" no; else verdict "and no others" yes; fi
says "no exercises"             'It has no exercises.' run chapter 03
also "the end"                  'This was the last chapter.'
if run chapter 04 > "$tree/said" 2>&1; then verdict "no such chapter" no; else also "no such chapter" 'There is no chapter 04.'; fi
unset EXERCISES CHAPTERS
says "make ends with it"        'Chapter 17, What the paper got wrong: chapters/17-errata.md' make -s 17

echo "the reader's way: $trials trials, $failed failed"
[ $failed -eq 0 ]
