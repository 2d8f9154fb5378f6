# bits.sh - builds tests/bits.c with two compilers, without and with all their
# optimisation, and compares what the four programs print, byte for byte.
# Called by make bits, with the make to use and the folder to build in.

first= failed=
mkdir -p "$2"
for compiler in gcc clang; do
    command -v $compiler > /dev/null || { echo "bits: there is no $compiler here, left out"; continue; }
    for level in -O0 -O3; do
        folder=$2/$compiler$level
        $1 $folder/bits BUILD=$folder CC=$compiler CFLAGS=$level > $folder.log 2>&1 ||
            { cat $folder.log; exit 1; }
        $folder/bits > $folder.txt || { echo "bits: $folder/bits failed"; exit 1; }
        [ -n "$first" ] || first=$folder.txt
        if cmp -s "$first" $folder.txt; then verdict=same
        else verdict=DIFFERENT; failed=1; fi
        echo "bits: $compiler $level: $(cksum < $folder.txt | tr ' ' '-') $verdict"
        [ $verdict = same ] || diff "$first" $folder.txt | head -n 10
    done
done
[ -z "$failed" ]
