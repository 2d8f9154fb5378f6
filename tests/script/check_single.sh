# check_single.sh - is the library in one file, tumble.c, the same library: does it
# compile alone, does it show what tumble.h declares and nothing else, and do its
# worlds end in the same bits as those of the library of make install?

place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
unset MAKEFLAGS MFLAGS
BUILD=${BUILD:-build} BUILD=${BUILD%/swapped}; export BUILD
fail() { echo "check_single: $1"; exit 1; }

"${MAKE:-make}" -s "$BUILD/seen.a" single > "$place/said" 2>&1 || { cat "$place/said"; fail "make single fails"; }
cp "$BUILD/tumble.c" "$BUILD/tumble.h" tests/public/hashes.c "$place"
# Not optimized: to the bits that is the same, and it takes a tenth of the time.
cc=$(command -v clang || echo "${CC:-cc}")
"$cc" -O0 -Wall -Wextra -c "$place/tumble.c" -o "$place/tumble.o" > "$place/said" 2>&1 && [ ! -s "$place/said" ] ||
    { head -n 20 "$place/said"; fail "tumble.c does not compile alone, or not in silence"; }

nm -g --defined-only "$place/tumble.o" | sed -n 's/.* _\{0,1\}//p' | sort > "$place/seen"
sed 's/.*static inline.*//' lib/tumble.h | grep -o '^[a-z].*tumble_[a-z0-9_]*(' | grep -v typedef |
    sed 's/($//; s/.*[ *]//' | sort > "$place/declared"
cmp -s "$place/seen" "$place/declared" || { diff "$place/seen" "$place/declared"; fail "these are seen, or not, other than tumble.h says"; }

for form in "$place/tumble.o" "$BUILD/seen.a"; do
    "$cc" -std=c11 -I"$place" "$place/hashes.c" "$form" -lm -o "$place/hashes" && "$place/hashes" > "$place/$(basename "$form").said" ||
        fail "hashes.c fails with $form"
done
diff "$place/seen.a.said" "$place/tumble.o.said" || fail "one file gives other bits than the library"
echo "single: tumble.c compiles alone, shows $(wc -l < "$place/seen") functions, and gives the same bits"
