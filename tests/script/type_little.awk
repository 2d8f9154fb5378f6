# type_little.awk - types the little program as a reader would, by nothing but what
# the book says above each piece:
#   awk -v out=FOLDER -f type_little.awk chapters/woven/[01]*.md chapters/woven/lib-little.md
# writes FOLDER/07b, the program as it is then, without blank lines, for each stage,
# and fails where the book's words lead to no place, or to two.

FNR == 1 { ready = 0 }
/^\*Stage [0-9][0-9][a-z]\*.*:$/ {
    of[++blocks] = substr($2, 1, 3)
    place[blocks] = substr($0, 12, length($0) - 12)
    ready = 1
}
ready == 2 && $0 == "```" { ready = 0 }
ready == 2 { code[blocks] = code[blocks] $0 "\n" }
ready == 1 && $0 == "```c" { ready = 2 }
END {
    for (b = 1; b <= blocks; b++) if (!(of[b] in known)) { known[of[b]]; order[++n] = of[b] }
    for (i = 2; i <= n; i++)
        for (k = i; k > 1 && order[k - 1] > order[k]; k--) { was = order[k]; order[k] = order[k - 1]; order[k - 1] = was }
    for (i = 1; i <= n && !failed; i++) {
        for (b = 1; b <= blocks; b++) if (of[b] == order[i]) type(place[b], code[b])
        keep_stage(order[i])
        for (k = 1; k <= lines; k++) print line[k] > (out "/" order[i])
    }
    exit failed
}

function fail(what) {
    if (!failed++) print "stage " order[i] ", \"" here "\": " what > "/dev/stderr"
}
# Reads ", in `find`, after `x;`, in place of `y`", and does it.
function type(says, text,    m) {
    here = says; low = 1; high = lines
    if (says ~ /^ \(take back /) says = take_back(substr(says, 12))
    if (says ~ /^ \(delete /) {
        m = index(says, ")")
        while (substr(says, m + 1) !~ /^(,|$| \()/) m += index(substr(says, m + 1), ")")
        low = 1; high = lines; delete_all(substr(says, 10, m - 10)); says = substr(says, m + 1)
    }
    if (says ~ /^ \(keep /) {
        m = index(says, "; delete all else)")
        keep_all(substr(says, 7, m - 7)); says = substr(says, m + 18)
    }
    says = go_to(says)
    if (says ~ /^, in place of /) {
        m = lines; says = delete_all(substr(says, 15))
        at = at ? at - (m - lines) * (lowest < at) : lowest
    }
    if (says != "" || !at) fail("that is no place")
    insert(at, text)
}
# Sets `at` to the place that is named, 0 if none is, and returns what follows.
function go_to(says,    inside) {
    low = 1; high = lines; at = 0
    if (says ~ /^, in `/) { find(word(says)); low = first; high = last; inside = 1; says = rest(says) }
    if (says ~ /^, at its end/) { at = high; says = substr(says, 13) }
    else if (says ~ /^, at the end/) { at = lines + 1; says = substr(says, 13) }
    else if (says ~ /^, the first lines/) { at = 1; says = substr(says, 18) }
    else if (says ~ /^, at the top/) { for (at = low; inside && line[at] != "{"; at++) ; at += inside; says = substr(says, 13) }
    else if (says ~ /^, after `/) { find(word(says)); at = last + 1; says = rest(says) }
    else if (says ~ /^, before `/) { find(word(says)); at = first; says = rest(says) }
    return says
}
# Copies "`a`, the lines from `b;` to `c;` of stage 12c, in `f`, after `d;`; `e` of
# stage ...)" from the programs of those stages.
function take_back(says,    names, text, m) {
    do {
        m = match(says, / of stage [0-9][0-9][a-z]/)
        names = substr(says, 1, m - 1)
        text = copied(names, substr(says, m + 10, 3))
        says = go_to(substr(says, m + 13))
        if (!at) fail("that is no place to take something back to")
        insert(at, text)
    } while (says ~ /^; / && !failed)
    return substr(says, 2)
}
# That of the program of an earlier stage.
function copied(names, from,    i, n, is, text, span) {
    n = lines
    for (i = 1; i <= n; i++) is[i] = line[i]
    lines = typed_lines[from]
    for (i = 1; i <= lines; i++) line[i] = typed[from, i]
    while (index(names, "`") && !failed) {
        span = names ~ /^(,|;)? ?the lines from/
        low = 1; high = lines
        find(word(names)); names = rest(names)
        if (span) { find_end(word(names)); names = rest(names) }
        while (!span && line[first - 1] ~ /^\/\/ [^-]/) first--
        for (i = first; i <= last; i++) text = text line[i] "\n"
    }
    lines = n
    for (i = 1; i <= n; i++) line[i] = is[i]
    return text
}
function keep_stage(id,    i) {
    typed_lines[id] = lines
    for (i = 1; i <= lines; i++) typed[id, i] = line[i]
}
# What stands in the next backquotes, and what follows them.
function word(says) { says = substr(says, index(says, "`") + 1); return substr(says, 1, index(says, "`") - 1) }
function rest(says) { says = substr(says, index(says, "`") + 1); return substr(says, index(says, "`") + 1) }
# Deletes "`a`, `b;` in `c`, the lines from `d;` to `e;`"; `lowest` is where.
function delete_all(says,    name, from, until) {
    lowest = lines + 1; until = high
    while (index(says, "`") && !failed) {
        from = says ~ /^(, )?the lines from/; name = word(says); says = rest(says)
        if (says ~ /^ in `/) { find(word(says)); low = first; high = last; says = rest(says) }
        find(name)
        if (from) { find_end(word(says)); says = rest(says); if (says ~ /^ in `/) says = rest(says) }
        if (first < lowest) lowest = first
        remove()
        low = 1; high = lines
    }
    return says
}
# Keeps the lines with #include, and what is named.
function keep_all(says,    i, k, n, stays) {
    low = 1; high = lines
    for (i = 1; i <= lines; i++) if (line[i] ~ /^#include/) stays[i]
    for (says = rest(says); index(says, "`") && !failed; says = rest(says)) {
        find(word(says))
        for (k = first; k <= last; k++) stays[k]
    }
    for (i = 1; i <= lines; i++) if (i in stays) line[++n] = line[i]
    lines = n
}
# The lines from `first` to the next one like that: to `last`.
function find_end(name,    from) {
    from = low = first; nearest = 1
    find(name)
    first = from; nearest = 0
}
# Sets first and last: of a function or a type with its comment, or of a line.
function find(name,    i, k, s, hits) {
    first = last = hits = 0
    for (i = low; i <= high && i <= lines && !(nearest && hits); i++) {
        s = line[i]; sub(/[ \t]*\/\/.*/, "", s); sub(/^[ \t]+/, "", s)
        if (name !~ /^[a-z0-9_]+$/) { if (s == name) { first = last = i; hits++ }; continue }
        if (index(line[i], "} " name ";") == 1) { last = i; for (k = i; line[k] !~ /^typedef/ && k > 1; k--) ; first = k; hits++ }
        else if (line[i] ~ "^[a-z][a-z0-9_ ]*[ *]" name "\\(" && line[i] !~ /;$/) {
            first = i; for (k = i; line[k] !~ /}$/ || (k > i && line[k] != "}"); k++) if (k > lines) break
            last = k; hits++
        }
    }
    if (hits != 1) { fail("`" name "` is there " hits " times"); return }
    if (name ~ /^[a-z0-9_]+$/) while (line[first - 1] ~ /^\/\/ [^-]/) first--
}
function remove(    k, n) {
    if (!first) return
    n = last - first + 1
    for (k = first; k <= lines - n; k++) line[k] = line[k + n]
    lines -= n
}
function insert(at, text,    part, n, k, i) {
    n = split(text, part, "\n") - 1
    for (k = i = 1; k <= n; k++) if (part[k] != "" && part[k] !~ /^\/\/ ---/) part[i++] = part[k]
    n = i - 1
    for (k = lines; k >= at; k--) line[k + n] = line[k]
    for (k = 1; k <= n; k++) line[at + k - 1] = part[k]
    lines += n
}
