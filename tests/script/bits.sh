# bits.sh - builds tests/bits/bits.c and the live figures with two compilers, without and with all their
# optimisation, and compares what each program prints with tests/bits/bits.txt, byte
# for byte.  Called by make bits, with the make to use and the folder to build in.

failed=
mkdir -p "$2"
for compiler in gcc clang; do
    command -v $compiler > /dev/null || { echo "bits: there is no $compiler here, left out"; continue; }
    for level in -O0 -O3; do
        folder=$2/$compiler$level
        $1 $folder/bits live-programs BUILD=$folder CC=$compiler CFLAGS=$level > $folder.log 2>&1 ||
            { cat $folder.log; exit 1; }
        echo "bits: $compiler $level"
        sh tests/script/check_bits.sh $folder/bits || failed=1
    done
done
[ -z "$failed" ]
