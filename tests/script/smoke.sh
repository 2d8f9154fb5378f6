# smoke.sh - does README's program build against the library that is named, and
# does it say what README says?  For systems that cannot run the whole of make test.
#
#   sh tests/script/smoke.sh build/libtumble.a

library=$1
[ -f "$library" ] || { echo "smoke: there is no library $library" >&2; exit 2; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

awk '/^## / { here = /^## Use/ } /^```/ { if (inside) exit
     if (here && $0 == "```c") { inside = 1; next } } inside' README.md > "$place/my.c"
wanted=$(sed -n 's/^and it says `\(.*\)`\. The library.*/\1/p' README.md)
[ -s "$place/my.c" ] && [ -n "$wanted" ] || { echo "smoke: README has no program" >&2; exit 1; }

${CC:-cc} -std=c11 -Ilib "$place/my.c" "$library" -lm -o "$place/my" || exit 1
got=$("$place/my" | tr -d '\r')
[ "$got" = "$wanted" ] || { echo "smoke: README's program says '$got', not '$wanted'" >&2; exit 1; }
echo "smoke: $got"
