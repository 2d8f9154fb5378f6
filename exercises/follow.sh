# follow.sh - how far the reader is, and what to read next.  Part of run.sh.
#
# What passed stands in exercises/progress.txt, a line each, with the day:
#   10/when passed 2026-11-21
# The file is the reader's to edit.  What follows a # is a remark.

progress=${PROGRESS:-$exercises/progress.txt}

# What passed, a line each: NN/name day; and on stderr a sentence for each line
# that cannot be read.  Such lines are left as they are.
passed() {
    [ -f "$progress" ] || return 0
    awk -v known="$(names | tr '\n' ' ')" -v file="$progress" '
    BEGIN { known = " " known; digit = "[0-9]"; day = digit digit digit digit "-" digit digit "-" digit digit }
    { sub(/\r$/, ""); sub(/#.*/, "") }
    NF == 0 { next }
    NF != 3 || $2 != "passed" || $3 !~ "^" day "$" {
        print file ", line " NR ": this cannot be read, and is left as it is; a line is like  10/when passed 2026-11-21" > "/dev/stderr"
        next
    }
    !index(known, " " $1 " ") { print file ", line " NR ": there is no exercise " $1 > "/dev/stderr"; next }
    !seen[$1]++ { print $1, $3 }' "$progress"
}

# Writes that an exercise passed today, unless it did before.
write_passed() {
    passed 2> /dev/null | grep -q "^$1 " && return
    {
        if [ ! -s "$progress" ]; then
            echo "# What passed, and when.  This file is yours: edit it as you like."
        elif [ -n "$(tail -c 1 "$progress")" ]; then
            echo        # the last line was not ended
        fi
        echo "$1 passed $(date +%Y-%m-%d)"
    } 2> /dev/null >> "$progress" ||
        echo "$progress cannot be written: that $1 passed is not kept." >&2
}

# Takes it out again; every other line stays.
forget_passed() {
    passed 2> /dev/null | grep -q "^$1 " || return 0
    grep -v "^[[:space:]]*$1[[:space:]]\{1,\}passed" "$progress" > "$progress.part"
    mv "$progress.part" "$progress"
}

# Every exercise with its state, a line each: NN/name passed day, NN/name begun
# or NN/name not begun.
states() {
    {
        for each in $(names); do
            if [ -f "$exercises/${each%%/*}-${each#*/}/mine.c" ]; then echo "$each begun"; else echo "$each not begun"; fi
        done
        passed
    } | awk '
    $2 ~ /begun$|^not$/ { name[++n] = $1; how[$1] = substr($0, length($1) + 2); next }
    { how[$1] = "passed " $2 }
    END { for (k = 1; k <= n; k++) print name[k], how[name[k]] }'
}

title_of() { sed -n '1s/^# [^:]*: //p' "$exercises/${1%%/*}-${1#*/}/README.md"; }

# The chapters' files, in order; chapter NN, its file; file, its title.
chapter_files() { for file in "$chapters"/[0-9][0-9]*-*.md; do [ -f "$file" ] && echo "$file"; done | LC_ALL=C sort; }
chapter_file() { chapter_files | grep "/$1-[^/]*\$"; }
no_chapter() {
    echo "There is no chapter $1: there are $(chapter_files | sed 's|.*/||; s/-.*//' | sed -n '1p; $p' | paste -s -d - | sed 's/-/ to /')." >&2
    return 1
}
chapter_title() { sed -n '1s/^# [0-9]*[a-z]\{0,1\}\. //p' "$1"; }

# next_of CHAPTER STATES: what to read or to write now, if it is that chapter
# where the reader stands.
next_of() {
    begun=$(echo "$2" | sed -n "s|^\($1/[^ ]*\) begun\$|\1|p" | head -n 1)
    open=$(echo "$2" | sed -n "s|^\($1/[^ ]*\) not begun\$|\1|p" | head -n 1)
    after=$(chapter_files | sed -n "\|/$1-|{ n; p; }")
    if [ -n "$begun" ]; then
        echo "Next: go on with  make exercise $begun  ($(title_of "$begun"))"
    elif [ -n "$open" ] && echo "$2" | grep -q "^$1/.* passed"; then
        echo "Next: make exercise $open  ($(title_of "$open"))"
    elif [ -n "$open" ]; then
        echo "Next: read chapter $1 in book.md, and then  make exercise $open  ($(title_of "$open"))"
    elif [ -n "$after" ]; then
        number=${after##*/} number=${number%%-*}
        echo "Next: chapter $number, $(chapter_title "$after"): read it in book.md, and  make $number"
    else
        echo "Next: a scene of your own.  This was the last chapter."
    fi
}

# The end of `make NN`: the chapter's exercises, and what to do now.
chapter() {
    file=$(chapter_file "$1")
    [ -n "$file" ] || { no_chapter "$1"; return; }
    all=$(states)
    echo
    echo "Chapter $1, $(chapter_title "$file"): $file"
    echo "$all" | sed -n "s|^\($1/[^ ]*\) |\1 |p" | while read -r each how; do
        printf '  %-17s %-14s %s\n' "$how" "$each" "$(title_of "$each")"
    done
    echo "$all" | grep -q "^$1/" || echo "  It has no exercises."
    next_of "$1" "$all"
}

# bar TITLE STATES: twenty signs, # for what passed (one at the least) and - for
# what is begun.
bar() {
    echo "$2" | awk -v title="$1" '
    NF { all++ }
    $2 == "passed" { passed++ }
    $2 == "begun"  { begun++ }
    END {
        for (i = 1; i <= 20; i++)
            line = line (i * all <= 20 * passed || passed && i == 1 ? "#" : i * all <= 20 * (passed + begun) ? "-" : ".")
        if (all) printf "  %-40s %s %2d of %d\n", title, line, passed, all
        else printf "  %-40s no exercises\n", title
    }'
}

# A bar for each chapter, one for all, and what to do now.
bars() {
    all=$(states)
    here='' last=''
    for file in $(chapter_files); do
        number=${file##*/} number=${number%%-*}
        bar "$number $(chapter_title "$file")" "$(echo "$all" | grep "^$number/")"
        last=$number
        [ -n "$here" ] || ! echo "$all" | grep "^$number/" | grep -qv ' passed ' || here=$number
    done
    bar "all" "$all"
    next_of "${here:-$last}" "$all"
    [ ! -f "$progress" ] || echo "This is kept in $progress, which is yours to edit."
}
