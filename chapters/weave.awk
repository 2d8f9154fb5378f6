# weave.awk - writes the book: the chapters, with the code that they explain.
#
#   awk -v pages=chapters/woven -f weave.awk CODE chapters/[0-9]*.md > book.md
#
# Each chapter becomes a page of its own as well, in the folder `pages`, if one is
# named (weave.sh says what is CODE, and calls this).
#
# In the code a region lies between a line "//> name" and a line "//<"; in a
# chapter the line "@@ name" stands for it, "%% figures/name.csv" for a table of
# that file, "%% figures/name.csv rooms" for the table of its lines "#rooms| ",
# and "%% functions" for an index of all that the headers of lib/ declare.
# Within a line {{02-rope 3; 64; cost}} stands for a number: of
# figures/02/02-rope.csv, block 3 (of those that two blank lines part, from 0; or
# a table's name; without one, 0), the row that opens with 64, the column cost.
# {{02-rope #; words; 2}} is the number after these words in the file's comments.
# A last field says how: 3 (digits, else 2), "%", "3 %"; and {{a / b; 2}} is the
# quotient of two such cells.
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
# --- numbers in a sentence ---
# Reads a CSV once: the rows of each block, their head, and all comments.  The
# head is the comment above the rows; where cells stand between commas, the
# first row.
function read_rows(csv,    got, line, block, blank, head, block_name) {
    block = -1; blank = 2
    while ((got = (getline line < csv)) > 0) {
        if (line ~ /^#[a-z]+[|] /) {
            block_name = substr(line, 2, index(line, "|") - 2)
            add_row(csv, block_name, substr(line, length(block_name) + 4)); continue
        }
        if (line ~ /^#/) { notes[csv] = notes[csv] "\n" line; head = substr(line, 3); continue }
        if (line == "") { blank++; continue }
        if (blank >= 2) block++
        blank = 0; add_row(csv, block, line, head)
    }
    close(csv)
    return was_read[csv] = got >= 0
}
function add_row(csv, block, line, head,    bare) {
    bare = line; gsub(/"[^"]*"/, "", bare)
    if (!((csv, block) in heads)) {
        comma[csv, block] = bare ~ /,/
        heads[csv, block] = comma[csv, block] ? line : head
        if (comma[csv, block]) return
    }
    row_at[csv, block, ++rows_of[csv, block]] = line
}
# Splits a row into cells, and counts them.
function split_row(line, by_comma, cell,    n) {
    line = line (by_comma ? "," : " ")
    while (match(line, by_comma ? "^(\"[^\"]*\"|[^\",]*)," : "^ *(\"[^\"]*\"|[^\" ]+) +")) {
        cell[++n] = substr(line, 1, RLENGTH - 1); line = substr(line, RLENGTH + 1)
        gsub(/^ *"?|"? *$/, "", cell[n])
    }
    return n
}
# The number that "02-rope 3; 64; cost" names; "" and a complaint if none is.
function number_of(address,    part, where, csv, block, i, k, at, entry, cell, head, n) {
    split(address, part, /; */); split(part[1], where, " ")
    csv = where[1] ~ /^[0-9][0-9]-/ ? substr(where[1], 1, 2) "/" where[1] : where[1] ~ /\// ? where[1] : "tables/" where[1]
    csv = "figures/" csv ".csv"; block = where[2] == "" ? 0 : where[2]
    if (!(csv in was_read)) read_rows(csv)
    if (!was_read[csv]) return none("there is no file " csv)
    if (block == "#") return number_after(notes[csv], part[2], csv)
    for (i = 1; i <= rows_of[csv, block]; i++) {
        entry = row_at[csv, block, i]; gsub(/"/, "", entry)
        if (index(entry " ", part[2] " ") == 1 || index(entry, part[2] ",") == 1) { at = i; k++ }
    }
    if (k != 1) return none("in " csv ", " block ", " k + 0 " rows open with " part[2])
    split_row(row_at[csv, block, at], comma[csv, block], cell); k = part[3] ~ /^[0-9]+$/ ? part[3] : 0
    n = split_row(heads[csv, block], comma[csv, block], head)
    for (i = 1; i <= n && !k; i++) if (head[i] == part[3]) k = i
    if (!(k in cell) || cell[k] !~ /^-?[0-9.]/) return none("in " csv ", " block ", no number stands under " part[3])
    return cell[k] + 0
}
function number_after(text, words, csv,    at) {
    at = words == "" ? 0 : index(text, words); text = substr(text, at + length(words))
    if (!at || !match(text, /^[^0-9\n]*-?[0-9][0-9.]*(e[-+]?[0-9]+)?/)) return none("no comment of " csv " has a number after " words)
    text = substr(text, 1, RLENGTH); sub(/^[^0-9]*/, "", text)
    return text + 0
}
function none(sentence) { fail(file, FNR, sentence); return "" }
# x in so many digits that count; what is very large or small, with a power of ten.
function digits(x, n,    power, out, minus) {
    if (x == 0) return "0"
    minus = x < 0; if (minus) x = -x
    out = sprintf("%." (n - 1) "e", x); power = substr(out, index(out, "e") + 1) + 0; sub(/e.*/, "", out)
    if (power < -4 || power > 7) return "$`" (minus ? "-" : "") out "\\cdot 10^{" power "}`$"
    out = sprintf("%." (n - 1 > power ? n - 1 - power : 0) "f", out * 10 ^ power)
    if (power > 5) out = substr(out, 1, power - 5) "," substr(out, power - 4)
    if (power > 2) { n = length(out) - (index(out, ".") ? length(out) - index(out, ".") + 1 : 0); out = substr(out, 1, n - 3) "," substr(out, n - 2) }
    return (minus ? "\342\210\222" : "") out
}
# What stands for {{inside}}: a cell, or a quotient of two.
function say_number(inside,    form, cell, x, y) {
    if (match(inside, /; *([0-9]+ *%?|%)$/)) { form = substr(inside, RSTART + 1); inside = substr(inside, 1, RSTART - 1) }
    split(inside " / ", cell, / \/ /); x = number_of(cell[1]); y = cell[2] == "" ? 1 : number_of(cell[2])
    if (x == "" || y == "") return ""
    return digits((form ~ /%/ ? 100 : 1) * x / y, form + 0 ? form + 0 : 2) (form ~ /%/ ? " %" : "")
}
function with_numbers(line,    out, from, past) {
    while (match(line, /\{\{[^}]*\}\}/)) {
        from = RSTART; past = RSTART + RLENGTH
        out = out substr(line, 1, from - 1) say_number(substr(line, from + 2, past - from - 4))
        line = substr(line, past)
    }
    return out line
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
