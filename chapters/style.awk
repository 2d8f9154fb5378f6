# style.awk - is this plain English?   awk -f chapters/style.awk page.md ...
#
# Says file, line, fault and sentence for each sentence of more than 45 words,
# for "who" where no person stands before it, and for words that only this
# tree uses where the field has one (chapter 23 lists them).  Code, formulas,
# tables, paths and lists of sources are left out; captions are not.

BEGIN {
    MOST = 45

    # "who" may follow these, up to three words before it, and any name.
    n = split("reader readers student students teacher engineer engineers people person persons " \
      "those anyone everyone someone one author authors programmer user users player he she we you " \
      "expert experts beginner friend child children mathematician physicist", word, " ")
    for (i = 1; i <= n; i++) is_person[word[i]]

    # What looks like one of ours, and is the field's.
    FINE = " (sweep and prune|sweeps? (equal|out|along)|boil(ing|s) (water|over)|boiling point) "

    # Ours, and what to say instead.
    instead[" (whoever|whomever|whom) "] = "name the thing"
    instead[" (nobody|somebody|anybody|everybody) "] = "name the thing; of people: no one, someone"
    instead[" (anyhow|anew|afresh|in so far|insofar|lest|whence|thence|hither|thither|nought|nigh|wherein|thereof) "] = "plain English"
    instead[" told by "] = "shown by, known from"
    instead[" (dear|dearer|dearest|dearly) "] = "expensive, slow"
    instead[" (nail|nails|nailed) "] = "pinned; static"
    instead[" (boil|boils|boiled|boiling) "] = "jitter"
    instead[" certificates? "] = "bound, duality gap"
    instead[" dead band "] = "tolerance, slop"
    instead[" there and back "] = "iteration"
    instead[" (a|each|every|one|ten|more|of|many|several|small) sweeps? "] = "iteration"
    instead[" (mend|mends|mending) "] = "correct, correction; cure"
    instead[" (put to bed|restless|patience) "] = "sleep, time to sleep"
    instead[" (leash|leashes) "] = "tether"
}

function say(at, fault, sentence) {
    gsub(/  +/, " ", sentence)
    printf "%s:%d: %s: %s\n", FILENAME == file ? FILENAME : file, at, fault, sentence
    failures++
}

# The words of a sentence in small letters, a blank before and after each.
# What it quotes is not its own.
function plain_words(s) {
    gsub(/"[^"]*"/, " ", s)
    s = tolower(s)
    gsub(/[^a-z0-9'\200-\377-]+/, " ", s)
    return " " s " "
}

function check_who(sentence, at,    n, i, k, w, word, fine) {
    gsub(/"[^"]*"/, " ", sentence)
    n = split(sentence, word, /[^A-Za-z0-9'\200-\377-]+/)
    for (i = 1; i <= n; i++) if (tolower(word[i]) == "who") {
        fine = 0
        for (k = i - 1; k >= 1 && k >= i - 3; k--) {
            w = word[k]
            if (tolower(w) in is_person || k > 1 && w ~ /^[A-Z][a-z]+/) fine = 1
        }
        if (!fine) say(at, "who, for a thing or without a noun", sentence)
    }
}

function check(sentence, at,    words, bare, pattern) {
    words = gsub(/[^ \t]*[A-Za-z0-9\200-\377][^ \t]*/, "&", sentence)
    if (words > MOST) say(at, words " words", sentence)
    check_who(sentence, at)
    bare = plain_words(sentence)
    gsub(FINE, " ", bare)
    for (pattern in instead) if (match(bare, pattern))
        say(at, "\"" substr(bare, RSTART + 1, RLENGTH - 2) "\" (" instead[pattern] ")", sentence)
}

# A sentence ends with . ? or ! before a blank and a capital, a digit, or what
# opens one; not after Eq. and the like.
function end_paragraph(    rest, from, stop, at, head) {
    rest = text " "; from = 1; at = 1
    while (match(rest, /[.?!][)"*_]*[ ]+/)) {
        head = substr(rest, 1, RSTART); stop = RSTART + RLENGTH
        held = held head substr(rest, RSTART + 1, RLENGTH - 1)
        rest = substr(rest, stop)
        if (head ~ /(^|[ (*])(Eq|Eqs|Fig|Figs|cf|vs|e\.g|i\.e|approx|et al)\.$/) continue
        if (rest != "" && rest !~ /^[("*_[]*[A-Z0-9]/) continue
        check(held, line_of(from)); from = from + length(held); held = ""
    }
    if ((held rest) ~ /[A-Za-z]/) check(held rest, line_of(from))
    held = text = ""; pieces = 0
}
function line_of(place,    i) {
    for (i = pieces; i > 1 && begins[i] > place; i--) {}
    return line[i]
}
function add(s) {
    begins[++pieces] = length(text) + 1; line[pieces] = FNR
    text = text (text == "" ? "" : " ") s
}

FNR == 1 { end_paragraph(); file = FILENAME; fence = comment = sources = 0 }
/^ *```/ { end_paragraph(); fence = !fence; next }
fence { next }
/^#+ / { end_paragraph(); sources = /^#+ Sources/ }
sources { next }
/^(@@|%%|\|)/ || /^ *$/ || /^<!--/ { end_paragraph(); next }
/^( *[-*>]| *[0-9]+\.|#+|!\[|\[[^]]*\]\([^)]*\)$) */ { end_paragraph() }
{
    s = $0
    sub(/^( *[-*>] | *[0-9]+\. |#+ |!)/, "", s)
    gsub(/\{\{[^}]*\}\}/, "1", s)
    gsub(/\$`[^`]*`\$/, " XX", s)
    gsub(/`[^`]*`/, "XX", s)
    gsub(/\]\([^)]*\)/, "]", s)
    gsub(/<[^>]*>/, "", s)
    gsub(/make [a-z]*[- ]?[0-9][0-9][a-z]?\/[a-z0-9-]+|[0-9][0-9][a-z]?\/[a-z0-9-]+/, "XX", s)
    if (FILENAME ~ /hints$/) gsub(/[A-Za-z0-9]*_[A-Za-z0-9_]+|[a-z0-9]+\(/, "XX", s)
    if (FILENAME ~ /words/) sub(/^\*\*[^*]*\*\*/, "XX", s)
    add(s)
}
END { end_paragraph(); if (failures) exit 1 }
