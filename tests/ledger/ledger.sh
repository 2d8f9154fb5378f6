#!/bin/sh
# ledger.sh BUILD - what half and double of each tuned number of lib/ do.
#
# BUILD/battery runs short scenes, linked with the objects of BUILD/lib.  For
# each number (numbers.awk) a copy of lib/ gets half of it, and then the double;
# what that touches is compiled again, linked with the rest, and run: of lib/soft
# in the scenes with rope or cloth, for no other calls it.  BUILD/rows has what
# was run, and is gone on with, unless the library was built again meanwhile.
# CC and SETTINGS say how to compile.  Writes the table of table.awk.

build=${1:?the folder of a build} here=$(dirname "$0")
work=$build/work rows=$build/rows
[ "$rows/base" -nt "$build/battery" ] || rm -rf "$rows"
rm -rf "$work" && mkdir -p "$work" "$rows" && cp -R lib "$work/lib" || exit 2
rooms=-I$work/lib
for room in "$work"/lib/*/; do rooms="$rooms -I$room"; done
awk -f "$here/numbers.awk" lib/*/*.[ch] > "$rows/numbers" || exit 2
"$build/battery" --list > "$rows/list" || exit 2
[ -s "$rows/base" ] || "$build/battery" > "$work/ran" || exit 2
[ -s "$rows/base" ] || mv "$work/ran" "$rows/base"

# changed FILE LINE VALUE AS: that file of lib/, with the value in that line so.
changed() {
    awk -v line="$2" -v value="= $3" -v as="= ($3) $4" 'FNR == line {
        at = index($0, value)
        $0 = substr($0, 1, at - 1) as substr($0, at + length(value)) } 1' "$1"
}

# try FILE LINE VALUE AS ROW: builds it so, and runs all scenes.
try() {
    changed "$1" "$2" "$3" "$4" > "$work/$1"
    objects=
    for object in "$build"/lib/*.o; do
        unit=$(basename "$object" .o)
        if grep -q "[ /]$(basename "$1")" "$build/lib/$unit.d"; then
            $CC $SETTINGS $rooms -c "$work"/lib/*/"$unit.c" -o "$work/$unit.o" ||
                return 1
            object=$work/$unit.o
        fi
        objects="$objects $object"
    done
    cp "$1" "$work/$1"
    $CC -o "$work/battery" "$build"/tests/*.o "$build"/figures/*.o $objects -lm || return 1
    case $1 in lib/soft/*) kind=soft ;; *) kind= ;; esac
    timeout 300 "$work/battery" $kind > "$work/ran" 2> /dev/null ||
        echo stopped >> "$work/ran"
    mv "$work/ran" "$5"
}

tab=$(printf '\t') of=$(wc -l < "$rows/numbers") n=0
while IFS=$tab read -r file line name value rest; do
    n=$((n + 1))
    for way in half double; do
        key=$(basename "$file").$name.$(echo "$value" | tr -d ' /')
        row=$rows/$key.$way
        [ -s "$row" ] && continue
        case $way in half) as='/ 2' ;; *) as='* 2' ;; esac
        echo "  $n of $of: $way of $name, $file" >&2
        try "$file" "$line" "$value" "$as" "$row" && continue
        echo "ledger: $way of $name, $file, was not built" >&2
        exit 2
    done
done < "$rows/numbers"
exec awk -v rows="$rows" -f "$here/table.awk" "$rows/list" "$rows/base" \
    "$rows/numbers"
