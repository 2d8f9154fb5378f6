# check_install.sh - does README's program build against an installed library,
# in C and in C++, and say what README says?

page=$(pwd)/README.md
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# A make that called us must not hand down its own BUILD; -O0 is soon built.
unset MAKEFLAGS MFLAGS
make -s install BUILD="$place/build" PREFIX="$place/tumble" CFLAGS=-O0 > "$place/said" 2>&1 ||
    { cat "$place/said"; echo "check_install: make install fails"; exit 1; }
cd "$place" || exit 1

awk '/^## / { here = /^## Use/ } /^```/ { if (inside) exit
     if (here && $0 == "```c") { inside = 1; next } } inside' "$page" > my.c
wanted=$(sed -n 's/^and it says `\(.*\)`\. The library.*/\1/p' "$page")
[ -s my.c ] && [ -n "$wanted" ] || { echo "check_install: README has no program"; exit 1; }

# As pkg-config would say, where there is none.
flags="-I$place/tumble/include/tumble -L$place/tumble/lib -ltumble -lm"
if command -v pkg-config > /dev/null; then
    said=$(PKG_CONFIG_PATH="$place/tumble/lib/pkgconfig" pkg-config --cflags --libs tumble)
    [ "$(echo $said)" = "$flags" ] || { echo "check_install: tumble.pc says $said"; exit 1; }
fi
try() {     # COMPILER...
    "$@" $flags -o my && got=$(./my) && [ "$got" = "$wanted" ] ||
        { echo "check_install: with $1 README's program says '$got', not '$wanted'"; exit 1; }
}
try "${CC:-cc}" -std=c11 my.c
cp my.c my.cpp
for cxx in g++ clang++; do
    command -v $cxx > /dev/null && try $cxx -std=c++17 my.cpp
done
echo "README's program: installed, built in C and C++, run, and as the page says"
