# weave.awk - writes the book: the chapters, with the code that they explain.
#
#   awk -v pages=chapters/woven -f numbers.awk -f pieces.awk -f weave.awk CODE chapters/[0-9]*.md > book.md
#
# Each chapter becomes a page of its own as well, in the folder `pages`, if one is
# named (weave.sh says what is CODE, and calls this).
#
# In the code a region lies between a line "//> name" and a line "//<", in Python
# "#> name" and "#<"; in a chapter the line "@@ name" stands for it.  What no chapter pulls in is shown by
# the reference, "The library, line by line": a page a module, written here, in
# the order that `order` names.  There a region's text is that of the lines
# "//>   A sentence." below its marker, or the comment that it begins with.
# "%% figures/name.csv" stands for a table of that file, "%% figures/name.csv
# rooms" for the table of its lines "#rooms| ",
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
function lines_of(name) {
    return from[name] + 2 == to[name] ? "line " to[name] - 1 : "lines " from[name] + 1 " to " to[name] - 1
}
function chapter_of(page) { sub(/-.*/, "", page); return page }
# A region under its caption; above a piece, where it goes.  Pieces that are typed
# in one go share a block: "@@ little_a little_b".
function weave(name) { weave_all(1, one_of, name) }
function weave_all(n, names, name,    k) {
    if (name != "") names[1] = name
    if (names[1] in comes) print_later(where_it_goes(n, names) "\n")
    for (k = 1; k <= n; k++) print_later(caption_of(names[k]))
    print_later("\n```" (home[names[1]] ~ /\.py$/ ? "python" : "c"))
    for (k = 1; k <= n; k++) {
        if (k > 1 && (ends_header(names[k]) || text[home[names[k]], from[names[k]] - 1] == "") && text[home[names[k]], from[names[k]] + 1] != "") print_later("")
        print_lines(names[k])
    }
    print_later("```")
}
function caption_of(name,    first, last, names) {
    first = from[name] + 1; last = to[name] - 1
    names = names_in(home[name], first, last); if (names) names = ": " names
    return "[" home[name] ", " lines_of(name) names "](../" home[name] "#L" first (first == last ? "" : "-L" last) ")"
}
function print_lines(name,    i) {
    for (i = from[name] + 1; i < to[name]; i++) print_later(text[home[name], i])
}
# The line "@@ name" of a chapter, or "@@ little_a little_b".
function pull_in(n, names,    k) {
    for (k = 1; k <= n; k++) {
        if (!(names[k] in home)) fail(file, FNR, "there is no region " names[k])
        else if (k > 1 && !(names[k] in comes && names[1] in comes)) fail(file, FNR, "only pieces of the little program share a block")
        else if (names[k] in used) fail(file, FNR, "region " names[k] " is already pulled in by " used[names[k]])
        else { used[names[k]] = file ", line " FNR; told[names[k]] = page; continue }
        return
    }
    weave_all(n, names)
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
function list_functions(    i, header, list, name) {
    for (i = 1; i <= functions; i++) {
        if (place[i] != header) {
            header = place[i]; name = module_of(header)
            list = list (list == "" ? "" : "\n\n") "**" name "**, " \
                (inside[i] in told ? "[chapter " chapter_of(told[inside[i]]) "](" told[inside[i]] "):" : "[line by line](" reference(name) "):")
        } else list = list ","
        list = list " [`" declared[i] "`](../" header "#L" at_line[i] ")"
    }
    return list
}
# What is printed later links from the folder of the chapters: ../lib/, 01-a.md.
function print_later(line) { book[++lines] = line; from_page[lines] = page }
# In book.md, which stands a folder higher, a link to a chapter is one to its title.
function line_of_book(line,    name) {
    gsub(/\]\(\.\.\//, "](", line)
    while (match(line, /\]\(([0-9][0-9]|lib-)[a-z0-9_-]*\.md\)/)) {
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
            print "<!-- Woven by `make book` from " (from_page[i] ~ /^lib-/ ? "lib/" : "chapters/" from_page[i] " and the code") ": edit those, not this. -->\n" > page
        }
        line = book[i]; gsub(/\]\(\.\.\//, "](../../", line)
        print line > page
        if (is_picture(line)) print "\n" caption_under(line) > page
        if (from_page[i] == from_page[i + 1]) continue
        print "\n---\n\n" way(k - 1, " · ", "") "[Contents](../../README.md#read)" way(k + 1, "", " · ") > page
        close(page)
    }
}
# A picture alone, with no link in its words.
function is_picture(line,    part) { return line ~ /^!\[.*\]\([^)]*\)$/ && split(line, part, /\]\(/) == 2 }
# A forge shows a picture without its words: here they are, for the eyes.  (page.awk
# leaves them out again.)
function caption_under(image,    live) {
    if (image ~ /figures\/live\/[a-z]*\.webp\)$/) live = " <em>It moves in the pages that `make site` makes.</em>"
    sub(/^!\[/, "", image); sub(/\]\([^)]*\)$/, "", image)
    return "<sub>" image live "</sub>"
}
function way(k, after, before) {
    return k in title ? before "[" title[k] "](" file_of[k] ")" after : ""
}
# lib/paper/gjk.c and gjk.h are of the module gjk.
function module_of(path) {
    if (path ~ /^chapters\/little\//) return "little"
    sub(/.*\//, "", path); sub(/\.[ch]$/, "", path)
    return path
}
function reference(module) { return "lib-" module ".md" }
# A page a module: what the chapters do not show of it, and where the rest is.
function write_reference(    n, m, i, k, module, listed, some, shown) {
    n = split(order, module, " ")
    for (m = 1; m <= n; m++) listed[module[m]]
    for (i = 1; i <= regions; i++) if (!((k = module_of(home[region[i]])) in listed)) { module[++n] = k; listed[k] }
    for (m = 1; m <= n; m++) {
        for (i = k = 0; i < regions && !k; ) k = module_of(home[region[++i]]) == module[m] && !(region[i] in used)
        if (k) shown[++some] = module[m]
    }
    if (some) write_index(some, shown)
    for (m = 1; m <= some; m++) write_module(shown[m])
}
function write_index(n, shown,    m, list) {
    begin_page("lib-index.md", "The library, line by line")
    for (m = 1; m <= n; m++) list = list (m > 1 ? " · " : "") "[`" shown[m] "`](" reference(shown[m]) ")"
    print_later("Each module that the chapters do not show whole, in the book's order. With the chapters these pages hold each line of the library once.\n\n" list "\n")
}
function begin_page(file, name) {
    page = file
    title[++pages_of] = name; file_of[pages_of] = page
    chapter[page] = anchor(name)
    print_later("# " name "\n")
}
function write_module(module,    i, name, first) {
    begin_page(reference(module), module ", line by line")
    listing = listing (listing ? " · " : "  \n  ") "[" module "](#" chapter[page] ")"
    print_later("The lines of " module " that no chapter shows, in the order of its " (module == "little" ? "stages" : "files") ".\n")
    if (module == "little") { write_pieces(); return }
    for (i = 1; i <= regions; i++) if (module_of(home[name = region[i]]) == module) {
        if (ends_header(name) && is_shown_here(region[i - 1], name)) continue
        if (!(name in used)) show_in_reference(name, ends_header(region[i + 1]) && is_shown_here(name, region[i + 1]) ? region[i + 1] : "")
        else if (!first) first = name
        if (!first || same_place(first, region[i + 1])) continue
        print_later("From [line " from[first] + 1 "](../" home[first] "#L" from[first] + 1 ") of " home[first] " to line " to[name] - 1 ": [chapter " chapter_of(told[first]) "](" told[first] ").\n")
        first = ""
    }
}
# Are both in one file, and shown in one chapter?
function same_place(a, b) {
    return b in used && home[a] == home[b] && told[a] == told[b]
}
# The last line of a header needs no sentence, and stands below what it ends.
function ends_header(name) { return !(name in used) && to[name] == from[name] + 2 && text[home[name], from[name] + 1] == "#endif" }
function is_shown_here(name, last) { return !(name in used) && home[name] == home[last] }
function show_in_reference(name, last,    both) {
    if (ends_header(name)) ;
    else if (sentence[name] != "") print_later(sentence[name] "\n")
    else if (!(name in comes) && text[home[name], from[name] + 1] !~ /^\/\//)
        fail(home[name], from[name], "region " name " is in no chapter, and has no sentence for the reference")
    both[1] = name; both[2] = last
    weave_all(last == "" ? 1 : 2, both); print_later("")
}
function end_of_file() {
    if (open != "") fail(home[open], from[open], "region " open " is never closed")
    if (fence) fail(file, fence, "this ``` block is never closed")
    open = ""; fence = 0
}

FNR == 1 { end_of_file(); file = FILENAME; is_code = file ~ /\.([ch]|py)$/ }
FNR == 1 { page = substr(file, 10) }        # after "chapters/"

# --- code: remember every line, and where each region lies ---
is_code && file ~ /\.py$/ { sub(/^#[<>]/, "//&"); sub(/^\/\/#/, "//") }
is_code { text[file, FNR] = $0 }
is_code && /^\/\/> ([a-z0-9-]+|little_[a-z0-9_]+( [0-9][0-9][a-z])+)$/ {
    if (open != "") fail(file, FNR, "region " $2 " opens inside region " open)
    open = $2
    if (open in home) {
        fail(file, FNR, "region " open " already stands in " home[open] ", line " from[open])
        open = open "-again"
    } else region[++regions] = open
    home[open] = file; from[open] = FNR
    if (NF > 2) note_piece(regions, NF)
    next
}
is_code && /^\/\/>   [^ ]/ && open != "" && from[open] == FNR - 1 {
    sentence[open] = sentence[open] (sentence[open] == "" ? "" : " ") substr($0, 7); from[open] = FNR
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
    if (NF < 2 || $1 != "@@" || $0 !~ /^@@( [a-z0-9_-]+)+$/) fail(file, FNR, "a region is pulled in by @@ name, and nothing more")
    else { split("", asked); for (k = 2; k <= NF; k++) asked[k - 1] = $k; pull_in(NF - 1, asked) }
    next
}
/^%%/ {
    if (NF == 2 && $1 == "%%" && $2 == "functions") { print_later(""); index_at = lines }
    else if (NF <= 3 && $1 == "%%" && $2 ~ /\.csv$/ && $3 ~ /^[a-z]*$/) tabulate($2, $3)
    else fail(file, FNR, "a table is pulled in by %% figures/name.csv, perhaps its name, and nothing more")
    next
}
/\]\((figures|lib|tests|exercises)\// {
    fail(file, FNR, "a chapter links from its own folder: write ../figures/, ../lib/")
}
/^# / {
    title[++entries] = substr($0, 3); file_of[entries] = page; pages_of = entries
    top = anchor(title[entries]); chapter[page] = top
    toc[entries] = "- **[" title[entries] "](#" top ")**"; gap = "  \n  "
}
/^## /  { toc[entries] = toc[entries] gap "[" substr($0, 4) "](#" anchor(substr($0, 4)) ")"; gap = " · " }
/^###+ / { heading = $0; sub(/^#+ /, "", heading); anchor(heading) }
{ print_later(index($0, "{{") ? with_numbers($0) : $0) }

END {
    end_of_file()
    if (index_at) book[index_at] = list_functions()
    write_reference()
    if (listing) toc[++entries] = "- **[The library, line by line](#" chapter["lib-index.md"] ")**" listing
    for (i = 1; i <= lines; i++) woven[i] = line_of_book(book[i])
    if (failures) exit 1
    print "<!-- Woven by `make book` from chapters/, lib/ and tests/: edit those, not this. -->"
    print "\n# tumble: a world of particles and sticks\n"
    for (i = 1; i <= entries; i++) print toc[i] (i < entries ? "" : "\n")
    for (i = 1; i <= lines; i++) print woven[i]
    if (pages) write_pages()
}
