# check_cmake.sh - is the library found by CMake: fetched and built as a part of a
# program, installed from there, and installed by make?  Its bits must be those of
# the library that make builds.

command -v cmake > /dev/null || { echo "cmake: skipped, for there is no cmake"; exit 0; }
root=$(pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
unset MAKEFLAGS MFLAGS
BUILD=${BUILD:-build} BUILD=${BUILD%/swapped}; export BUILD
! command -v ninja > /dev/null || export CMAKE_GENERATOR=Ninja
fail() { [ ! -s "$place/said" ] || tail -n 20 "$place/said"; echo "check_cmake: $1"; exit 1; }

mkdir "$place/a place"
cp -R tests/public/hashes.c tests/public/program "$place/a place"
# Not optimized: to the bits that is the same, and it takes a tenth of the time.
program() {     # FOLDER OPTION...
    to=$1; shift
    cmake -S "$place/a place/program" -B "$place/$to" -DCMAKE_C_COMPILER="$(command -v clang || echo "${CC:-cc}")" \
        -DCMAKE_BUILD_TYPE=Quick -DCMAKE_C_FLAGS=-O0 "$@" > "$place/said" 2>&1 &&
        cmake --build "$place/$to" > "$place/said" 2>&1 || fail "a program of CMake does not build: $*"
    "$place/$to/hashes" > "$place/got" && diff "$place/wanted" "$place/got" || fail "a program of CMake has other bits: $*"
}

"${MAKE:-make}" -s install PREFIX="$place/made" > "$place/said" 2>&1 || fail "make install fails"
"${CC:-cc}" -std=c11 -Ilib tests/public/hashes.c "$BUILD/seen.a" -lm -o "$place/hashes" && "$place/hashes" > "$place/wanted" ||
    fail "hashes.c fails"
program plain -DCMAKE_PREFIX_PATH="$place/made"
program plain -DBUILD_SHARED_LIBS=OFF
program fetched -DFETCH="$root"
cmake --install "$place/fetched" --prefix "$place/in a folder" > "$place/said" 2>&1 || fail "cmake --install fails"
program plain -Dtumble_DIR="$(ls -d "$place"/in*/lib*/cmake/tumble)"
other=$(nm -g --defined-only "$place"/in*/lib*/libtumble.a | awk 'NF == 3 && $3 !~ /^_?tumble_/ { print $3 }')
[ -z "$other" ] || fail "CMake's library also shows $(echo $other | cut -c 1-200)"
[ -s "$place/in a folder/share/licenses/tumble/LICENSE" ] || fail "CMake installs no licence"
sed -i.old 's/tumble 3 /tumble 2 /' "$place/a place/program/CMakeLists.txt"
for by in "$place/made" "$place/in a folder"; do
    ! cmake "$place/plain" -Dtumble_DIR="$(ls -d "$by"/lib*/cmake/tumble)" > /dev/null 2>&1 || fail "version 2 is found where 3 stands: $by"
done
echo "cmake: fetched, installed, and found as make installs it; the same bits"
