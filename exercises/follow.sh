# follow.sh - how far the reader is, and what to read next.  Part of run.sh.

# The states of an exercise: passed, begun, not begun.
state() {
    if [ -f "$exercises/${1%%/*}-${1#*/}/mine.passed" ]; then echo passed
    elif [ -f "$exercises/${1%%/*}-${1#*/}/mine.c" ]; then echo begun
    else echo not begun; fi
}

# Every exercise with its state, a line each: NN/name state.
states() { for each in $(names); do echo "$each $(state "$each")"; done; }

title_of() { sed -n '1s/^# [^:]*: //p' "$exercises/${1%%/*}-${1#*/}/README.md"; }

# The chapters' files, in order; chapter NN, its file; file, its title.
chapter_files() { for file in "$chapters"/[0-9][0-9]-*.md; do [ -f "$file" ] && echo "$file"; done; }
chapter_file() { chapter_files | grep "/$1-[^/]*\$"; }
chapter_title() { sed -n '1s/^# [0-9]*\. //p' "$1"; }

# next_of CHAPTER STATES: what to read or to write now, if it is that chapter
# where the reader stands.
next_of() {
    file=$(chapter_file "$1")
    begun=$(echo "$2" | sed -n "s|^\($1/[^ ]*\) begun\$|\1|p" | head -n 1)
    open=$(echo "$2" | sed -n "s|^\($1/[^ ]*\) not begun\$|\1|p" | head -n 1)
    after=$(chapter_files | sed -n "\|/$1-|{ n; p; }")
    if [ -n "$begun" ]; then
        echo "Next: go on with  make exercise $begun  ($(title_of "$begun"))"
    elif [ -n "$open" ] && echo "$2" | grep -q "^$1/.* passed"; then
        echo "Next: make exercise $open  ($(title_of "$open"))"
    elif [ -n "$open" ]; then
        echo "Next: read $file, and then  make exercise $open  ($(title_of "$open"))"
    elif [ -n "$after" ]; then
        number=${after##*/} number=${number%%-*}
        echo "Next: chapter $number, $(chapter_title "$after"): read $after, and  make $number"
    else
        echo "Next: a scene of your own.  This was the last chapter."
    fi
}

# The end of `make NN`: the chapter's exercises, and what to do now.
chapter() {
    file=$(chapter_file "$1")
    [ -n "$file" ] || { echo "There is no chapter $1." >&2; return 1; }
    all=$(states)
    echo
    echo "Chapter $1, $(chapter_title "$file"): $file"
    echo "$all" | sed -n "s|^\($1/[^ ]*\) |\1 |p" | while read -r each how; do
        printf '  %-10s %-14s %s\n' "$how" "$each" "$(title_of "$each")"
    done
    echo "$all" | grep -q "^$1/" || echo "  It has no exercises."
    next_of "$1" "$all"
}
