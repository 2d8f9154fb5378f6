# check_python.sh - does the wheel install into a fresh environment, does the program
# of lib/python/README.md say there what README's says, and are its bits those of C?

command -v python3 > /dev/null && python3 -c 'import venv' 2> /dev/null || { echo "python: skipped, for there is no python3 with venv"; exit 0; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
unset MAKEFLAGS MFLAGS
BUILD=${BUILD:-build} BUILD=${BUILD%/swapped}; export BUILD
fail() { [ ! -s "$place/said" ] || tail -n 20 "$place/said"; echo "check_python: $1"; exit 1; }

"${MAKE:-make}" -s python > "$place/said" 2>&1 || fail "make python fails"
wheel=$(tail -n 1 "$place/said")
# numpy is looked at if the system has it.
python3 -m venv --without-pip --system-site-packages "$place/fresh" > "$place/said" 2>&1 || fail "there is no fresh environment"
python=$place/fresh/bin/python
site=$("$python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
python3 -m pip --python "$python" install --no-index --no-deps "$wheel" > "$place/said" 2>&1 ||
    python3 -m zipfile -e "$wheel" "$site" > "$place/said" 2>&1 || fail "the wheel does not install"

awk '/^```/ { if (inside) exit; if ($0 == "```python") { inside = 1; next } } inside' lib/python/README.md > "$place/my.py"
wanted=$(sed -n 's/^and it says `\(.*\)`\. The library.*/\1/p' README.md)
got=$(cd "$place" && "$python" my.py 2>&1)
[ -n "$wanted" ] && [ "$got" = "$wanted" ] || fail "the program of lib/python/README.md says '$got', not '$wanted'"

"${CC:-cc}" -std=c11 -Ilib tests/public/hashes.c "$BUILD/seen.a" -lm -o "$place/hashes" && "$place/hashes" > "$place/wanted" ||
    fail "hashes.c fails"
cp tests/public/hashes.py "$place" && (cd "$place" && "$python" hashes.py) > "$place/got" 2>&1 || { cat "$place/got"; fail "hashes.py fails"; }
diff "$place/wanted" "$place/got" || fail "Python has other bits than C"
# The throws of chapter 19b, as the program in C prints them.
"$BUILD/rollouts" > "$place/wanted" && (cd "$place" && "$python" "$OLDPWD/figures/manual/rollouts.py") > "$place/got" 2>&1 &&
    diff "$place/wanted" "$place/got" || fail "figures/manual/rollouts.py fails, or prints something else than rollouts.c"
"$python" -c 'import numpy' 2> /dev/null && with=', numpy sees its memory' || with=
echo "python: the wheel installs into a fresh environment; the same bits as in C$with"
