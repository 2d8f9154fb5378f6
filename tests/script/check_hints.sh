# check_hints.sh - does each hint call functions as they are declared today
# (tests/script/hints.awk)?

export LC_ALL=C
code=$(mktemp) && hint=$(mktemp -d)
trap 'rm -rf "$code" "$hint"' EXIT
failed=

# The check itself is shown faults first.
printf 'real go_there(int a, vec3 b);\nstatic real add(real x,\n    real y)\n{\n' > "$code"
printf '1. go_there(1, make(2,\n   3)) and add(x, f(y, z)), go_there(...).\n\n2. u_(k+1) or go_home(1).\n\n3. add(x).\n' > "$hint/hints"
said=$(awk -f tests/script/hints.awk "$code" "$hint/hints" | sed 's/^[^:]*://')
[ "$said" = '4: nothing is called go_home
6: add(x) has 1 arguments, the function takes 2 ' ] || { echo "hints.awk does not see what it should, but: $said"; failed=1; }

n=0
for dir in exercises/[0-9]*/; do
    n=$((n + 1))
    module=$(sed -n 's/^module //p' "$dir/exercise")
    # shellcheck disable=SC2046
    awk -f tests/script/hints.awk lib/tumble.h lib/*/*.h ${module:+lib/*/$module.c} \
        $(ls "$dir"*.h "$dir"solution.c "$dir"check.c 2> /dev/null) "${dir}hints" || failed=1
done
[ -z "$failed" ] && echo "hints: those of $n exercises call functions as they are declared"
