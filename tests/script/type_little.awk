# type_little.awk - types the little program as a reader would, by nothing but what
# the book says above each piece:
#   awk -v stage=07b -f type_little.awk chapters/woven/0*.md chapters/woven/lib-little.md
# prints the program as it is then, without blank lines, and fails where the book's
# words lead to no place, or to two.

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
    for (i = 1; i <= n && order[i] "" <= stage ""; i++)
        for (b = 1; b <= blocks; b++) if (of[b] == order[i]) type(place[b], code[b])
    for (i = 1; i <= lines; i++) print line[i]
    exit failed
}

function fail(what) {
    if (!failed++) print "stage " order[i] ", \"" here "\": " what > "/dev/stderr"
}
# Reads ", in `find`, after `x;`, in place of `y`", and does it.
function type(says, text,    at, m) {
    here = says; low = 1; high = lines; at = 0; inside = 0
    if (says ~ /^ \(delete /) {
        m = index(says, ")")
        while (substr(says, m + 1) !~ /^(,|$)/) m += index(substr(says, m + 1), ")")
        delete_all(substr(says, 10, m - 10)); says = substr(says, m + 1)
    }
    if (says ~ /^, in `/) { find(word(says)); low = first; high = last; inside = 1; says = rest(says) }
    if (says ~ /^, at its end/) { at = high; says = substr(says, 13) }
    else if (says ~ /^, at the end/) { at = lines + 1; says = substr(says, 13) }
    else if (says ~ /^, the first lines/) { at = 1; says = substr(says, 18) }
    else if (says ~ /^, at the top/) { for (at = low; inside && line[at] != "{"; at++) ; at += inside; says = substr(says, 13) }
    else if (says ~ /^, after `/) { find(word(says)); at = last + 1; says = rest(says) }
    else if (says ~ /^, before `/) { find(word(says)); at = first; says = rest(says) }
    if (says ~ /^, in place of /) {
        m = lines; says = delete_all(substr(says, 15))
        at = at ? at - (m - lines) * (lowest < at) : lowest
    }
    if (says != "" || !at) fail("that is no place")
    insert(at, text)
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
        if (from) { name = first; find(word(says)); first = name; says = rest(says); if (says ~ /^ in `/) says = rest(says) }
        if (first < lowest) lowest = first
        remove()
        low = 1; high = lines
    }
    return says
}
# Sets first and last: of a function or a type with its comment, or of a line.
function find(name,    i, k, s, hits) {
    first = last = hits = 0
    for (i = low; i <= high && i <= lines; i++) {
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
