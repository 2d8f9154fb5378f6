# prose.awk - what a reader reads as sentences: without code, formulas, links,
# names of exercises and lines that pull code in.   awk -f prose.awk page.md ...

FNR == 1 { inside = 0 }
/^ *```/ { inside = !inside; print ""; next }
inside || /^(@@|%%) / { print ""; next }
{
    gsub(/\{\{[^}]*\}\}/, "1")
    gsub(/\$`[^`]*`\$/, " ")
    gsub(/`[^`]*`/, " ")
    gsub(/<[a-z\/][^>]*>/, " ")
    gsub(/\]\([^)]*\)/, "]")
    gsub(/[0-9][0-9][a-z]?\/[a-z0-9-]+/, " ")
    gsub(/[A-Za-z0-9]*_[A-Za-z0-9_]+|[a-z0-9]+\(/, " ")     # hints have bare code
    print
}
