# numbers.awk - numbers in a sentence, looked up in the tables of figures/.
#
# Within a line {{02-rope 3; 64; cost}} stands for a number: of
# figures/02/02-rope.csv, block 3 (of those that two blank lines part, from 0; or
# a table's name; without one, 0), the row that opens with 64, the column cost.
# {{02-rope #; words}} is the number after these words in the file's comments,
# and {{02-rope #; words .. more words}} that of the comment with both, in turn.
# A last field says how: 3 (digits, else 2), "%", "3 %", "count" (a whole number,
# all its digits), or "3 mm", with the unit behind it: a table may say 0.12 m in
# one row and 98 mm in the next.  {{a / b; 2}}
# is the quotient of two such cells.  Fields may hold no ";".
# {{claim: a < b}} prints nothing and fails where it is false: a and b are such
# cells, quotients or bare numbers, with < or > between them.
# A program that reads this file has a function fail(file, line, sentence), and sets file.

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
# The file that "02-rope" is short for.  "little" is what the little program's
# stages print.
function csv_of(short) {
    short = short ~ /^[0-9][0-9][a-z]?-/ ? substr(short, 1, index(short, "-") - 1) "/" short : short ~ /\// ? short : "tables/" short
    return short == "tables/little" ? "chapters/little/measured.csv" : "figures/" short ".csv"
}
# The number that "02-rope 3; 64; cost" names; "" and a complaint if none is.
function number_of(address,    part, parts, where, csv, block, i, k, at, entry, cell, head, n, comma_or_blank) {
    parts = split(address, part, /; */); split(part[1], where, " ")
    csv = csv_of(where[1]); block = where[2] == "" ? 0 : where[2]
    if (!(csv in was_read)) read_rows(csv)
    if (!was_read[csv]) return none("there is no file " csv)
    if (parts != (block == "#" ? 2 : 3))
        return none("{{" address "}} has " parts " fields: a file, a " (block == "#" ? "few words of its comments" : "row and a column") ", and none of them may hold a ;")
    if (block == "#") return number_after(notes[csv], part[2], csv)
    comma_or_blank = comma[csv, block] ? "," : " "
    for (i = 1; i <= rows_of[csv, block]; i++) {
        entry = row_at[csv, block, i]; gsub(/"/, "", entry)
        if (index(entry comma_or_blank, part[2] comma_or_blank) == 1) { at = i; k++ }
    }
    if (k != 1) return none("in " csv ", " block ", " k + 0 " rows open with " part[2])
    split_row(row_at[csv, block, at], comma[csv, block], cell); k = part[3] ~ /^[0-9]+$/ ? part[3] : 0
    n = split_row(heads[csv, block], comma[csv, block], head)
    for (i = 1; i <= n && !k; i++) if (head[i] == part[3]) k = i
    if (!(k in cell) || !is_number(cell[k])) return none("in " csv ", " block ", no number stands under " part[3])
    scale = scale_of(cell[k])
    return cell[k] + 0
}
# How many metres or seconds are one of the cell's unit; 0: it names neither.
function scale_of(cell) {
    if (!sub(/^[^ ]+ /, "", cell)) return 0
    return cell == "m" || cell == "s" ? 1 : cell == "cm" ? 1e-2 : cell == "mm" || cell == "ms" ? 1e-3 : cell == "us" || cell == "\302\265m" || cell == "\302\265s" ? 1e-6 : cell == "ns" ? 1e-9 : 0
}
# A number, perhaps with a unit behind a blank: 12.2.0, 3x or nan are none.
function is_number(cell) { return cell ~ /^-?([0-9]+\.?[0-9]*|\.[0-9]+)(e[-+]?[0-9]+)?( [^0-9].*)?$/ }
# The number after the words "a .. b": of the one comment that has a and then b.
function number_after(text, words, csv,    line, n, i, k, rest, side, found) {
    if (words == "") return none("no words say which number of " csv)
    split(words, side, / \.\. /); n = split(text, line, "\n")
    for (i = 1; i <= n; i++) {
        rest = behind(line[i], side[1]); if (side[2] != "") rest = behind(rest, side[2])
        while (rest != "") {
            k++; found = rest
            rest = behind(rest, side[2] != "" ? side[2] : side[1])
        }
    }
    if (k > 1) return none("the comments of " csv " have " words " " k " times")
    if (!k || !match(found, /[0-9][0-9.]*(e[-+]?[0-9]+)?/)) return none("no comment of " csv " has a number after " words)
    rest = substr(found, RSTART, RLENGTH); sub(/\.$/, "", rest)
    if (!is_number(rest)) return none("what follows " words " in the comments of " csv " is no number: " rest)
    return (substr(found, 1, RSTART - 1) ~ /(^| )-$/ ? -1 : 1) * rest
}
function behind(text, words,    at) { at = index(text, words); return at ? substr(text, at + length(words)) : "" }
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
# A cell, a quotient of two, or a bare number; "" if there is none.
function value_of(inside,    cell, x, y, mine) {
    if (is_number(inside)) { scale = 0; return inside + 0 }
    split(inside " / ", cell, / \/ /); scale = 0; x = number_of(cell[1])
    if (x == "" || cell[2] == "") return x
    mine = scale; scale = 0; y = number_of(cell[2])
    if (y == "") return ""
    if (y == 0) return none("{{" inside "}} divides by zero")
    x = mine > 0 && scale > 0 ? x * mine / (y * scale) : x / y
    scale = 0
    return x
}
# What stands for {{inside}}.
function say_number(inside,    form, side, x, y, less, unit) {
    if (sub(/^claim: */, "", inside)) {
        less = index(inside, " < ")
        if (split(inside, side, / [<>] /) != 2) return none("a claim is a < b or a > b: " inside)
        x = value_of(side[1]); y = value_of(side[2])
        if (x != "" && y != "" && (less ? x >= y : x <= y)) fail(file, FNR, "this is not so: " inside " (" x " and " y ")")
        return ""
    }
    if (match(inside, /; *[0-9]+ (m|cm|mm|s|ms|us|ns)$/)) {
        unit = substr(inside, RSTART + 1); inside = substr(inside, 1, RSTART - 1); form = unit + 0; sub(/^[ 0-9]*/, "", unit)
        x = value_of(inside)
        if (x == "") return ""
        if (!scale) return none("{{" inside "}} has no unit to become " unit)
        return digits(x * scale / scale_of("1 " unit), form ? form : 2) " " unit
    }
    if (sub(/; *count$/, "", inside)) {
        x = value_of(inside)
        if (x != "" && x != int(x)) return none("{{" inside "}} is no count: " x)
        return x == "" ? "" : digits(x, length(x))
    }
    if (match(inside, /; *([0-9]+ *%?|%)$/)) { form = substr(inside, RSTART + 1); inside = substr(inside, 1, RSTART - 1) }
    x = value_of(inside)
    if (x == "") return ""
    return digits((form ~ /%/ ? 100 : 1) * x, form + 0 ? form + 0 : 2) (form ~ /%/ ? " %" : "")
}
function with_numbers(line,    out, from, past) {
    while (match(line, /\{\{[^}]*\}\}/)) {
        from = RSTART; past = RSTART + RLENGTH
        out = out substr(line, 1, from - 1) say_number(substr(line, from + 2, past - from - 4))
        line = substr(line, past)
    }
    return out line
}
