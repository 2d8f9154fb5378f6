# check_swap.sh - does MINE= put a reader's module in the place of ours, and only
# there?  Modules that are wrong on purpose must be seen by the tests, whatever
# was built before; files that cannot stand in are refused with a sentence.

export LC_ALL=C
unset MAKEFLAGS MFLAGS      # a make that called us must not hand down its own
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/a" "$tree/b"
PROGRESS=$tree/progress.txt; export PROGRESS
trials=0 failed=0

verdict() {     # NAME, and whether it went well
    trials=$((trials + 1))
    [ "$2" = yes ] || { failed=$((failed + 1)); echo "swap: $1: FAILED"; cat "$tree/said"; }
}
build() { make -s BUILD="$tree/build" "$@" > "$tree/said" 2>&1; }
# says NAME SENTENCE COMMAND...; refuses is the same, of one that must fail.
says() {
    name=$1 sentence=$2; shift 2
    if "$@" && grep -qF -- "$sentence" "$tree/said"; then verdict "$name" yes; else verdict "$name" no; fi
}
refuses() {
    name=$1 sentence=$2; shift 2
    if "$@" || ! grep -qF -- "$sentence" "$tree/said"; then verdict "$name" no; else verdict "$name" yes; fi
}

# a: like ours.  b: it falls upwards; made before a is built, so it is older.
wrong() { sed 's|last_move, dt \* dt, a|last_move, -dt * dt, a|' lib/particles/verlet.c; }
wrong > "$tree/b/verlet.c"
sleep 0.01
cp lib/particles/verlet.c lib/particles/constraint.c "$tree/a"
# also NAME SENTENCE: it said this, too.
also() { if grep -qF -- "$2" "$tree/said"; then verdict "$1" yes; else verdict "$1" no; fi; }

# What is ours is built already: it is copied, but the module that is tried.
ours=${BUILD:-build} ours=${ours%/swapped}
make -s library BUILD="$ours" > "$tree/said" 2>&1 || { cat "$tree/said"; exit 1; }
mkdir -p "$tree/build/tests" "$tree/build/figures"
cp -Rp "$ours/lib" "$ours/flags" "$tree/build"
cp -p "$ours"/tests/check_verlet.o "$ours"/tests/check_constraint.o "$ours"/tests/scarce.o "$ours"/tests/poses.o "$ours"/tests/experiments.o "$tree/build/tests" 2> /dev/null
cp -p "$ours"/figures/*.o "$tree/build/figures" 2> /dev/null
rm -f "$tree/build/lib/verlet.o" "$tree/build/lib/verlet.d"

refuses "a wrong module is seen"    'FAILED: check_verlet'  build test-01 MINE="$tree/b/verlet.c"
also    "and how many tests"        "check_verlet: 12 of 24 tests pass with $tree/b/verlet.c.  These do not:"
also    "which, and where"          "  force_and_gravity_add_up  (tests/particles/check_verlet.c, line $(sed -n '/(force_and_gravity/=' tests/particles/check_verlet.c))"
also    "and what it wanted"        '  x: got -1.875, wanted 1.5'
also    "and the test's comment"    '      Rejects: '
if [ -e "$PROGRESS" ]; then verdict "it counts for nothing" no; else verdict "it counts for nothing" yes; fi
if grep -q ':F:\|Running suite' "$tree/said"; then verdict "and no line of Check's" no; else verdict "and no line of Check's" yes; fi
says    "a right one passes"        'All passed: 1 programs' build test-01 MINE="$tree/a/verlet.c"
also    "with its name"             "check_verlet: all 24 tests pass with $tree/a/verlet.c."
also    "it counts for its exercises" "It counts for its exercises: $(grep -lx 'module *verlet' exercises/*/exercise | head -n 1 | sed 's/.*s.\(..\)-\(.*\).exercise/\1\/\2/')"
if grep -q '^01/step passed' "$PROGRESS"; then verdict "and that is kept" yes; else verdict "and that is kept" no; fi
refuses "the older one is seen"     'FAILED: check_verlet'  build test-01 MINE="$tree/b/verlet.c"
wrong > "$tree/a/verlet.c"
refuses "a change is seen"          'FAILED: check_verlet'  build test-01 MINE="$tree/a/verlet.c"
if [ -e "$tree/build/lib/verlet.o" ]; then verdict "ours is not touched" no; else verdict "ours is not touched" yes; fi
sed 's|^    assert(n >= 0 .. dt > 0|    abort();\n&|; 1i #include <stdlib.h>' lib/particles/verlet.c > "$tree/b/verlet.c"
refuses "one that stops"            'It stops the program: Aborted.' build test-01 MINE="$tree/b/verlet.c"
refuses "stops the demo"            "The scene cloth-on-cube fails with $tree/b/verlet.c" build demo DEMO=cloth-on-cube MINE="$tree/b/verlet.c"
wrong > "$tree/b/verlet.c"
says    "without it, ours is back"  'All passed: 1 programs' build test-01
says    "several files"             'All passed: 1 programs' build test-02 MINE="$tree/a/constraint.c lib/particles/verlet.c"
refuses "of two, the wrong one"     'FAILED: check_constraint' build test-02 MINE="$tree/a/constraint.c $tree/b/verlet.c"
says    "one goes, ours is back"    'All passed: 1 programs' build test-02 MINE="$tree/a/constraint.c"

# The whole system: a module that speaks up.
{ cat lib/particles/verlet.c; printf '#include <stdio.h>\n__attribute__((constructor)) static void speak(void) { puts("verlet of my own"); }\n'; } > "$tree/a/verlet.c"
says    "the command has it"        ''  build "$tree/build/swapped/tumble" MINE="$tree/a/verlet.c"
"$tree/build/swapped/tumble" room --bodies 2 --seconds 0.1 > "$tree/said" 2>&1
says    "and runs it"               'verlet of my own' grep -q 'largest strain' "$tree/said"
says    "the demo runs that"        "$tree/build/swapped/tumble \$scene" build -n demo MINE="$tree/a/verlet.c"

# ---- what cannot stand in
mkdir "$tree/a/distance.c"
: > "$tree/a/verlt.c"
echo 'int x(' > "$tree/a/body.c"
refuses "no such file"      "$tree/a/gone.c: there is no such file"   build test-04 MINE="$tree/a/gone.c"
refuses "a folder"          "$tree/a/distance.c: this is a folder"         build test-04 MINE="$tree/a/distance.c"
refuses "no such module"    "$tree/a/verlt.c: no module of lib/ has that name" build test-04 MINE="$tree/a/verlt.c"
refuses "two for one"       'two files for one module'                build test-04 MINE="$tree/a/verlet.c $tree/b/verlet.c"
refuses "a later chapter's" "lib/query/manifold.c: its module comes after chapter 03" build test-03 MINE=lib/query/manifold.c
refuses "no C"              "$tree/a/body.c: does not compile"         build test-03 MINE="$tree/a/body.c"

echo "modules swapped in: $trials trials, $failed failed"
[ $failed -eq 0 ]
