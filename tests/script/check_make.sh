# check_make.sh - does make refuse in a sentence, before it does any work: a command
# that there is none of, a name that is more than one, a tool that is missing, a
# place that cannot be written?  And does it know every command of the workflows?

export LC_ALL=C
unset MAKEFLAGS MFLAGS MAKELEVEL  # a make that called us must not hand down its own
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
trials=0 failed=0

# refuses SENTENCE GOAL...: make fails, this stands at its beginning, and nothing
# was compiled, linked, drawn or woven.
# Rejects: exit status 0; work that a sentence at the end makes vain.
refuses() {
    trials=$((trials + 1)) sentence=$1 why=; shift
    make "$@" > "$place/said" 2>&1 < /dev/null && why='is content'
    head -n 2 "$place/said" | grep -qF -- "$sentence" || why="does not begin with: $sentence"
    ! grep -q '^  [a-z+]*  \|^book.md' "$place/said" || why="works first"
    [ -z "$why" ] && return
    failed=$((failed + 1))
    echo "check_make: make $* $why"; cat "$place/said"
}

# ---- A command that there is none of

refuses 'did you mean  make 04?'        4
refuses 'did you mean  make test-04?'   test-4
refuses 'did you mean  make figure-04?' figure-4
refuses 'did you mean  make library?'   libary
refuses 'did you mean  make exercise 04/search?' 04/search
refuses 'There is no chapter 99: there are 00 to ' 99
refuses 'There is no chapter 99: there are 00 to ' test-99
refuses 'There is no chapter 99: there are 00 to ' figure-99
refuses 'There is no figure 04-rulez: figure-04-' figure-04-rulez
refuses 'There is no figure 99-x: chapter 99 has none.' figure-99-x
refuses 'did you mean  make figures?'  figur
refuses 'did you mean  make exercise?' exercises
refuses 'did you mean  make test?'     tests
refuses 'did you mean  make library?'  lib
refuses 'did you mean  make book?'     chapters
refuses 'no command and no file nosuch' nosuch

# ---- A name that make or the shell would take for more: nothing of it is run

newline='
'
for sign in ';' '&' '|' '<' '>' '`' '$(' "'" '"' '*' '#' ':' '%' '\' ' ;' "$newline"; do
    refuses 'has no such sign' exercise "01/step${sign}touch $place/run"
done
refuses 'has no such sign' "nosuch;touch $place/run"
[ ! -e "$place/run" ] || { failed=$((failed + 1)); echo "check_make: a name was run"; }

# ---- Tools: a path, folder by folder, on which all stand but these

path=$PATH bare=
for at in $(echo "$path" | tr : ' '); do
    mkdir -p "$place/path$at"
    ln -s "$at"/* "$place/path$at" 2> /dev/null
    bare=$bare${bare:+:}$place/path$at
done
for tool in gnuplot node npm cwebp webpmux img2webp clang wasm-ld pandoc chromium \
            chromium-browser google-chrome valgrind; do find "$place/path" -name $tool -delete; done
PATH=$bare
for goal in demo 04 figure-04 figure-04-rules charts chart-piles speed; do
    refuses 'This needs gnuplot-nox (names of Debian and Ubuntu): make deps installs it.' "$goal"
done
for goal in html pdf epub; do refuses 'This needs pandoc webp' "$goal"; done
refuses 'nodejs npm webp (names of Debian and Ubuntu): make deps-site installs it.' site
refuses 'This needs nodejs chromium webp' test-site
refuses 'This needs webp'     moving
refuses 'This needs clang libclang-rt-dev (names' fuzz
refuses 'make deps-dev'       fuzz
refuses 'This needs clang'    strict
refuses 'This needs clang'    bits
refuses 'This needs valgrind' valgrind
PATH=$path

# ---- Places

refuses 'PREFIX=here: this must begin with /'      install PREFIX=here
refuses 'PREFIX=/a b: this must begin with /'      install PREFIX='/a b'
refuses 'PREFIX=: this must begin with /'          uninstall PREFIX=
refuses 'LIBDIR=lib64: this must begin with /'     install LIBDIR=lib64
: > "$place/file"
refuses "$place/file/lib/pkgconfig cannot be written" install PREFIX="$place/file"
refuses "$place/file/build cannot be written: is this folder yours?" library BUILD="$place/file/build"

# ---- Workflows: their commands are ours, and a release runs what is too long for
# every push.

runs=$(sed -n 's/^ *- run: g\{0,1\}make //p' .github/workflows/*.yml | sed 's/[$]{{ matrix.cc }}/cc/; s/[$]{{ steps[^}]*}}//; s/ *#.*//')
echo "$runs" | while read -r goals; do
    # shellcheck disable=SC2086
    make -n $goals > "$place/said" 2>&1 < /dev/null && ! grep -q meant.sh "$place/said" && continue
    echo "check_make: a workflow runs  make $goals"; cat "$place/said"
done > "$place/workflows"
for goal in hard check-exercises test-site; do
    grep -q "run: make.* $goal\( \|$\)" .github/workflows/release.yml ||
        echo "check_make: no release runs  make $goal"
done >> "$place/workflows"
trials=$((trials + $(echo "$runs" | wc -l) + 3))
failed=$((failed + $(grep -c '^check_make' "$place/workflows")))
cat "$place/workflows"

echo "make: $trials trials, $failed failed"
[ $failed -eq 0 ]
