# little.sh - the little program, stage by stage (make little):
#   sh little.sh cut STAGE FILE   cuts it
#   sh little.sh list             all stages, and how far the reader is
#   sh little.sh run STAGE        ours, and the reader's beside it
#   sh little.sh film STAGE       a moving picture of the reader's, or of ours
#   sh little.sh page STAGE       both beside each other: build/little/page.html
#   sh little.sh films            those of the book: figures/little/little-*.webp
#   sh little.sh films-of         checksums of what these are made of
#   sh little.sh table            the table of stages, as CSV: figures/tables/stages.csv
#   sh little.sh printed          what each prints, and its bits: chapters/little/printed.txt
#   sh little.sh measured         the same as CSV: chapters/little/measured.csv
# BUILD: where to build.  MINE: the reader's program, or my/little.c.

here=chapters/little
build=${BUILD:-build}/little
cc=${CC:-cc}
exact='-std=c11 -ffp-contract=off'
mine=$MINE
[ "$mine" ] || [ ! -f my/little.c ] || mine=my/little.c
export LC_ALL=C
mkdir -p "$build"

stages() { sed -n 's/^\([0-9][0-9][a-z]\) .*/\1/p' $here/stages.txt; }
title() { sed -n "s/^$1 *| *\([^|]*[^| ]\).*/\1/p" $here/stages.txt; }
cut_stage() { awk -v stage="$1" -f $here/cut.awk $here/*.c > "$2"; }

# The last stage of a chapter, 09; a stage is itself.
last_of() { case $1 in [0-9][0-9]) stages | grep "^$1" | tail -n 1 | grep . || echo "$1" ;; *) echo "$1" ;; esac; }

# Runs a program for a minute at most.
run() { timeout 60 "$1" $3 > "$2"; }

# The last of all stages whose claims hold for what is in that file.
reached() {
    last=none
    for s in $(stages); do
        awk -v stage=$s -f $here/claims.awk $here/stages.txt "$1" > "$build/said" && last=$s
    done
    echo $last
}

# A line for each stage: its name, lines, added, removed, its title, and what its
# claims are about, as measured.csv has it.
table() {
    before=/dev/null
    for s in $(stages); do
        cut_stage $s "$build/stage-$s.c" || exit 1
        sed 1,3d "$build/stage-$s.c" > "$build/bare-$s"
        diff "$before" "$build/bare-$s" > "$build/diff"
        echo "$s,$(grep -c '' "$build/stage-$s.c"),$(grep -c '^>' "$build/diff"),$(grep -c '^<' "$build/diff"),$(title $s),$(shows $s)"
        before=$build/bare-$s
    done
}
shows() {
    awk -v stage="$1" '
        FILENAME ~ /csv$/ { split($0, part, ","); is[part[1]] = part[2] " " part[3]; next }
        {
            n = split($0, part, / *\| */)
            if (part[1] != stage) next
            for (i = 3; i <= n; i++) {
                name = part[i]; sub(/ [<>]?=? -?[0-9.e-]+$/, "", name); gsub(/,/, "", name)
                if (!(name in told)) out = out (out == "" ? "" : "; ") name " " is[stage " " name]
                told[name]
            }
        }
        END { print out }' $here/measured.csv $here/stages.txt
}

# What a stage prints, under a line with its name, the checksum of its program and the
# hash of its bits.
print_stage() {
    $cc $exact -O1 -w -fno-builtin-printf -Dprintf=printf_noted "$build/stage-$1.c" figures/workshop/printed.c -o "$build/noted" -lm &&
        run "$build/noted" "$build/ours.txt" 2> "$build/hash" && echo "= $1 $2 $(cat "$build/hash")" && cat "$build/ours.txt"
}
# Of all stages.  Only one whose program is another than that of printed.txt is run.
printed() {
    for s in $(stages); do
        cut_stage $s "$build/stage-$s.c" || exit 1
        sum=$(cksum < "$build/stage-$s.c"); sum=${sum%% *}
        awk -v head="= $s $sum " '/^= / { kept = index($0, head) == 1 } kept' $here/printed.txt > "$build/kept"
        [ ! -s "$build/kept" ] || { cat "$build/kept"; continue; }
        print_stage $s $sum || exit 1
    done
}
# The book's numbers come from here.
measured() { echo 'what,value,unit'; awk -f $here/measured.awk $here/printed.txt; }

compile_mine() {
    [ -f "$mine" ] || { echo "$mine: there is no such file" >&2; exit 1; }
    $cc $exact -O1 -g -Wall -Wextra -fsanitize=address,undefined -fno-sanitize-recover=all \
        "$mine" -o "$build/mine" -lm || { echo "$mine: does not compile; begin with the first error above" >&2; exit 1; }
}

list() {
    echo "stage  lines  added  removed"
    table | awk -F, '{ printf "%-5s %6d %6d %8d  %s\n", $1, $2, $3, $4, $5 }'
    echo
    if [ "$mine" ]; then
        compile_mine
        run "$build/mine" "$build/mine.txt" 2> "$build/mine.err" || echo "$mine: ended badly: $(sed -n 1,2p "$build/mine.err")"
        echo "$mine: $(grep -c '' "$mine") lines, stage $(reached "$build/mine.txt")"
    else
        echo "Write yours in my/little.c, stage by stage; make little 00a runs ours."
    fi
}

# What differs, line by line: the same to a thousandth is the same.
compare() {
    awk '{ name = $0; sub(/ +[^ ]+ +[^ ]+$/, "", name); is = $(NF - 1) " " $NF }
         NR == FNR { ours[name] = is; order[++n] = name; next }
         { yours[name] = is }
         END {
            for (i = 1; i <= n; i++) {
                has = order[i] in yours; split(ours[order[i]], a, " "); split(yours[order[i]], b, " "); d = a[1] - b[1]; size = a[1] < 0 ? -a[1] : a[1]
                if (!has) print order[i] ": yours does not print it, ours " ours[order[i]]
                else if ((d < 0 ? -d : d) > size / 1000 || a[2] != b[2]) print order[i] ": yours " yours[order[i]] ", ours " ours[order[i]]
                else same++
            }
            print same + 0 " of " n " lines are the same"
         }' "$1" "$2"
}

# Three moments as a picture, if the program knows how to draw.
paint() {
    grep -q 'drawing' "$3" || return 0
    painter=${BUILD:-build}/paint-little
    [ -x "$painter" ] || ${AGAIN:-make} -s MINE= "$painter" > "$build/painter.log" 2>&1 || { echo "no picture: the painter cannot be built ($build/painter.log)"; return 0; }
    run "$1" "$build/frames" draw && "$painter" "$2" 3 < "$build/frames" && echo "drawn: $2"
}

run_stage() {
    s=$1
    [ "$(title $s)" ] || { echo "there is no stage $s; make little lists them" >&2; exit 1; }
    cut_stage $s "$build/stage-$s.c" || exit 1
    $cc $exact -O2 -Wall -Wextra "$build/stage-$s.c" -o "$build/stage-$s" -lm || exit 1
    echo "Stage $s: $(title $s) ($build/stage-$s.c, $(grep -c '' "$build/stage-$s.c") lines)"
    run "$build/stage-$s" "$build/ours.txt" || { echo "ours ended badly" >&2; exit 1; }
    sed 's/^/  /' "$build/ours.txt"
    paint "$build/stage-$s" "$build/$s.png" "$build/stage-$s.c"
    [ "$mine" ] || return 0
    compile_mine
    run "$build/mine" "$build/mine.txt" 2> "$build/mine.err" || { echo "$mine ended badly:"; sed -n 1,12p "$build/mine.err"; }
    echo "$mine beside it:"
    compare "$build/ours.txt" "$build/mine.txt" | sed 's/^/  /'
    awk -v stage=$s -f $here/claims.awk $here/stages.txt "$build/mine.txt" && echo "  all that stage $s claims holds for yours"
    paint "$build/mine" "$build/$s-yours.png" "$mine"
    return 0
}

# film PROGRAM FILE.webp [QUALITY]: a moving picture of what it draws.
film() {
    command -v img2webp > /dev/null || { echo "there is no img2webp (make deps-book installs it)" >&2; exit 1; }
    ${AGAIN:-make} -s MINE= "${BUILD:-build}/paint-little" || exit 1
    rm -rf "$build/film" && mkdir "$build/film" || exit 1
    run "$1" "$build/frames" draw
    grep -q frame "$build/frames" || { echo "$1 draws nothing: stages 09 and 18c do, with the argument draw" >&2; exit 1; }
    "${BUILD:-build}/paint-little" "$build/film" film < "$build/frames" || exit 1
    img2webp -loop 0 -kmin 0 -kmax 1 -lossy -q ${3:-70} -m 4 -d 67 "$build"/film/frame-*.png -o "$2" > "$build/film.log" 2>&1 \
        && rm -r "$build/film" && echo "a film: $2"
}
film_ours() {   # STAGE [FILE QUALITY]
    cut_stage "$1" "$build/stage-$1.c" && $cc $exact -O2 "$build/stage-$1.c" -o "$build/stage-$1" -lm || exit 1
    film "$build/stage-$1" "${2:-$build/$1.webp}" $3
}
film_mine() { compile_mine; film "$build/mine" "$build/yours.webp"; }

# The book's two films, and what they were made of.
films() {
    film_ours 09b "$build/little-room.webp" 40 && film_ours 18c "$build/little-engine.webp" 40 &&
        mv "$build/little-room.webp" "$build/little-engine.webp" figures/little && films_of > figures/little/films.txt
}
films_of() { for s in 09b 18c; do cut_stage $s "$build/cut.c"; echo "$s $(cksum < "$build/cut.c")"; done; }

# A page with both films, and what differs: one file, which can be sent to a friend.
page() {
    film_ours "$1"
    run "$build/stage-$1" "$build/ours.txt" || exit 1
    {
        echo '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        echo "<title>$(title $1)</title><style>body { font: 18px/1.5 serif; max-width: 66em; margin: 2em auto; padding: 0 1em }"
        echo 'figure { display: inline-block; width: 48%; min-width: 19em; margin: 0 } img { width: 100% } pre { font-size: 14px }</style>'
        echo "<h1>$(title $1)</h1>"
        if [ "$mine" ]; then
            film_mine >&2
            run "$build/mine" "$build/mine.txt"
            moving "Mine: $(grep -c '' "$mine") lines of C" "$build/yours.webp"
        fi
        moving "The book's: $(grep -c '' "$build/stage-$1.c") lines of C" "$build/$1.webp"
        echo '<pre>'
        if [ "$mine" ]; then compare "$build/ours.txt" "$build/mine.txt"; else cat "$build/ours.txt"; fi |
            sed 's/&/\&amp;/g; s/</\&lt;/g'
        echo '</pre></html>'
    } > "$build/page.html"
    echo "a page: $build/page.html"
}
moving() {
    echo "<figure><img alt=\"$1\" src=\"data:image/webp;base64,$(base64 "$2" | tr -d '\n')\"><figcaption>$1</figcaption></figure>"
}

case $1 in
film)  if [ "$mine" ]; then film_mine; else film_ours "$(last_of "${2:-09b}")"; fi ;;
films) films ;;
films-of) films_of ;;
page)  page "$(last_of "${2:-09b}")" ;;
cut)   cut_stage "$2" "$3" ;;
list)  list ;;
table) echo 'stage,lines,added,removed,title,shows'; table ;;
printed) printed ;;
measured) measured ;;
run)   run_stage "$(last_of "$2")" ;;
*)     sed -n '2,12s/^# //p' "$0"; exit 1 ;;
esac
