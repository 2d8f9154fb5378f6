# check_cmake.sh - is the library found by CMake: fetched and built as a part of a
# program, installed from there, and installed by make?  Its bits must be those of
# the library that make builds.

command -v cmake > /dev/null || { echo "cmake: skipped, for there is no cmake"; exit 0; }
root=$(pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
unset MAKEFLAGS MFLAGS
BUILD=${BUILD:-build} BUILD=${BUILD%/swapped}; export BUILD
fail() { [ ! -s "$place/said" ] || tail -n 20 "$place/said"; echo "check_cmake: $1"; exit 1; }

mkdir "$place/a program"
cp tests/public/hashes.c "$place/a program"
cat > "$place/a program/CMakeLists.txt" <<'EOF'
cmake_minimum_required(VERSION 3.18)
project(program LANGUAGES C)
if(FETCH)
    include(FetchContent)
    FetchContent_Declare(tumble SOURCE_DIR ${FETCH} SOURCE_SUBDIR lib)
    FetchContent_MakeAvailable(tumble)
else()
    find_package(tumble 2 REQUIRED)
endif()
add_executable(hashes hashes.c)
target_link_libraries(hashes PRIVATE tumble::tumble)
EOF
# Not optimized: to the bits that is the same, and it takes a tenth of the time.
program() {     # FOLDER OPTION...
    to=$1; shift
    cmake -S "$place/a program" -B "$place/$to" -DCMAKE_C_COMPILER="$(command -v clang || echo "${CC:-cc}")" \
        -DCMAKE_BUILD_TYPE=Quick -DCMAKE_C_FLAGS=-O0 "$@" > "$place/said" 2>&1 &&
        cmake --build "$place/$to" > "$place/said" 2>&1 || fail "a program of CMake does not build: $*"
    "$place/$to/hashes" > "$place/got" && diff "$place/wanted" "$place/got" || fail "a program of CMake has other bits: $*"
}

make -s install PREFIX="$place/made" > "$place/said" 2>&1 || fail "make install fails"
"${CC:-cc}" -std=c11 -Ilib tests/public/hashes.c "$BUILD/seen.a" -lm -o "$place/hashes" && "$place/hashes" > "$place/wanted" ||
    fail "hashes.c fails"
program shared -DCMAKE_PREFIX_PATH="$place/made"
program archive -DCMAKE_PREFIX_PATH="$place/made" -DBUILD_SHARED_LIBS=OFF
program fetched -DFETCH="$root"
cmake --install "$place/fetched" --prefix "$place/in a folder" > "$place/said" 2>&1 || fail "cmake --install fails"
program found -DCMAKE_PREFIX_PATH="$place/in a folder"
other=$(nm -g --defined-only "$place"/in*/lib*/libtumble.a | awk 'NF == 3 && $3 !~ /^_?tumble_/ { print $3 }')
[ -z "$other" ] || fail "CMake's library also shows $(echo $other)"
[ -s "$place/in a folder/share/licenses/tumble/LICENSE" ] || fail "CMake installs no licence"
if cmake -S "$place/a program" -B "$place/shared" -DCMAKE_PREFIX_PATH="$place/made" -Dtumble_DIR="$place/none" > /dev/null 2>&1 &&
    sed -i 's/tumble 2 /tumble 1 /' "$place/a program/CMakeLists.txt" && cmake -S "$place/a program" -B "$place/shared" > /dev/null 2>&1
then fail "version 1 is found where 2 stands"; fi
echo "cmake: fetched, installed, and found as make installs it; the same bits"
