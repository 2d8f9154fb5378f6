# page.awk - rewrites a woven page into what pandoc reads: its own signs for
# formulas; and the way to the pages before and after is left to the page.

/^<sub>.*<\/sub>$/ { next }                      # a caption, which the picture has already
/^<!-- Woven|^---$|\]\(\.\.\/\.\.\/README\.md#read\)/ { next }
/^```math/ { formula = "$$"; next }
formula != "" {                                 # one line: "+ b" is no list
    if ($0 == "```") { print formula " $$"; formula = "" } else formula = formula " " $0
    next
}
/^```/ { inside = !inside }
inside || /^```/ { print; next }
{
    while (match($0, /\$`[^`]*`\$/)) {          # $`a`$ becomes $a$
        printf "%s$%s$", substr($0, 1, RSTART - 1), substr($0, RSTART + 2, RLENGTH - 4)
        $0 = substr($0, RSTART + RLENGTH)
    }
    print
}
