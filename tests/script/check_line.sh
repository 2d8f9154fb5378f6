# check_line.sh - is every file of lib/ in the Makefile's line, does each include
# only modules to its left, and libc's own headers?  (The linker cannot see an
# arrow that goes through a header.)

# What is built of figures/ lies side by side, so no two of its programs share a
# name: the object of one would be taken for the other.
twice=$(ls figures/*/*.c | sed "s/.*\///" | sort | uniq -d)
[ -z "$twice" ] || { echo "figures/: two programs have the name $twice"; exit 1; }

awk '
FILENAME == "Makefile" {
    if ($1 == "define" && $2 == "ORDER") open = 1
    else if (open && $1 == "endef") open = 0
    else if (open) { split($1, part, "/"); place[part[2]] = ++count }
    next
}
FNR == 1 {
    name = FILENAME; sub(/^lib\/([a-z]*\/)?/, "", name); sub(/\.[ch]$/, "", name)
    if (!(name in place)) { print FILENAME ": this module is not in the line of the Makefile"; bad = 1 }
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, quoted, "\""); used = quoted[2]; sub(/\.[ch]$/, "", used)
    if (!(used in place)) { print FILENAME ":" FNR ": " used " is not in the line"; bad = 1 }
    else if (name in place && place[used] > place[name]) { print FILENAME ":" FNR ": " name " includes " used ", which stands to its right"; bad = 1 }
    arrows++
}
/^[ \t]*#[ \t]*include[ \t]*</ && !/<(assert|ctype|errno|float|inttypes|limits|math|stdalign|stdarg|stdbool|stddef|stdint|stdio|stdlib|string)\.h>/ {
    print FILENAME ":" FNR ": the library needs only C11 and libm"; bad = 1
}
END { if (!bad) print "the line: " arrows " includes, all to the left"; exit bad }
' Makefile lib/tumble.h lib/*/*.h lib/*/*.c
