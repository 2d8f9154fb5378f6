# others.sh - compiles tumble.c, and the four worlds of tests/public/hashes.c, with
# each compiler for another machine or system that is there, and runs them: are the
# bits those of this one?     make single && sh tests/script/others.sh build [-O2]

from=$(cd "$1" && pwd) worlds=$(pwd)/tests/public/hashes.c level=${2:--O2}
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp "$from/tumble.c" "$from/tumble.h" "$worlds" "$place" && cd "$place" || exit 1
failed=

# try NAME RUNNER COMPILER...
try() {
    name=$1 runner=$2; shift 2
    for tool in "$1" ${runner%% *}; do
        command -v "$tool" > /dev/null || { echo "$name: skipped, for there is no $tool"; return; }
    done
    if "$@" "$level" -c tumble.c -o tumble.o 2> said && "$@" -I. hashes.c tumble.o -lm -o hashes.exe 2>> said && $runner ./hashes.exe > printed 2>> said
    then
        tr -d '\r' < printed > got
        [ -s wanted ] || cp got wanted
        if diff wanted got; then echo "$name: the same bits"; return; fi
    else tail -n 5 said; fi
    echo "$name: FAILED"; failed=1
}

cat > wasi.mjs <<'EOF'
import { WASI } from 'node:wasi';
import { readFile } from 'node:fs/promises';
const wasi = new WASI({ version: 'preview1', args: ['hashes'] });
const program = await WebAssembly.compile(await readFile(process.argv[2]));
wasi.start(await WebAssembly.instantiate(program, { wasi_snapshot_preview1: wasi.wasiImport }));
EOF
wine=$(command -v wine64 || command -v wine || echo /usr/lib/wine/wine64)
export WINEDEBUG=-all WINEPREFIX="$place/wine"

try "${CC:-cc}" '' "${CC:-cc}"
try clang '' clang
try musl '' musl-gcc
# Debian's compiler for ARM takes the place of a link to the kernel's headers.
try '32 bits' '' gcc -m32 -msse2 -mfpmath=sse -isystem "/usr/include/$(gcc -dumpmachine)"
try ARM 'qemu-aarch64 -L /usr/aarch64-linux-gnu' "$(ls /usr/bin/aarch64-linux-gnu-gcc* 2> /dev/null | grep -x '.*gcc[-0-9]*' | head -n 1 | grep . || echo aarch64-linux-gnu-gcc)"
try Windows "$wine" x86_64-w64-mingw32-gcc
try WebAssembly 'node wasi.mjs' clang --target=wasm32-wasi --sysroot=/usr -Wl,-z,stack-size=1048576
[ -z "$failed" ]
