# check_names.sh - does a program of version 2 compile, and give the same bits, and
# is no name of that left for one that wants none?

place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
unset MAKEFLAGS MFLAGS
BUILD=${BUILD:-build} BUILD=${BUILD%/swapped}; export BUILD
fail() { [ ! -s "$place/said" ] || head -n 20 "$place/said"; echo "check_names: $1"; exit 1; }

"${MAKE:-make}" -s "$BUILD/seen.a" > "$place/said" 2>&1 || fail "the library does not build"
old=$(sed -n 's/^#define \(tumble_[a-z0-9_]*\) tumble_[a-z0-9_]*$/\1/p' lib/tumble.h | sort)
[ "$old" = "$(grep -o 'OLD(tumble_[a-z0-9_]*)' tests/public/names_2.c | sed 's/OLD(//; s/)//' | sort)" ] ||
    fail "names_2.c has other names than tumble.h"
count=$(echo "$old" | wc -l)
# Each ends as it did, behind its object; but for these.
odd=$(sed -n 's/^#define tumble_\([a-z0-9_]*\) tumble_\([a-z]*\)_\([a-z0-9_]*\)$/\1 \2 \3/p' lib/tumble.h |
    awk '$1 != $3 { print $1 "=" $2 "_" $3 }' | sort)
[ "$(echo $odd)" = "add_plane=plane_add drop_shape=shape_remove fix=joint_fixed get_pose=body_pose\
 get_poses=body_poses get_velocities=body_velocities get_world_options=world_get_options has=body_exists\
 hinge_angle=joint_angle is_joined=joint_exists remove_plane=plane_remove round=shape_rounded\
 shape_of=body_shape unjoin=joint_remove weigh=shape_weighed" ] || fail "an old name stands for another function: $odd"

"${CC:-cc}" -std=c11 -Ilib tests/public/hashes.c "$BUILD/seen.a" -lm -o "$place/hashes" > "$place/said" 2>&1 ||
    fail "hashes.c does not build"
wanted="$count $("$place/hashes" | grep '^readme ')"
cp tests/public/names_2.c "$place/names_2.cpp"
try() {
    "$@" -Wall -Wextra -Werror -Ilib "$BUILD/seen.a" -lm -o "$place/names" > "$place/said" 2>&1 || fail "with $1 a program of version 2 does not build"
    got=$("$place/names")
    [ "$got" = "$wanted" ] || fail "with $1 a program of version 2 says '$got', not '$wanted'"
}
try "${CC:-cc}" -std=c11 tests/public/names_2.c
for c in $(for c in g++ clang++; do command -v $c; done); do try "$c" -std=c++17 -Wno-cast-function-type "$place/names_2.cpp"; done

# Without old names all of them are a program's own, also together with the new ones.
{
    echo '#include <tumble.h>'
    echo "$old" | sed 's/.*/int &(void);\nint &(void) { return 1; }/'
    echo 'int main(void) { tumble_world *w = tumble_world_make(NULL); tumble_world_free(w); return !w - 1 +'
    echo "$old" | sed 's/$/() +/'
    echo "- $count + 1; }"
} > "$place/own.c"
"${CC:-cc}" -std=c11 -Werror -DTUMBLE_NO_OLD_NAMES -Ilib "$place/own.c" "$BUILD/seen.a" -lm -o "$place/own" > "$place/said" 2>&1 ||
    fail "with TUMBLE_NO_OLD_NAMES a program may not use the names of version 2 for itself"
"$place/own" || fail "with TUMBLE_NO_OLD_NAMES the library calls a program's own functions"
echo "names: $count of version 2 stand for those of today, and none with TUMBLE_NO_OLD_NAMES"
