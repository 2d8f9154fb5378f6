# single.awk - writes the library as one file, tumble.c, that needs only tumble.h.
#
#   awk -v order="vec3 status ..." -f lib/single.awk LICENSE lib/*.h lib/*/*.[ch]
#
# All headers come first and then all sources, both in the order of the modules;
# of modules that nothing behind tumble.h includes there is nothing.  Only what
# tumble.h declares can be seen from outside, for all else is static.  No name may
# stand in two files: only a macro may, which ends where its file does.

function fail(sentence) { print "single.awk: " sentence > "/dev/stderr"; failed = 1; exit 1 }

# A line without its comment, and with nothing between its quotes.
function bare(s) {
    gsub(/\\./, "", s); gsub(/'.'/, "''", s); gsub(/"[^"]*"/, "\"\"", s); sub(/\/\/.*/, "", s); sub(/ +$/, "", s)
    return s
}

FNR == 1 {
    file = FILENAME; sub(/.*\//, "", file)
    module = file; sub(/\.[ch]$/, "", module)
    if (FILENAME ~ /public\//) wanted[module] = 1
}
/^\/\/[<>]/ || /^#pragma once/ { next }
/^#include "/ { split($0, quoted, "\""); sub(/\.h$/, "", quoted[2]); uses[module] = uses[module] " " quoted[2]; next }
# A file that is compiled once has the passes of the contact solver once.
file == "passes.h" && /^extern const solver_passes/ { sub(/, passes_wide/, "") }
file == "passes.h" && /&passes_wide/ { next }
{ text[file, ++length_of[file]] = $0 }

# A name of file `f` that the whole of it may use.  A source may say again what its
# header says.
function has(f, name) {
    if (name in home && home[name] != f) fail("\"" name "\" stands in " home[name] " and in " f)
    home[name] = f
}
function last_word(s) { sub(/[^A-Za-z_0-9]*$/, "", s); sub(/.*[^A-Za-z_0-9]/, "", s); return s }

# What a statement outside of functions declares: f has enumerators, and then
# the words before "(", or before each "=", "[", "," and ";".
function declares(f, s,    part, n, i, inner) {
    if (match(s, /enum[^{;]*[{][^}]*[}]/)) {
        inner = substr(s, RSTART, RLENGTH); sub(/^[^{]*[{]/, "", inner); sub(/[}]$/, "", inner)
        while (gsub(/\([^()]*\)/, "", inner)) ;
        n = split(inner, part, ",")
        for (i = 1; i <= n; i++) { sub(/=.*/, "", part[i]); if (part[i] ~ /[A-Za-z]/) has(f, last_word(part[i])) }
    }
    while (gsub(/[{][^{}]*[}]/, " ", s)) ;
    if (s ~ /^(enum|struct|union)[^(]*;/) return
    if (s ~ /^[^=]*\(/) { if (s !~ /^[^(]*\( *\*/) { sub(/\(.*/, "", s); has(f, last_word(s)) } return }
    while (gsub(/\[[^][]*\]/, "", s)) ;
    n = split(s, part, /[,;]/)
    for (i = 1; i <= n; i++) { sub(/=.*/, "", part[i]); if (part[i] ~ /[A-Za-z]/) has(f, last_word(part[i])) }
}

# Reads all statements of a file that stand outside of functions.  In a source
# only those are its own that no header declares.
function read(f, source,    i, s, all, n, begun, called) {
    for (i = 1; i <= length_of[f]; i++) {
        s = bare(text[f, i])
        if (text[f, i] ~ /^#define/) { split(s, part, /[ (]+/); macros[f] = macros[f] " " part[2] }
        if (s ~ /^#/ || (!begun && !called && s !~ /^[A-Za-z]/)) continue
        if (!begun && s ~ /^[A-Z]+\(/) called = 1          # a macro, to its last ")"
        if (called) { called = s !~ /\)$/; continue }
        if (!begun) { all = ""; n = 0; begun = 1; starts = i }
        all = all " " s
        n += gsub(/[{]/, "{", s) - gsub(/[}]/, "}", s)
        if (n > 0 || all !~ /[;}] *$/) continue
        begun = 0; sub(/^ +/, "", all)
        if (all ~ /^extern /) { sub(/^extern/, "static", text[f, starts]); continue }
        if (source && all ~ /^const [^(]*=/) { hidden[f, starts] = 1; continue }
        body = all ~ /\)[ ]*[{]/ && all !~ /^[^{]*=/        # a function's
        if (body || all ~ /^[^=]*\)[ ]*;$/) {
            opens = all; sub(/ *\(.*/, "", opens)
            if (all !~ /^(typedef|static|ALWAYS_INLINE|NEVER_INLINE) / && opens ~ /[^ ][ *]+[a-z_0-9]+$/ && !(last_word(opens) in shown)) hidden[f, starts] = 1
            if (source && all !~ /^(typedef|static|ALWAYS_INLINE|NEVER_INLINE) /) continue
            if (body) sub(/\).*/, ")", all)
        }
        declares(f, all)
    }
}

function write(f, source,    i, n, part) {
    print "\n// --- " f " " substr("--------------------------------------------------------------------", length(f))
    for (i = 1; i <= length_of[f]; i++) print ((f, i) in hidden ? "static " : "") text[f, i]
    n = split(source ? macros[f] : "", part)
    for (i = 1; i <= n; i++) print "#undef " part[i]
}

# The licence, and what must hold wherever this is compiled: the digits of a step
# are the same on every machine only if each operation is rounded once, to 64 bits.
function open_file(    i, on) {
    print "// tumble.c - tumble " version ", whole, in one file.  Compile it with tumble.h beside\n// it, and link with the mathematics of the C library:\n//\n//     cc -O2 -c tumble.c\n//"
    for (i = 1; i <= length_of["LICENSE"]; i++) {
        if (text["LICENSE", i] ~ /^MIT/) on = 1
        if (on) print "//" (text["LICENSE", i] != "" ? " " : "") text["LICENSE", i]
    }
    print "\n#if defined(__clang__)\n#pragma STDC FP_CONTRACT OFF"
    print "#elif defined(__GNUC__) && defined(__FP_FAST_FMA) && !defined(__STRICT_ANSI__)\n#pragma GCC optimize (\"fp-contract=off\")"
    print "#elif defined(_MSC_VER)\n#pragma fp_contract (off)\n#pragma warning (disable: 4505)\n#endif"
    print "#if defined(__GNUC__)\n#pragma GCC diagnostic ignored \"-Wunused-function\"\n#endif"
    print "#if defined(_M_FP_FAST)\n#error \"compile without /fp:fast: it rounds otherwise\"\n#endif"
    print "#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0\n#error \"for 32 bits of an x86: -msse2 -mfpmath=sse, or a result is rounded twice\"\n#endif"
    print ""
    for (i = 1; i <= length_of["mended.h"]; i++) print text["mended.h", i]
    print "\n#include \"tumble.h\""
}

function want(m,    part, n, i) {
    n = split(uses[m], part)
    for (i = 1; i <= n; i++) if (!(part[i] in wanted)) { wanted[part[i]] = 1; want(part[i]) }
}

END {
    if (failed) exit 1
    count = split(order, line_of)
    for (m in wanted) start[m] = 1
    for (m in start) want(m)
    for (i = 1; i <= length_of["tumble.h"]; i++) {
        if (text["tumble.h", i] ~ /^#define TUMBLE_VERSION "/) { split(text["tumble.h", i], quoted, "\""); version = quoted[2] }
        s = bare(text["tumble.h", i])
        if (match(s, /^[a-z].*tumble_[a-z0-9_]+\(/)) { s = substr(s, 1, RLENGTH - 1); shown[last_word(s)] = 1 }
    }
    for (i = 1; i <= count; i++) {
        m = line_of[i]
        if (m == "tumble") m = ""
        if (!(m in wanted)) continue
        if ((m ".h") in length_of) read(m ".h", 0)
        if ((m ".c") in length_of) read(m ".c", 1)
    }
    open_file()
    for (pass = 0; pass < 2; pass++)
        for (i = 1; i <= count; i++) {
            m = line_of[i]; f = m (pass ? ".c" : ".h")
            if (m != "tumble" && (m in wanted) && (f in length_of)) write(f, pass)
        }
}
