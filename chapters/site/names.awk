# names.awk - what names.lua looks for, to which any page may lead: of each woven page its
# title, its figures, and what the pieces of code in it define, but for their lines.

function say(kind, what) { print page, kind, what }
BEGIN { FS = OFS = "\t" }
FNR == 1 { page = FILENAME; gsub(/.*\/|\.md$/, "", page) }
/^# / { say("title", substr($0, 3)) }
/^!\[.*\]\(\.\.\/\.\.\/figures\/.*\.[a-z]*\)$/ { gsub(/.*\/|\.[a-z]*\)$/, ""); say("figure", $0) }
/^\[[^ ,]*, lines? [0-9 to]*: .*\]\(/ {
    sub(/\]\(.*/, "")
    file = substr($0, 2, index($0, ",") - 2)
    sub(/^[^:]*: /, "")
    say("code", file "\t" $0)
}
