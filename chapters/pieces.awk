# pieces.awk - functions for weave.awk: the little program's pieces.
#
# A piece is a region of chapters/little/ with the stages that it is in:
# "//> little_name FROM UNTIL ...".  Above its code the book says in which stage
# it comes, and what it replaces, or after what it goes: always by what a reader
# has typed so far.  stages.txt, beside the pieces, names all stages in order.

function read_stages(list,    line, part) {
    while ((getline line < list) > 0)
        if (split(line, part, / *\| */) > 1 && part[1] ~ /^[0-9][0-9][a-z]$/) id_of[++stages] = part[1]
    close(list)
}
# The number of a stage, or of the last one before it: 09z is the end of 09.
# What is asked again and again is kept: was_stage, was_in and their like.
function stage_of(id,    i) {
    if (id in was_stage) return was_stage[id]
    for (i = stages; i > 0 && id_of[i] "" > id ""; i--) ;
    return was_stage[id] = i
}
# The n-th region is a piece, whose marker is in fields 3 to last.
function note_piece(n, fields,    i) {
    if (!stages) read_stages("chapters/little/stages.txt")
    if (id_of[stage_of($3)] != $3) fail(FILENAME, FNR, $3 " is no stage of stages.txt")
    number_in[$2] = n; piece[++pieces] = $2
    comes[$2] = $3; pairs[$2] = fields - 2
    for (i = 3; i <= fields; i++) at_stage[$2, i - 2] = stage_of($i)
}
function is_in(name, stage,    i, is) {
    if ((name, stage) in was_in) return was_in[name, stage]
    for (i = 1; i <= pairs[name]; i += 2)
        if (stage >= at_stage[name, i] && (i == pairs[name] || stage <= at_stage[name, i + 1])) is = 1
    return was_in[name, stage] = is + 0
}
# The names that a piece defines, as "a, b".
function defined(name) {
    if (!(name in defines)) defines[name] = names_in(home[name], from[name] + 1, to[name] - 1)
    return defines[name]
}
# The first line of code of a piece, or the last: one that is not blank, and no
# comment.
function code_line(name, back,    i, line) {
    if ((name, back) in was_line) return was_line[name, back]
    for (i = back ? to[name] - 1 : from[name] + 1; i > from[name] && i < to[name]; i += back ? -1 : 1) {
        line = text[home[name], i]
        if (line !~ /^[ \t]*$/ && line !~ /^\/\//) break
    }
    return was_line[name, back] = line
}
# Does the piece begin, or end, within a function or a type?
function is_inside(name) { return code_line(name, 0) ~ /^([ \t]|})/ }
function is_open(name) { return code_line(name, 1) ~ /^([ \t]|\{$|typedef struct \{$)/ }
function quoted(line) {
    sub(/^[ \t]+/, "", line); sub(/[ \t]*\/\/.*/, "", line)
    return "`" line "`"
}
# The piece that opens what this one lies in, at that stage.
function opener(name, stage,    k) {
    for (k = number_in[name] - 1; k > 0; k--)
        if (is_in(region[k], stage) && is_open(region[k]) && (!is_inside(region[k]) || defined(region[k]) != "")) return region[k]
    return ""
}
# What a piece is the end of: the type that its first line closes, or what it defines.
function closed(name,    line) {
    line = code_line(name, 0)
    if (line !~ /^} [a-z0-9_]+;/) return defined(name)
    gsub(/^} |;.*/, "", line)
    return line
}
# What that opens: its last function, or the type that is closed further down.
function opened(name, stage,    k, names) {
    names = defined(name)
    for (k = number_in[name]; names == "" && k <= regions; k++) if (is_in(region[k], stage)) names = closed(region[k])
    sub(/.*, /, "", names)
    return "`" names "`"
}
# What a reader sees at the end of a piece: the line, or what is defined there.
function last_of(name, stage,    names, line) {
    line = code_line(name, 1)
    if (!is_in(name, stage)) stage--
    names = defined(name); sub(/.*, /, "", names)
    if (is_open(name) || line !~ /^}/ && (names == "" || !index(line, names "("))) return quoted(line)
    return names == "" && is_inside(name) ? opened(opener(name, stage), stage) : "`" names "`"
}
# Has the reader of a stage this piece by now?
function is_typed(name, stage) {
    if ((name, stage) in typed || returns(name, stage)) return 1
    return stage_of(comes[name]) != stage && is_in(name, stage - 1) && !((name, stage) in gone)
}
# Does it come back, after stages without it?
function returns(name, stage) { return stage_of(comes[name]) < stage && is_in(name, stage) && !is_in(name, stage - 1) }
# What stays of the stage before, where most of it goes.
function kept(stage,    k, name, names, out) {
    for (k = 1; k <= pieces; k++) {
        name = piece[k]
        if (!is_in(name, stage - 1) || !is_in(name, stage)) continue
        names = everything(name)
        if (names != "") out = out (out == "" ? "" : ", ") names
    }
    return "the lines with `#include`, " out
}
# What does, and where to: "`a`, `b` of stage 12c, after `c`; `d;` of stage 11c, in `f`,
# after `e;`".
function taken_back(stage,    k, i, name, names, out, of, ending, next_to, start) {
    for (k = 1; k <= pieces; k++) {
        name = piece[k]
        if (!returns(name, stage)) { if (is_in(name, stage) && !(comes_in(name, stage) && is_inside(name))) { next_to = 0; start = "" }; continue }
        if (start == "" && !is_inside(name)) start = name
        names = everything(name)
        if (is_inside(name) && !returns(opener(name, stage), stage)) { names = line_span(name); next_to = 0; start = name }
        else if (names == "" || index(", " out ",", ", " names ",")) continue
        for (i = stage - 1; !is_in(name, i); i--) ;
        if (next_to && of == i) { out = out ", " names; continue }
        if (out != "") out = out ending ";"
        if (next_to) start = name
        of = i
        ending = " of stage " id_of[of] (is_inside(start) ? ", in " opened(opener(start, stage), stage) : "") place_of(start, stage)
        out = out " " names
        next_to = !is_inside(start)
        if (!next_to) start = ""
    }
    return out == "" ? "" : substr(out, 2) ending
}
# The lines of a piece, for a reader.
function line_span(name) {
    if (code_line(name, 0) == code_line(name, 1)) return quoted(code_line(name, 0))
    return "the lines from " quoted(code_line(name, 0)) " to " quoted(code_line(name, 1))
}
# The stage before this one in which a reader has that piece: the last one, or that
# from which the function around it is taken back.  0 if there is none.
function last_seen(name, stage,    i, around) {
    if (is_in(name, stage - 1)) return stage - 1
    if (!is_inside(name)) return 0
    for (i = stage - 1; i > 0 && !is_in(name, i); i--) ;
    if (!i) return 0
    around = opener(name, i)
    return around != "" && returns(around, stage) && !is_in(around, i + 1) ? i : 0
}
function comes_in(name, stage) { return stage_of(comes[name]) == stage }
# Which piece of a stage takes the place of one that ends: the one that defines the
# same, or else the next one in its file, if nothing that stays is between them.
function heir(name, stage) {
    if (!((name, stage) in was_heir)) was_heir[name, stage] = find_heir(name, stage)
    return was_heir[name, stage]
}
function find_heir(name, stage,    k, way, list, i, n) {
    n = split(defined(name), list, ", ")
    if (!n && is_inside(name)) {
        k = opener(name, last_seen(name, stage))
        if (k != "" && is_in(k, stage - 1) && !is_in(k, stage)) return heir(k, stage)
    }
    for (k = 1; k <= pieces; k++)
        if (comes_in(piece[k], stage))
            for (i = 1; i <= n; i++) if (index(", " defined(piece[k]) ",", ", " list[i] ",")) return piece[k]
    for (way = 1; way >= -1; way -= 2)
        for (k = number_in[name] + way; k > 0 && k <= regions && home[region[k]] == home[name]; k += way) {
            if (comes_in(region[k], stage)) return region[k]
            if (is_in(region[k], stage)) break
        }
    return ""
}
# All that a piece holds at the margin, as "`a`, `int b;`".
function everything(name,    i, line, out) {
    for (i = from[name] + 1; i < to[name]; i++) {
        line = text[home[name], i]
        if (line ~ /^} [a-z0-9_]+;/) { gsub(/^} |;.*/, "", line); line = "`" line "`" }
        else if (line ~ /^[a-z][a-z0-9_ ]*[ *][a-z0-9_]+\(/ && line !~ /^typedef/) { sub(/\(.*/, "", line); sub(/.*[ *]/, "", line); line = "`" line "`" }
        else if (line ~ /^[a-z].*;/) line = quoted(line)
        else continue
        out = out (out == "" ? "" : ", ") line
    }
    return out
}
# What ends at that stage and has such an heir, as a list for a reader.  `is_far`
# is set if that lay elsewhere.
function ended(stage, heir_is,    k, n, list, name, out, names) {
    n = split(ending_at(stage), list, " ")
    for (k = 1; k <= n; k++) {
        name = list[k]
        if (heir(name, stage) != heir_is) continue
        gone[name, stage]
        is_far = is_far || home[name] != home[heir_is] || is_between(number_in[name], number_in[heir_is], stage)
        names = everything(name)
        if (!is_inside(name) && names == "") names = opened(name, stage - 1)
        if (names != "") ;
        else if (!is_in(opener(name, last_seen(name, stage)), stage)) continue
        else names = line_span(name)
        if (heir_is == "" && is_inside(name) && everything(name) == "") names = names " in " opened(opener(name, stage), stage)
        if (!index(", " out ",", ", " names ",")) out = out (out == "" ? "" : ", ") names
    }
    return out
}
# The pieces that a reader has before that stage, and not in it.
function ending_at(stage,    k, name) {
    if (!(stage in was_ending)) {
        was_ending[stage] = ""
        for (k = 1; k <= pieces; k++) {
            name = piece[k]
            if (!is_in(name, stage) && last_seen(name, stage)) was_ending[stage] = was_ending[stage] " " name
        }
    }
    return was_ending[stage]
}
# Does something new come between two pieces, or has something that stays been there?
function is_between(k, until, stage) {
    for (k++; k < until; k++)
        if ((region[k], stage) in typed || ((region[k] in comes) && is_in(region[k], stage - 1) && is_in(region[k], stage) && !is_inside(region[k]))) return 1
    return 0
}
# "Stage 01b, in place of `euler_step`:" or "Stage 01b, after `gravity`:" of pieces
# that come together.
function where_it_goes(n, names,    k, stage, says, old, more, list) {
    stage = stage_of(comes[names[1]])
    says = "*Stage " comes[names[1]] "*"
    if (!(stage in begun)) {
        begun[stage]
        old = ended(stage, ""); more = taken_back(stage)
        if (more != "") says = says " (take back " more ")"
        if (split(old, list, ", ") > 40) { restarted[stage]; old = "" ; says = says " (keep " kept(stage) "; delete all else)" }
        if (old != "") says = says " (delete " old ")"
    }
    old = ""; is_far = 0
    for (k = 1; k <= n; k++) {
        more = ended(stage, names[k])
        if (more != "" && !(stage in restarted)) old = old (old == "" ? "" : ", ") more
    }
    if (is_inside(names[1])) says = says ", in " opened(opener(names[1], stage), stage)
    says = says (old == "" || is_far ? place_of(names[1], stage) : "") (old == "" ? "" : ", in place of " old) ":"
    for (k = 1; k <= n; k++) typed[names[k], stage]
    return says
}
function place_of(name, stage,    k, last, next_one) {
    for (k = number_in[name] - 1; k > 0 && !last; k--) if (region[k] in comes && is_typed(region[k], stage)) last = region[k]
    for (k = number_in[name] + 1; k <= regions && !next_one; k++) if (region[k] in comes && is_typed(region[k], stage)) next_one = region[k]
    if (!next_one) return last ? ", at the end" : ", the first lines"
    if (last && is_inside(name) && code_line(last, 1) ~ /^[ \t]*(}|return;)$/) return code_line(next_one, 0) == "}" ? ", at its end" : ", before " quoted(code_line(next_one, 0))
    return last && code_line(last, 1) != "{" ? ", after " last_of(last, stage) : ", at the top"
}
# The next piece of that stage.
function beside(k, stage) {
    for (k++; k <= regions && (region[k] in comes); k++) if (is_in(region[k], stage)) return k
    return 0
}
# What no chapter shows, stage by stage: pieces that lie together share a block.
function write_pieces(    stage, k, n, names, last) {
    for (stage = 1; stage <= stages; stage++) {
        n = 0
        for (k = 1; k <= regions; k++) {
            if (!(region[k] in comes) || !comes_in(region[k], stage) || region[k] in used) continue
            if (!n && !(stage in headed)) { headed[stage]; print_later("## Stage " id_of[stage] "\n") }
            if (n && beside(last, stage) != k) { weave_all(n, names); print_later(""); n = 0 }
            names[++n] = region[k]; last = k
        }
        if (n) { weave_all(n, names); print_later("") }
    }
}
