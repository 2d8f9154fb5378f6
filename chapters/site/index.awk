# index.awk - the first page: awk -f index.awk index.md README.md
# README's tables of chapters stand where index.md has the line %% chapters.

FILENAME ~ /index\.md$/ { line[++lines] = $0; next }
/^\*\*(Part|Appendices)/ && match($0, /\*\*[^*]*\*\*/) {
    part = substr($0, RSTART + 2, RLENGTH - 4); sub(/\.$/, "", part)
    rows = rows "\n### " part "\n\n"
}
/^\| ([0-9][0-9][a-z]? )?\| *\[/ {
    sub(/^\| \|/, "|  |")
    split($0, cell, " [|] "); number = substr(cell[1], 3)
    link = cell[2]; sub(/chapters\/woven\//, "", link); sub(/\.md/, ".html", link); sub(/ \|$/, "", cell[3])
    rows = rows "- [" number "]{.number} " link " [" cell[3] "]{.question}\n"
}
END { for (i = 1; i <= lines; i++) print line[i] == "%% chapters" ? rows : line[i] }
