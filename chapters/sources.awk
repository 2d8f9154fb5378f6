# sources.awk - does chapter 23 list each work that a chapter names as a source,
# with that chapter's number?   awk -f sources.awk chapters/23-*.md chapters/*.md
#
# A work is known by the first letters of its title, which stands between *.

function fail(sentence) { print FILENAME ":" FNR ": " sentence; failures++ }

function key(title) {
    title = tolower(title)
    gsub(/[^a-z0-9 ]/, "", title)
    return substr(title, 1, 24)
}

FNR == 1 { inside = 0; files++; match(FILENAME, /[0-9][0-9][a-z]?-/); number = substr(FILENAME, RSTART, RLENGTH - 1) }
/^## / { inside = /^## Sources/ }
!inside { next }
{
    line = $0
    while (match(line, /\*[^*]+\*/)) {
        title = substr(line, RSTART + 1, RLENGTH - 2); line = substr(line, RSTART + RLENGTH)
        if (files == 1) {
            # The brackets behind a title name its chapters.
            named = match(line, /\([^()]*([0-9][0-9][a-z]?|all)\)/) ? substr(line, RSTART, RLENGTH) : ""
            at[key(title)] = at[key(title)] named
        } else if (number == 23 || length(title) < 9) continue
        else if (!(key(title) in at)) fail("chapter 23 does not list " title)
        else if (at[key(title)] !~ "all|[( ]" number "[,)]") fail("chapter 23 does not say that chapter " number " names " title)
    }
}
END { exit failures > 0 }
