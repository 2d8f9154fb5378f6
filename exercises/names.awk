# names.awk - a line for each exercise: its chapter, where the chapters tell of it,
# and NN/name:   awk -f names.awk chapters/*.md - < the files called `exercise`
# A place is a line of its chapter, or of one of the chapters NNb and NNc behind
# it, a million lines on for each; 99999999 if none tells of it.

FILENAME != "-" && FNR == 1 {
    number = FILENAME; sub(/.*\//, "", number); sub(/-.*/, "", number)
    of[++files] = number
}
FILENAME != "-" {
    while (match($0, /make exercise [^` ]*`/)) {
        name = substr($0, RSTART + 14, RLENGTH - 15)
        if (!((files, name) in place)) place[files, name] = FNR
        $0 = substr($0, RSTART + RLENGTH)
    }
    next
}
{
    sub(/\/exercise$/, ""); sub(/.*\//, "")
    chapter = $0; sub(/-.*/, "", chapter)
    name = $0; sub(/^[^-]*-/, "", name); name = chapter "/" name
    at = 0; found = 99999999
    for (k = 1; k <= files; k++) {
        if (index(of[k], chapter) != 1) continue
        if ((k, name) in place) { found = at + place[k, name]; break }
        at += 1000000
    }
    print chapter, found, name
}
