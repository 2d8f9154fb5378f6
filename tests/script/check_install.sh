# check_install.sh - is an installed library what others need: does it show no
# name but its own, do README's program, the scenes and the programs of chapter 19b
# build against it, in C and in C++, and do they say what they should?

page=$(pwd)/README.md
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# Of the objects of make library: nothing is compiled for it.  Ours, not a reader's.
unset MAKEFLAGS MFLAGS
BUILD=${BUILD:-build} BUILD=${BUILD%/swapped}; export BUILD
make -s library > "$place/said" 2>&1 && make install PREFIX="$place/tumble" > "$place/said" 2>&1 ||
    { cat "$place/said"; echo "check_install: make install fails"; exit 1; }
! grep -q '^  cc ' "$place/said" || { cat "$place/said"; echo "check_install: make install compiles what make library has"; exit 1; }
[ -s "$place/tumble/share/licenses/tumble/LICENSE" ] || { echo "check_install: no licence is installed"; exit 1; }

# For a system's own folders, in a place of its own: the loader looks there, so no
# program is told where the library stands; and all of it goes again.
own="install DESTDIR=$place/root PREFIX=/usr LIBDIR=/usr/lib64 INCLUDEDIR=/usr/include/tumble"
# shellcheck disable=SC2086
make -s $own > "$place/said" 2>&1 && ! grep -q rpath "$place/root/usr/lib64/pkgconfig/tumble.pc" &&
    grep -qx 'libdir=${prefix}/lib64' "$place/root/usr/lib64/pkgconfig/tumble.pc" &&
    [ -s "$place/root/usr/include/tumble/tumble.h" ] && [ -s "$place/root/usr/lib64/libtumble.so" ] ||
    { cat "$place/said"; echo "check_install: DESTDIR, LIBDIR and INCLUDEDIR are not obeyed, or an rpath is /usr's"; exit 1; }
# shellcheck disable=SC2086
make -s un$own > "$place/said" 2>&1 && [ -z "$(find "$place/root" ! -type d)" ] ||
    { find "$place/root" ! -type d; echo "check_install: make uninstall leaves these"; exit 1; }
scenes=$(pwd)/figures/scenes manual=$(pwd)/figures/manual
alone='loop replay rollouts' reference=$(pwd)/chapters/reference.awk
cd "$place" || exit 1

for library in libtumble.a libtumble.so; do
    case $library in *.so) dynamic=-D ;; *) dynamic= ;; esac
    other=$(nm -g $dynamic --defined-only "tumble/lib/$library" | awk 'NF == 3 && $3 !~ /^tumble_/ { print $3 }')
    [ -z "$other" ] || { echo "check_install: $library also shows" $other; exit 1; }
done
# Each name that it shows has a section in the reference.
awk -f "$reference" tumble/include/tumble.h > told
nm -g --defined-only tumble/lib/libtumble.a | awk 'NF == 3 { print $3 }' | sort -u > names
untold=$(sed -n 's/^### //p' told | sort | comm -23 names -)
[ -s names ] && [ -z "$untold" ] || { echo "check_install: chapters/reference.awk has no section for" $untold; exit 1; }

awk '/^## / { here = /^## Use/ } /^```/ { if (inside) exit
     if (here && $0 == "```c") { inside = 1; next } } inside' "$page" > my.c
wanted=$(sed -n 's/^and it says `\(.*\)`\. The library.*/\1/p' "$page")
[ -s my.c ] && [ -n "$wanted" ] || { echo "check_install: README has no program"; exit 1; }

# As pkg-config would say, where there is none.
flags="-I$place/tumble/include -L$place/tumble/lib -Wl,-rpath,$place/tumble/lib -ltumble -lm"
if command -v pkg-config > /dev/null; then
    said=$(PKG_CONFIG_PATH="$place/tumble/lib/pkgconfig" pkg-config --cflags --libs tumble)
    [ "$(echo $said)" = "$flags" ] || { echo "check_install: tumble.pc says $said"; exit 1; }
fi
try() {     # COMPILER...
    "$@" $flags -o my && got=$(./my) && [ "$got" = "$wanted" ] ||
        { echo "check_install: with $1 README's program says '$got', not '$wanted'"; exit 1; }
}
cxx=$(for c in g++ clang++; do command -v $c; done)
try "${CC:-cc}" -std=c11 my.c
cp my.c my.cpp
for c in $cxx; do try $c -std=c++17 my.cpp; done

# A program whose own names are those of our modules, with the archive.
cat > own.c <<'END'
#include <stdio.h>
#include <tumble.h>
struct body { int world; };
enum { NORMAL, world };
typedef double vec3;
int world_step(struct body *b) { return b->world; }
vec3 vec3_add(vec3 a, vec3 b) { return a + b; }
int main(void)
{
    struct body body = { 3 };
    tumble_world *w = tumble_world_make(NULL);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1), tumble_body_at(0, 0, 0));
    tumble_world_step(w);
    int fell = tumble_body_position(w, (tumble_body){ 0, 1 }).y < 0;
    printf("%d %g %d\n", world_step(&body), vec3_add(1, NORMAL), fell);
    tumble_world_free(w);
}
END
"${CC:-cc}" -std=c11 -I"$place/tumble/include" own.c tumble/lib/libtumble.a -lm -o own && said=$(./own) &&
    [ "$said" = '3 1 1' ] || { echo "check_install: a program with names of its own says '$said'"; exit 1; }

# The scenes, each with what it claims, and no longer than a page; the programs of
# chapter 19b, which explains them, are no longer than one and a half.  Those that
# are alone fail if what they print is not so.
long=$(awk 'FNR == 61 { print FILENAME }' "$scenes"/*.c; awk 'FNR == 91 { print FILENAME }' "$manual"/*.c)
[ -z "$long" ] || { echo "check_install: more than 60 lines, or 90: $long"; exit 1; }
mkdir c alone cxx
cp "$scenes"/*.[ch] "$manual"/*.c c
for f in $alone; do mv c/$f.c alone; done
"${CC:-cc}" -std=c11 -O1 c/*.c $flags -o scenes && ./scenes ||
    { echo "check_install: a scene does not hold what it claims"; exit 1; }
for f in $alone; do
    "${CC:-cc}" -std=c11 -O1 alone/$f.c $flags -lpthread -o $f && ./$f ||
        { echo "check_install: $f.c does not build, or hold what it claims"; exit 1; }
done
for f in c/*.c; do cp "$f" "cxx/$(basename "$f" .c).cpp"; done
for c in $cxx; do
    $c -std=c++20 -w -Ic cxx/*.cpp $flags -o scenes && ./scenes pyramid curtain crane > /dev/null ||
        { echo "check_install: the scenes do not build with $c"; exit 1; }
done
echo "installed: README's program, the scenes and chapter 19b's programs, in C and C++; no name but tumble_*"
