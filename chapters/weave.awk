# weave.awk - writes the book: the chapters, with the code that they explain.
#
#   awk -v pages=chapters/woven -f numbers.awk -f weave.awk CODE chapters/[0-9]*.md > book.md
#
# Each chapter becomes a page of its own as well, in the folder `pages`, if one is
# named (weave.sh says what is CODE, and calls this).
#
# In the code a region lies between a line "//> name" and a line "//<"; in a
# chapter the line "@@ name" stands for it, "%% figures/name.csv" for a table of
# that file, "%% figures/name.csv rooms" for the table of its lines "#rooms| ",
# and "%% functions" for an index of all that the headers of lib/ declare.
# {{02-rope 3; 64; cost}} within a line is a number of a table: numbers.awk.
# Whatever would let the book and the code drift apart is an error: file, line,
# a sentence, and no book.

function fail(file, line, sentence) {
    printf "%s:%d: %s\n", file, line, sentence > "/dev/stderr"
    failures++
}

# GitHub's anchor of a heading: small letters, digits, - and _; blanks become
# hyphens; the second of one name ends in -1.  (\342.. opens UTF-8's dashes.)
function anchor(heading) {
    heading = tolower(heading)
    gsub(/\342[\200-\277][\200-\277]/, "", heading)
    gsub(/[^a-z0-9 _\200-\377-]/, "", heading)
    gsub(/ /, "-", heading)
    return heading (seen[heading]++ ? "-" seen[heading] - 1 : "")
}
# What lines first to last of a file define or declare at the margin: functions,
# or where there are none, types.
function names_in(path, first, last,    i, line, functions, types) {
    for (i = first; i <= last; i++) {
        line = text[path, i]
        if (line ~ /^[a-z][a-z0-9_ ]*[ *][a-z0-9_]+\(/ && line !~ /^typedef/) {
            sub(/\(.*/, "", line); sub(/.*[ *]/, "", line)
            if (!index(functions ", ", ", " line ", ")) functions = functions ", " line
        } else if (line ~ /^} [a-z0-9_]+;/) {
            gsub(/^} |;.*/, "", line)
            types = types ", " line
        }
    }
    return substr(functions ? functions : types, 3)
}
# A region under its caption.
function weave(name,    i, first, last, names) {
    first = from[name] + 1; last = to[name] - 1
    names = names_in(home[name], first, last); if (names) names = ": " names
    if (first == last) print_later("[" home[name] ", line " first names "](../" home[name] "#L" first ")")
    else print_later("[" home[name] ", lines " first " to " last names "](../" home[name] "#L" first "-L" last ")")
    print_later("\n```c")
    for (i = first; i <= last; i++) print_later(text[home[name], i])
    print_later("```")
}
# A CSV under its caption, as a table: its first row is the head.  Lines that
# open with # are left out, or of a named table all that do not open with its
# name.
function tabulate(csv, name,    got, line, at, rows, head) {
    print_later("[" csv (name ? ", " name : "") "](../" csv ")\n")
    while ((got = (getline line < csv)) > 0) {
        at++
        if (name ? !sub("^#" name "[|] ", "", line) : line ~ /^#/) continue
        line = row(line)
        if (!cells) fail(csv, at, "a cell may hold no \" and no |, and a comma only in quotes")
        else if (rows && cells != head) fail(csv, at, "this row has " cells " cells, the head has " head)
        print_later(line)
        if (!rows++) { head = cells; gsub(/[^|]+/, "---", line); print_later(line) }
    }
    close(csv)
    if (got < 0) fail(file, FNR, "there is no file " csv)
    else if (!rows) fail(file, FNR, "there is no table " (name ? name " " : "") "in " csv)
}
# a,b becomes | a | b |, and its cells are counted: 0 if that cannot be done.
function row(line,    cell, out) {
    cells = 0; out = "|"; line = line ","
    while (match(line, /^("[^"|]*"|[^",|]*),/)) {
        cell = substr(line, 1, RLENGTH - 1); line = substr(line, RLENGTH + 1)
        gsub(/"/, "", cell); out = out " " cell " |"; cells++
    }
    if (line != "") cells = 0
    return out
}
# A paragraph for each header, in the order of the alphabet: its functions, and
# the chapter that they are explained in.
function list_functions(    i, header, paragraph, name) {
    for (i = 1; i <= functions; i++) {
        if (place[i] != header) {
            if (header) print_later(paragraph "\n")
            header = place[i]; name = header
            gsub(/.*\/|\.h$/, "", name)
            paragraph = "**" name "**, [chapter " substr(told[inside[i]], 1, 2) "](" told[inside[i]] "):"
        } else paragraph = paragraph ","
        paragraph = paragraph " [`" declared[i] "`](../" header "#L" at_line[i] ")"
    }
    if (header) print_later(paragraph)
}
# What is printed later links from the folder of the chapters: ../lib/, 01-a.md.
function print_later(line) { book[++lines] = line; from_page[lines] = page }
# In book.md, which stands a folder higher, a link to a chapter is one to its title.
function line_of_book(line,    name) {
    gsub(/\]\(\.\.\//, "](", line)
    while (match(line, /\]\([0-9][0-9]-[a-z0-9_-]*\.md\)/)) {
        name = substr(line, RSTART + 2, RLENGTH - 3)
        if (!(name in chapter)) fail("chapters", 0, "there is no chapter " name)
        line = substr(line, 1, RSTART + 1) "#" chapter[name] substr(line, RSTART + RLENGTH - 1)
    }
    return line
}
# A chapter's page stands a folder lower, and ends with the way to the next one.
function write_pages(    i, k, line) {
    for (i = 1; i <= lines; i++) {
        if (from_page[i] != from_page[i - 1]) {
            k++; page = pages "/" from_page[i]
            print "<!-- Woven by `make book` from chapters/" from_page[i] " and the code: edit those, not this. -->\n" > page
        }
        line = book[i]; gsub(/\]\(\.\.\//, "](../../", line)
        print line > page
        if (from_page[i] == from_page[i + 1]) continue
        print "\n---\n\n" way(k - 1, " · ", "") "[Contents](../../README.md#read)" way(k + 1, "", " · ") > page
        close(page)
    }
}
function way(k, after, before) {
    return k in title ? before "[" title[k] "](" file_of[k] ")" after : ""
}
function end_of_file() {
    if (open != "") fail(home[open], from[open], "region " open " is never closed")
    if (fence) fail(file, fence, "this ``` block is never closed")
    open = ""; fence = 0
}

FNR == 1 { end_of_file(); file = FILENAME; is_code = file ~ /\.[ch]$/ }
FNR == 1 { page = substr(file, 10) }        # after "chapters/"

# --- code: remember every line, and where each region lies ---
is_code { text[file, FNR] = $0 }
is_code && /^\/\/> [a-z0-9-]+$/ {
    if (open != "") fail(file, FNR, "region " $2 " opens inside region " open)
    open = $2
    if (open in home) {
        fail(file, FNR, "region " open " already stands in " home[open] ", line " from[open])
        open = open "-again"
    } else region[++regions] = open
    home[open] = file; from[open] = FNR
    next
}
is_code && /^\/\/<$/ {
    if (open == "") fail(file, FNR, "this closes no region")
    else if (FNR == from[open] + 1) fail(file, FNR, "region " open " is empty")
    to[open] = FNR; open = ""
    next
}
is_code && /^[ \t]*\/\/[<>]/ { fail(file, FNR, "a marker is //> name or //<, alone and at the margin"); next }
is_code && open == "" && /[^ \t]/ { fail(file, FNR, "this line is in no region") }
# What a header declares begins at the margin, with its type.
is_code && file ~ /^lib\/.*\.h$/ && /^[a-z][a-z0-9_ ]*[ *][a-z0-9_]+\(/ && !/^typedef/ {
    declared[++functions] = $0; place[functions] = file; at_line[functions] = FNR; inside[functions] = open
    sub(/\(.*/, "", declared[functions]); sub(/.*[ *]/, "", declared[functions])
}
is_code { next }
# --- chapters/: copy, but for regions, links and headings ---
/^```/ { fence = fence ? 0 : FNR }
fence || /^```/ { print_later($0); next }
/^@@/ {
    if (NF != 2 || $1 != "@@") fail(file, FNR, "a region is pulled in by @@ name, and nothing more")
    else if (!($2 in home)) fail(file, FNR, "there is no region " $2)
    else if ($2 in used) fail(file, FNR, "region " $2 " is already pulled in by " used[$2])
    else { used[$2] = file ", line " FNR; told[$2] = page; weave($2) }
    next
}
/^%%/ {
    if (NF == 2 && $1 == "%%" && $2 == "functions") list_functions()
    else if (NF <= 3 && $1 == "%%" && $2 ~ /\.csv$/ && $3 ~ /^[a-z]*$/) tabulate($2, $3)
    else fail(file, FNR, "a table is pulled in by %% figures/name.csv, perhaps its name, and nothing more")
    next
}
/\]\((figures|lib|tests|exercises)\// {
    fail(file, FNR, "a chapter links from its own folder: write ../figures/, ../lib/")
}
/^# / {
    title[++entries] = substr($0, 3); file_of[entries] = page
    top = anchor(title[entries]); chapter[page] = top
    toc[entries] = "- **[" title[entries] "](#" top ")**"; gap = "  \n  "
}
/^## /  { toc[entries] = toc[entries] gap "[" substr($0, 4) "](#" anchor(substr($0, 4)) ")"; gap = " · " }
/^###+ / { heading = $0; sub(/^#+ /, "", heading); anchor(heading) }
{ print_later(index($0, "{{") ? with_numbers($0) : $0) }

END {
    end_of_file()
    for (i = 1; i <= regions; i++) if (!(region[i] in used))
        fail(home[region[i]], from[region[i]], "region " region[i] " is in no chapter")
    for (i = 1; i <= lines; i++) woven[i] = line_of_book(book[i])
    if (failures) exit 1
    print "<!-- Woven by `make book` from chapters/, lib/ and tests/: edit those, not this. -->"
    print "\n# tumble: a world of particles and sticks\n"
    for (i = 1; i <= entries; i++) print toc[i] (i < entries ? "" : "\n")
    for (i = 1; i <= lines; i++) print woven[i]
    if (pages) write_pages()
}
