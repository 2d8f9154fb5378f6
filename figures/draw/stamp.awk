# stamp.awk - what each product of figures/ is made of:
#   awk -v into=FOLDER -f stamp.awk SOURCE... < PRODUCTS
# writes each source into FOLDER without its comments and white space, which
# change nothing that is measured, and FOLDER/made-of: a line for each product,
# of its name and all sources of its program (PRODUCTS: see products.awk).  These
# are what it includes, in turn, and of each header the .c of its name; a.h also
# stands for any a_b.c that has no a_b.h.

FNR == 1 { finish(); begin(FILENAME) }
{ bare($0) }
END {
    finish()
    while ((getline < "-") > 0) {
        m = split($2, program, ",")
        split("", wanted); count = 0
        for (i = 1; i <= m; i++) want(program[i])
        line = $1
        for (i = 1; i <= count; i++) line = line " " queue[i]
        print line > (into "/made-of")
    }
}

function begin(path,    name) {
    source = path; inside = 0; text = ""; is_c = path ~ /\.(c|h|cpp)$/
    name = path; sub(/.*\//, "", name)
    path_of[name] = path_of[name] " " path
    here[path] = 1; sources[++n] = path
}
function finish() {
    if (source == "") return
    printf "%s\n", text > (into "/" flat(source)); close(into "/" flat(source))
    source = ""
}
function flat(path) { gsub(/\//, "%", path); return path }

# Adds a line without comments; blanks stay in "strings" only.
function bare(line,    out, piece, directive) {
    if (!is_c) { text = text line "\n"; return }
    directive = line ~ /^ *#/
    if (line ~ /^ *# *include *"/) { piece = line; sub(/^[^"]*"/, "", piece); sub(/".*/, "", piece); includes[source] = includes[source] " " piece }
    while (line != "") {
        if (inside) {
            if (!match(line, /\*\//)) break
            line = substr(line, RSTART + 2); inside = 0; continue
        }
        if (!match(line, /"([^"\\]|\\.)*"|'([^'\\]|\\.)*'|\/\/|\/\*/)) { out = out packed(line); break }
        out = out packed(substr(line, 1, RSTART - 1)); piece = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        if (piece == "//") break
        if (piece == "/*") inside = 1; else out = out piece
    }
    if (out != "") text = text out (directive ? "\n" : "")
}
function packed(code) { gsub(/[ \t]+/, "", code); return code }

function want(path,    i, k, part, name, stem, folder, m) {
    if (!(path in here) || path in wanted) return
    wanted[path] = 1; queue[++count] = path
    m = split(includes[path], part, " ")
    for (i = 1; i <= m; i++) want(nearest(part[i], path))
    if (path !~ /\.(c|h|cpp)$/) return
    stem = path; sub(/\.[a-z]+$/, "", stem)
    if (path ~ /\.h$/) { want(stem ".c"); want(stem ".cpp") }
    if (stem == "lib/tumble") stem = "lib/public/tumble"
    if (path ~ /\.h$/ || path ~ /^figures\/peers\//)
        for (k = 1; k <= n; k++) if (index(sources[k], stem "_") == 1 && sources[k] ~ /\.(c|cpp)$/) {
            name = sources[k]; sub(/\.[a-z]+$/, ".h", name)
            if (!(name in here)) want(sources[k])
        }
}
# The file of this name: in the folder of the one that asks, or the only one.
function nearest(name, asker,    folder, part) {
    folder = asker; sub(/[^\/]*$/, "", folder)
    if ((folder name) in here) return folder name
    sub(/.*\//, "", name); split(path_of[name], part, " ")
    return part[1]
}
