# source.awk - a file of C as a page on which each line has an anchor, and each
# region's opening leads to where the book explains it.
#
#   awk -f source.awk build/places lib/paper/gjk.c > gjk.c.html

function escaped(s) { gsub(/&/, "\\&amp;", s); gsub(/</, "\\&lt;", s); return s }
# Words of the language, strings and comments have the colours of the book.
function coloured(s,    out, word) {
    while (match(s, /\/\/.*|\/\*.*|"([^"\\]|\\.)*"|[A-Za-z_][A-Za-z0-9_]*/)) {
        word = substr(s, RSTART, RLENGTH)
        out = out escaped(substr(s, 1, RSTART - 1)) \
            (word ~ /^\/[\/*]/ ? mark("co", word) : word ~ /^"/ ? mark("st", word) : word in kind ? mark(kind[word], word) : word)
        s = substr(s, RSTART + RLENGTH)
    }
    return out escaped(s)
}
function mark(class, s) { return "<span class=\"" class "\">" escaped(s) "</span>" }

BEGIN {
    split("break case const do else enum extern for if inline return sizeof static struct switch typedef union while", word, " ")
    for (i in word) kind[word[i]] = "kw"
    split("bool char double float int long short signed size_t unsigned void", word, " ")
    for (i in word) kind[word[i]] = "dt"
}
# Which page has the lines from here.
FILENAME ~ /places$/ { told[$1, $2] = $3; next }
FNR == 1 {
    print "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">" \
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">" \
        "<meta name=\"color-scheme\" content=\"light dark\"><title>" FILENAME " · tumble</title>" \
        "<link rel=\"icon\" href=\"../icon.svg\"><link rel=\"stylesheet\" href=\"../style.css\"></head>\n<body class=\"source\">" \
        "<header class=\"bar\"><a class=\"home\" href=\"../index.html\">tumble</a> <a href=\"../index.html#chapters\">Contents</a></header>\n" \
        "<main><h1>" FILENAME "</h1>\n<pre tabindex=\"0\"><code>"
}
/^\/\/>/ && (FILENAME, FNR + 1) in told {
    page = number = told[FILENAME, FNR + 1]; sub(/-.*/, "", number)
    base = FILENAME; sub(/.*\//, "", base)
    print "<a id=\"L" FNR "\" class=\"told\" href=\"../" page ".html#" base "-L" FNR + 1 "\">chapter " substr(page, 1, 2) ": " $2 "</a>"
    next
}
{ print "<span id=\"L" FNR "\">" coloured($0) "</span>" }
END { print "</code></pre></main></body></html>" }
