# check_exercises.sh - is every exercise sound (exercises/check.sh), and are the
# checker and the reader's runner to be trusted?  They are shown exercises that are
# broken on purpose, and code with the accidents that befall a reader; each trial
# wants its sentence.  Of each exercise make test-course tries two wrong variants, and
# make check-exercises all (WRONGS=).

export LC_ALL=C
tree=$(mktemp -d)
WRONGS=${WRONGS-2} sh exercises/check.sh > "$tree/sound" 2>&1 &
real=$!
trap 'kill $real 2> /dev/null; rm -rf "$tree"' EXIT

unset WRONGS
EXERCISES=$tree; export EXERCISES
CHAPTERS=$tree; export CHAPTERS
BUILD=$tree/build; export BUILD
JUDGE_SECONDS=0.2; export JUDGE_SECONDS
dir=$tree/99-sum
trials=0 failed=0 which=''

# A sound exercise: add up n numbers.
sound() {
    rm -rf "$dir"; mkdir -p "$dir"
    printf 'after  vec3\nempty  sum\n' > "$dir/exercise"
    printf '# 99/sum: adding up\n\n' > "$dir/README.md"
    for i in 1 2 3 4 5 6 7 8; do echo "Write sum, which adds up numbers."; done >> "$dir/README.md"
    printf '1. Begin at zero, and go on.\n2. Take one number after another.\n3. Stop when you have had n.\n' > "$dir/hints"
    printf '#include "vec3.h"\n\nreal sum(const real *x, int n);\n' > "$dir/sum.h"
    cat > "$dir/solution.c" <<'END'
#include "sum.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

int spare = 1;

real sum(const real *x, int n)
{
    real all = 0;
    spare = 1;
    for (int i = 0; i < n; i++) all += x[i];
    return all;
}
END
    cat > "$dir/check.c" <<'END'
#include "sum.h"
#include "suite.h"
static const real some[3] = { 1, 2, 3 };
START_TEST(three_numbers_add_up)
{
    // Rejects: a difference.
    real got = sum(some, 3);
    ck_assert_msg(got == 6, "got %g, wanted 6", got);
}
END_TEST
START_TEST(no_number_is_zero)
{
    ck_assert(sum(some, 0) == 0);
}
END_TEST
int main(void)
{
    const TTest *const tests[] = {
        three_numbers_add_up,
        no_number_is_zero,
        NULL
    };
    return suite_run((suite){ .name = "sum", .tests = tests });
}
END
    cat > "$dir/wrong" <<'END'
wrong  a difference
test   three_numbers_add_up
-      for (int i = 0; i < n; i++) all += x[i];
+      for (int i = 0; i < n; i++) all -= x[i];
wrong  one past the end
test   three_numbers_add_up
-      for (int i = 0; i < n; i++) all += x[i];
+      for (int i = 0; i <= n; i++) all += x[i];
wrong  it begins at one
test   no_number_is_zero
-      real all = 0;
+      real all = 1;
END
}

verdict() {     # NAME, and whether it went well
    trials=$((trials + 1))
    [ "$2" = yes ] || { failed=$((failed + 1)); which="$which; $1"; echo "exercises: $1: FAILED"; cat "$tree/said"; }
}
# accepts NAME: the checker finds nothing.
accepts() {
    if sh exercises/check.sh 99/sum > "$tree/said" 2>&1; then verdict "$1" yes; else verdict "$1" no; fi
}
# refuses NAME SENTENCE: the checker fails, and says so.
refuses() {
    if sh exercises/check.sh 99/sum > "$tree/said" 2>&1 || ! grep -qF -- "$2" "$tree/said"
    then verdict "$1" no; else verdict "$1" yes; fi
}
change() { sed "$2" "$dir/$1" > "$dir/new" && mv "$dir/new" "$dir/$1"; }

# tells NAME SENTENCE LINE: a reader's sum, with this line in the place of its loop.
tells() {
    sed "s|^    for (int i = 0.*|    $3|" "$dir/solution.c" > "$dir/mine.c"
    if sh exercises/run.sh exercise 99/sum > "$tree/said" 2>&1 || ! grep -qF -- "$2" "$tree/said"
    then verdict "$1" no; else verdict "$1" yes; fi
}
# also NAME SENTENCE: it said this, too.
also() { if grep -qF -- "$2" "$tree/said"; then verdict "$1" yes; else verdict "$1" no; fi; }
# answers NAME SENTENCE COMMAND...: the runner is content, and says so.
answers() {
    name=$1 sentence=$2; shift 2
    if echo "$reply" | sh exercises/run.sh "$@" > "$tree/said" 2>&1 && grep -qF -- "$sentence" "$tree/said"
    then verdict "$name" yes; else verdict "$name" no; fi
}

# ---- the checker

sound; accepts "a sound exercise is sound"
accepts "and is not tried again"
also "and that is said" 'as before'
sound; change wrong 's/i <= n/n > i/'
refuses "a wrong variant that is right" 'wrong 2 (one past the end) is not rejected by three_numbers_add_up'
sound; change wrong '/one past/,/it begins/s/three_numbers_add_up/no_such_test/'
refuses "a test that is not there" 'wrong 2 (one past the end) names the test no_such_test'
sound; change wrong '1,4s/three_numbers_add_up/no_number_is_zero/'
refuses "rejected, but by another test" 'wrong 1 (a difference) is not rejected by no_number_is_zero'
sound; change solution.c 's/real all = 0/real all = 0.0/'
refuses "a solution that has moved away" 'wrong 3 (it begins at one) changes lines that stand there 0 times'
sound; echo 'real all = 0;' >> "$dir/solution.c"
refuses "a line that stands there twice" 'changes lines that stand there 2 times'
sound; change wrong 's/^-      real all = 0;/-  int spare = 1;/; s/^+      real all = 1;/+  int spare = 2;/'
refuses "a change of what is not the reader's" "wrong 3 (it begins at one) changes what is not the reader's to write"
sound; change wrong 's/all -= x/all -= y/'
refuses "a wrong variant that does not compile" 'wrong 1 (a difference) does not compile'
sound; change wrong '9,$d'
refuses "two wrong variants" 'there are 2 wrong variants'
sound; change wrong '1s/wrong/wrnog/'
refuses "a list of wrong variants that cannot be read" 'wrong:1: a line begins with'
sound; change hints '$d'
refuses "two hints" 'hints are not three'
sound; change hints 's/^2.*/2. /'
refuses "an empty hint" 'hints are not three'
sound; change README.md 1d
refuses "a task without its title" "README.md does not begin with '# 99/sum: title'"
sound; change README.md '3,$d'
refuses "a title without its task" 'README.md does not tell the task'
sound; echo '# 99. Sums' > "$tree/99-sum.md"
refuses "an exercise that its chapter does not tell of" '99-sum.md does not tell of it'
# shellcheck disable=SC2016
echo 'Try `make exercise 99/sum`.' > "$tree/99-sum.md"; accepts "one that it tells of"; rm "$tree/99-sum.md"
sound; : > "$dir/notes.txt"
refuses "a stray file" 'notes.txt is a stray file'
sound; : > "$dir/vec3.h"
refuses "a header that hides one of the library" 'vec3.h has the name of a file of lib/'
sound; change exercise 's/sum/summ/'
refuses "a function that is not there" 'the function summ stands there 0 times'
sound; change check.c 's/got == 6/got < 7/'
refuses "a stub that is the solution" 'the stub passes'
sound; change solution.c 's/all += x/all += 2 * x/'; change wrong 's/all += x/all += 2 * x/'
refuses "a solution that does not pass" 'the solution does not pass'
sound; change solution.c 's/^    spare/    unknown/'
refuses "a solution that does not compile" 'the solution does not compile'
sound; change sum.h '1d'
refuses "a stub that does not compile" 'the stub does not compile'
sound; change check.c '/^        [a-z_]*,$/d'
refuses "tests that do not run" 'no test has run'
sound; change check.c 's/suite_run/suite_ran/'
refuses "tests that do not build" 'no test has run'
sound; echo 'first  no_such_test' >> "$dir/exercise"
refuses "a first test that is not there" 'first names the test no_such_test'
sound; echo 'leave  no_such_test' >> "$dir/exercise"
refuses "a left test that is not there" 'leave names the test no_such_test'
sound; echo 'leave  no_number_is_zero' >> "$dir/exercise"
refuses "a left test that is wanted" 'leave names the test no_number_is_zero, which is to reject a wrong variant'
sound; change exercise 's/vec3/vec4/'
refuses "a module that is not there" 'there is no module vec4'
sound; rm "$dir/exercise"
refuses "an exercise that is not there" 'there is no such exercise'

# ---- the reader's runner, and the accidents of code

# clang knows the lines only with llvm-symbolizer, which may not be there.
lines=true
if ${CC:-cc} --version | grep -q clang && ! command -v llvm-symbolizer > /dev/null; then lines=false; fi

sound
reply=
answers "it begins with the task"        'Write sum, which adds up' exercise 99/sum
answers "it hands out an empty function" 'as it was at the beginning' reset 99/sum
if grep -q 'Yours to write' "$dir/mine.c" && ! grep -q 'all +=' "$dir/mine.c"
then verdict "the answer is not in it" yes; else verdict "the answer is not in it" no; fi
answers "the first hint"           'Begin at zero' hint 99/sum
answers "the second hint"          'Take one number' hint 99/sum
answers "the third hint"           'Stop when' hint 99/sum
answers "no fourth hint"           'There are three hints' hint 99/sum
answers "the solution is kept back" 'Not shown' solution 99/sum
reply=y
answers "the solution is shown"    'all += x[i]' solution 99/sum
tells "a wrong answer"     'got -6, wanted 6'              'for (int i = 0; i < n; i++) all -= x[i];'
also "what the test rejects" 'Rejects: a difference.'
also "where it stands"     '99-sum/check.c, line 4'
tells "no number"          'nan is no number'              'all = 0 / (all - n * all);'
tells "a null pointer"     'Your code follows a null pointer (a segmentation fault): mine.c, line 14' 'x = NULL; all = x[0];'
tells "a segfault"         'Your code follows a pointer that leads nowhere (a segmentation fault)' 'x += 1ll << 44; all = x[n];'
tells "an endless loop"    'Your code does not end (stopped after 0.6 seconds of computing, where the book'\''s own answer takes less than 0.01)' 'while (spare) all += x[0];'
if $lines; then also "where it turns" "mine.c, line 14, called from $dir/check.c, line 7."; fi
also "the tests after it"  '1 more were not tried'
tells "one that is too slow" 'Your code is too slow (0.' 'while (clock() < CLOCKS_PER_SEC * 4 / 10) all = 0; for (int i = 0; i < n; i++) all += x[i];'
also "and what is allowed" "seconds of computing, where the book's own answer takes less than 0.01, and 0.2 are allowed)"
tells "a loop that is called" 'Your code does not end' 'static int deep; if (deep++) while (spare) all += x[0];\n all = sum(x, n);'
if $lines; then also "by whom" 'mine.c, line 14, called from line 15, called from'; fi
change check.c 's/real got = sum(some, 3);/real got = sum(some, 3); while (got != 6) ;/'
tells "a test that is kept waiting" 'The test does not end' 'all = 7;'
if $lines; then also "by what" "what your code gives keeps it waiting, $dir/check.c, line 7."; fi
sound
tells "a leak"             'Your code does not free all that it allocates (a leak of 7 bytes): mine.c' 'for (int i = 0; i < n; i++) all += x[i]; char *volatile lost = malloc(7); lost = NULL;'
tells "an exit"            'Your code ends the whole program (exit)' 'exit(spare - 1);'
tells "an overrun"         'Your code reads outside an array' 'for (int i = 0; i <= n; i++) all += x[i];'
if $lines; then also "where it reads" 'outside an array: mine.c, line 14'; fi
tells "an overrun by writing" 'Your code writes outside an array' 'char *volatile p = malloc(3); p[n] = 1; free(p);'
tells "a sentence that is too long" 'Your code writes outside an array' 'char why[8]; sprintf(why, "%0999d", n); all = why[0];'
tells "an overrun that the compiler sees" 'Your code reaches outside an array' 'volatile char p[3]; p[n] = 1; all = p[0];'
tells "memory given back"  'Your code reads memory that it has given back' 'char *p = malloc(4); free(p); all = p[n];'
tells "a double free"      'Your code frees the same memory twice' 'char *volatile p = malloc(4); free(p); free(p);'
tells "a recursion"        'Your code calls itself without end' 'all = x[0] + sum(x, n + 1) + spare;'
tells "an overflow"        'Your code does what C leaves undefined: signed integer overflow' 'all = 2147483647 + n + spare;'
tells "an assertion"       'Your code breaks a rule that is asserted, n == 7' 'assert(n == 7);'
tells "what was printed"   'here I am, n is 3'             'printf("here I am, n is %d\\\\n", n);'
tells "a syntax error"     'mine.c does not compile'       'all += ;'
tells "a printout without end" 'Your code prints without end' 'while (spare) puts("again and again and again and again and again and again and again");'
change check.c '/^        no_number_is_zero,$/d; s/.tests = tests/&, .repeated = { { no_number_is_zero, 0, 3 } }/; s/sum(some, 0) == 0/sum(some, _i) < 6/'
tells "a test in a loop, of which one run fails" '1 of 2 tests pass' 'for (int i = 0; i < n; i++) all += n == 1 ? 9 : x[i];'
tells "and of which the last does not end" 'Your code does not end' 'if (n == 2) while (spare) all += x[0]; else for (int i = 0; i < n; i++) all += x[i];'
sound
echo 'first  no_number_is_zero' >> "$dir/exercise"
tells "the test to hear of first" 'The others: three_numbers_add_up' 'all = 7;'
cp "$dir/solution.c" "$dir/mine.c"
answers "a right answer"   'all 2 tests pass'              exercise 99/sum
printf '#include "show.h"\n#include "sum.h"\nint main(void)\n{\n    const real x[2] = { 3, 4 };\n    printf("together %%g\\n", sum(x, 2));\n    return 0;\n}\n' > "$dir/show.c"
answers "what it shows"    'together 7'                    exercise 99/sum
rm "$dir/show.c"
answers "the list"         '[x] 99/sum'                    exercise
answers "the list of a chapter"  '[x] 99/sum'              exercise 99
sh exercises/run.sh hint 99 > "$tree/said" 2>&1 && verdict "a chapter has no hint" no
also "a hint for a chapter"      'For example:  make hint 99/sum'
sh exercises/run.sh exercise 99/sun 2>&1 | tail -n 1 > "$tree/said"
also "an exercise that is not there" 'There is no exercise 99/sun:'
if grep -q '^99/sum passed 2' "$tree/progress.txt"; then verdict "what passed is kept" yes; else verdict "what passed is kept" no; fi
cp "$dir/solution.c" "$dir/mine.c"
change check.c 's/real got = sum(some, 3);/&\n    while (clock() < CLOCKS_PER_SEC * 3 \/ 10) got += 0;/; 1i #include <time.h>'
answers "a slow machine: what ours takes, a reader may" 'all 2 tests pass' exercise 99/sum
sound; cp "$dir/solution.c" "$dir/mine.c"
sleep 60 & other=$!
ln -s $other "$BUILD/exercises/99-sum/busy"
if sh exercises/run.sh exercise 99/sum > "$tree/said" 2>&1; then verdict "two at once" no
else also "two at once" '99/sum is being judged by another command'; fi
[ "$(wc -l < "$tree/said")" = 1 ] && verdict "in one sentence" yes || verdict "in one sentence" no
{ kill $other; wait $other; } 2> /dev/null
answers "one that has ended is not waited for" 'all 2 tests pass' exercise 99/sum
: > "$tree/file"
if BUILD=$tree/file sh exercises/run.sh exercise 99/sum > "$tree/said" 2>&1; then verdict "a build folder that cannot be" no
else also "a build folder that cannot be" '99-sum cannot be written'; fi
[ "$(wc -l < "$tree/said")" = 1 ] && verdict "said once" yes || verdict "said once" no
answers "a new beginning"  'mine.old.c'                    reset 99/sum
if grep -q 'passed 2' "$tree/progress.txt"; then verdict "and begins again" no; else verdict "and begins again" yes; fi
if cmp -s "$dir/solution.c" "$dir/mine.old.c"; then verdict "nothing is lost" yes; else verdict "nothing is lost" no; fi

wait $real
sound=$?
grep ': sound, ' "$tree/sound"
grep -v ': sound, ' "$tree/sound"
echo "exercises: $trials trials of the runner, $failed failed$which"
[ $sound -eq 0 ] && [ $failed -eq 0 ]
