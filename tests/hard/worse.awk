# worse.awk BEFORE AFTER - is a number of the second table worse than in the
# first?  Says which, and ends with 1 if there is one.
#
# Worse is a number that held and falls short now, one that fell short by less,
# one of which more trials are beyond the target, and one that is gone.  Bits do
# not vary, so a hundredth is allowed to rounded digits only; what is measured
# with a clock (in s, or in x: times as long) may be a quarter longer.

function number_of(text) { return substr(text, 3, index(text, ":") - 3) }
function refuse(key, why) { print "  worse: " key ": " why; bad = 1 }

# "# 101: what is measured: 0.02 m, target 0.01, FALLS SHORT"
match($0, /^# [0-9]+: .*: [^ ]+ [^ ]*, target [^ ]+, (holds|FALLS SHORT)$/) {
    short = /FALLS SHORT$/
    text = $0; sub(/, target [^ ]+, [A-Za-z ]+$/, "", text)
    n = split(text, word, " "); unit = word[n]; value = word[n - 1]
    if (text ~ / $/) { unit = ""; value = word[n] }
    key = substr(text, 3); sub(/: [^ ]+ [^ ]*$/, "", key)
    if (FILENAME == ARGV[1]) {
        was[key] = value; fell[key] = short; next
    }
    seen[key] = 1
    if (!(key in was)) next
    slack = unit == "s" || unit == "x" ? 1.25 : 1.01
    infinite = value ~ /inf|nan/
    if (short && !fell[key]) refuse(key, value " " unit " falls short, " was[key] " held")
    else if (short && infinite && was[key] !~ /inf|nan/) refuse(key, value " " unit ", was " was[key])
    else if (short && !infinite && was[key] !~ /inf|nan/ && value + 0 > slack * was[key])
        refuse(key, value " " unit ", was " was[key])
    if (!short && fell[key]) print "  holds now: " key ": " value " " unit ", was " was[key]
    next
}
# "# 101: what is measured: 3 of 48 beyond the target, worst at ..."
match($0, /: [0-9]+ of [0-9]+ beyond the target/) {
    key = substr($0, 3, RSTART - 3)
    split(substr($0, RSTART + 2), word, " ")
    if (FILENAME == ARGV[1]) { beyond[key] = word[1]; next }
    if (key in beyond && word[1] > beyond[key] + 0)
        refuse(key, word[1] " of " word[3] " trials beyond the target, was " beyond[key])
}
END {
    for (key in was) if (!(key in seen)) refuse(key, "is gone")
    exit bad
}
