# html.awk - rewrites book.md into what pandoc reads: its own table of
# contents, its own signs for formulas, code numbered as in lib/.

/^# [0-9]/ { begun = 1 }
!begun { next }                                 # pandoc makes the contents

/^\[.*, lines? [0-9]+/ { first = $0; sub(/.*#L/, "", first); first += 0 }
/^```math/ { formula = "$$"; next }
formula != "" {                                 # one line: "+ b" is no list
    if ($0 == "```") { print formula " $$"; formula = "" } else formula = formula " " $0
    next
}
/^```/ { inside = !inside }
/^```c/ && first { print "```{.c .numberLines startFrom=" first "}"; first = 0; next }
inside || /^```/ { print; next }
{
    while (match($0, /\$`[^`]*`\$/)) {          # $`a`$ becomes $a$
        printf "%s$%s$", substr($0, 1, RSTART - 1), substr($0, RSTART + 2, RLENGTH - 4)
        $0 = substr($0, RSTART + RLENGTH)
    }
    print
}
