# deps.sh - looks for what a command needs and installs what is missing.
# Called by make deps, deps-book, deps-site, deps-dev, deps-peers, with that name.
#   deps.sh deps-site npm webp    only looks for these two of that name's packages,
#                                 and says what installs them
# It looks for the thing itself, not for a package of a name, so that it is
# content on any system that has it.

group=$1; shift
only=$*
missing=

# need PACKAGE COMMAND...: the package is missing if the command fails.
need() {
    package=$1; shift
    case " $only " in "  " | *" $package "*) ;; *) return ;; esac
    "$@" > /dev/null 2>&1 || missing="$missing $package"
}
fuzzer() { # clang's own library: does a program link with it?
    empty='int LLVMFuzzerTestOneInput(const char *d, long n) { return d && n < 0; }'
    echo "$empty" | clang -fsanitize=fuzzer -x c - -o /dev/null
}
header() { echo "#include <$1>" | ${CC:-cc} -E -x c - ; }
bullet() { echo '#include <btBulletDynamicsCommon.h>' |
           ${CXX:-c++} -E -isystem /usr/include/bullet -x c++ - ; }
wasm() { # clang's own library for WebAssembly, its linker, and a C library
    printf '%s\n' '#include <math.h>' 'int main(void) { return 0; }' |
        clang --target=wasm32-wasi --sysroot=/usr -x c - -o /dev/null
}
browser() { command -v chromium || command -v chromium-browser || command -v google-chrome; }
gnu_parallel() { parallel --version | grep '^GNU parallel'; }
english() { aspell dump dicts | grep -x en_GB; }

command -v "${CC:-cc}" > /dev/null || {
    echo "There is no C compiler named ${CC:-cc}: install gcc or clang first." >&2
    exit 1
}

case $group in
deps)
    need check header check.h
    need gnuplot-nox command -v gnuplot
    need libpng-dev header png.h
    need mawk command -v awk
    need aspell command -v aspell
    need aspell-en english ;;
deps-book)
    need pandoc command -v pandoc
    need chromium browser
    need qpdf command -v qpdf
    need webp command -v img2webp ;;
deps-site)
    need check header check.h
    need pandoc command -v pandoc
    need clang command -v clang
    need lld command -v wasm-ld
    need wasi-libc wasm
    need libclang-rt-dev-wasm32 wasm
    need nodejs command -v node
    need npm command -v npm
    need chromium browser
    need webp command -v cwebp ;;
deps-dev)
    need clang command -v clang
    need libclang-rt-dev fuzzer
    need valgrind command -v valgrind
    need cmake command -v cmake
    need parallel gnu_parallel ;;
deps-peers)
    need libccd-dev header ccd/ccd.h
    need libode-dev header ode/ode.h
    need g++ command -v "${CXX:-c++}"
    need libbullet-dev bullet ;;
esac

[ -n "$only" ] && {
    [ -z "$missing" ] && exit
    echo "This needs$missing (names of Debian and Ubuntu): make $group installs it." >&2
    exit 1
}
[ -n "$missing" ] || { echo "$group: nothing is missing"; exit 0; }
echo "$group: missing:$missing (names of Debian and Ubuntu)"

command -v apt-get > /dev/null || {
    echo "There is no apt-get here: install these with your own packages." >&2
    exit 1
}
sudo=
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null || {
        echo "You are not root and there is no sudo; as root, run:" \
             "apt-get install$missing" >&2
        exit 1
    }
    sudo=sudo
fi
$sudo apt-get update -q &&
$sudo env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends $missing
