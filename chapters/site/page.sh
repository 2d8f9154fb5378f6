# page.sh - woven pages as pandoc makes something of them:
#   sh page.sh page FILE NN-name       a chapter's page of the site
#   sh page.sh index FILE              the first page, from index.md and README
#   sh page.sh exercises FILE          the tasks of all exercises
#   sh page.sh write FILE NN-name      an exercise, to be written in the page
#   sh page.sh little FILE             the stages of the little program
#   sh page.sh search FILE             what a search looks through
#   sh page.sh html|pdf|epub FILE      the whole book

form=$1 file=$2 page=$3
here=chapters/site
export LC_ALL=C
part=$(mktemp -d)
trap 'rm -rf "$part"' EXIT

# wants PROGRAM...: the first of these that is here, in $found.
wants() {
    for found in "$@"; do command -v "$found" > /dev/null && return; done
    echo "make $form needs $1, which is not here; make deps-book installs it." \
         "book.md needs nothing: it is the same book." >&2
    exit 1
}
wants pandoc

reader=gfm+tex_math_dollars+attributes+footnotes+fenced_divs+bracketed_spans
# convert FORMAT OPTION... < what page.awk made: what all forms have in common.
convert() {
    format=$1; shift
    pandoc -f "$reader" \
        -t "$format" --standalone --mathml --section-divs --wrap=none \
        --no-highlight --lua-filter $here/page.lua "$@"
}
# SITE_URL, if the site has an address: what is passed on says it.
site() {
    [ -z "$SITE_URL" ] || set -- "$@" --metadata url="${SITE_URL%/}/" --metadata self="$(basename "$file" | sed 's/^index.html$//')"
    [ ! -e "${BUILD:-build}/workshop/node/.done" ] || set -- "$@" --metadata workshop=true
    convert html5 --template $here/page.html --metadata page="$page" "$@" -o "$file"
}
# What a page is about: the question that README says it asks, or its title.
about() {
    { sed -n "s/^| .*chapters\/woven\/$1\.md) | \(.*\) |\$/\1/p" README.md | sed 's/`//g; s/\[\([^]]*\)\]([^)]*)/\1/g'; echo "$(title "$1")."; } | head -n 1
}
title() { sed -n 's/^# //p; /^# /q' "chapters/woven/$1.md"; }
pages() { ls chapters/woven | sed 's/\.md$//'; }

# The page before and the page after, with their titles.
turn() {
    set -- "$@" --metadata turn=true
    before=$(pages | grep -B 1 -x "$page" | grep -vx "$page")
    after=$(pages | grep -A 1 -x "$page" | grep -vx "$page")
    [ -z "$before" ] || set -- "$@" --metadata before="$before" --metadata before-title="$(title "$before")"
    [ -z "$after" ] || set -- "$@" --metadata after="$after" --metadata after-title="$(title "$after")"
    site --metadata description="$(about "$page") From a course and a C library of rigid bodies, cloth, rope and joints." "$@"
}

# The chapter, and its small figures, each after the paragraph that begins so; the one
# without such words after the first of the chapter's question (openings.txt).  One
# that announces what is below it, with a colon, has its figure above.
opened() {
    awk -v page="$page" -F ' *[|] *' '
        function shows(k) {
            print "![" says[k] "](../../figures/live/" figure[k] ".webp){.small" (dial[k] == "race" ? " race=\"" set[k] "\"" : (dial[k] == "" ? "" : " dial=" dial[k]) (set[k] == "" ? "" : " set=\"" set[k] "\"")) "}\n"
        }
        function announces() { return /:$/ }
        FILENAME ~ /openings/ {
            if ($1 == page) { n++; begins[n] = $2; figure[n] = $3; dial[n] = $4; set[n] = $5; says[n] = $6 }
            next
        }
        /^```/ { code = !code }
        code || /^```/ { print; next }
        /^## / && !asked { asked = near = 1; print; next }
        near == 1 && /./ { near = 0; for (k = 1; k <= n; k++) if (begins[k] == "") { if (announces()) shows(k); else after = k } }
        { for (k = 1; k <= n; k++) if (begins[k] != "" && index($0, begins[k]) == 1) { if (announces()) shows(k); else after = k }
          print
          if (after && !/./) { shows(after); after = 0 } }
    ' $here/openings.txt "chapters/woven/$page.md"
}

# The exercises of a chapter, in the order in which it tells of them (site.mk).
exercises_of() { grep "^${1%%-*}-" "${BUILD:-build}/asked"; }

# The tasks under their chapters, each a heading lower.
tasks() {
    printf '# Exercises\n\n'
    cat $here/exercises.md
    for one in $(pages); do
        exercises_of "$one" > "$part/of"
        [ -s "$part/of" ] || continue
        printf '\n## %s\n\n%sThey belong to [chapter %s](%s.md).\n' "$(title "$one")" "$(still "$one")" "${one%%-*}" "$one"
        while read -r id; do
            echo; sed 's/^#/###/' "exercises/$id/README.md"; where_written "$id"
        done < "$part/of"
    done
}

# What moves in a chapter, standing still, and the way to it.  On a dark page a drawing
# in space has its twin, and a flat one is inverted (style.css).
still() {
    one=$(sed -n 's|^!\[.*(\.\./\.\./figures/live/\([a-z]*\)\.webp)$|\1|p' "chapters/woven/$1.md" | head -n 1)
    [ -n "$one" ] || return
    source='' kind=' flat'
    [ ! -e "figures/live/$one-dark.webp" ] || { kind=''; source="<source media=\"(prefers-color-scheme: dark)\" srcset=\"figures/live/$one-dark.webp\">"; }
    echo "<a href=\"$1.html#figure-$one\"><picture>$source<img class=\"thumb$kind\" src=\"figures/live/$one.webp\" alt=\"what moves there\" width=\"1200\" height=\"675\" loading=\"lazy\"></picture></a> "
}

# The link to where an exercise is written in the page, if it is (workshop.mk).
where_written() {
    [ ! -e "${BUILD:-build}/workshop/node/.done" ] || case $1 in
    0*) printf '\n[Write it here](write-%s.html){.write}\n' "$1" ;;
    esac
}

# The task of an exercise; if it builds a module, with what that moves in; and the
# exercises before and after.
write() {
    chapter=$(pages | grep -m 1 "^${page%%-*}-")
    cat "exercises/$page/README.md"
    printf '\nAt the desk this is `make exercise %s`, and [all exercises](exercises.html#%s) are on one page. It belongs to [chapter %s](%s.md).\n' \
        "$(echo "$page" | sed 's/-/\//')" "$page" "${page%%-*}" "$chapter"
    after=$(grep '^0' "${BUILD:-build}/asked" | grep -A 1 -x "$page" | grep -vx "$page")
    [ -z "$after" ] || printf '\nThe next is [%s](write-%s.html){.next}.\n' "$(sed -n '1s/^# //p' "exercises/$after/README.md")" "$after"
    figure=$(sed -n "s|^FIGURE_$page := \([^ ]*\) .*|\1|p" "${BUILD:-build}/workshop/parts.mk")
    [ -z "$figure" ] || { echo; grep -m 1 "^!\[.*figures/live/$figure\.webp)" "chapters/woven/$chapter.md"; }
}

# The stages, chapter by chapter; a script makes of each name what chooses it.
stages() {
    cat $here/little.md
    awk -F ' *[|] *' '/^[0-9]/ {
        chapter = substr($1, 1, 2)
        if (chapter != before) print "\n**Chapter " chapter "**\n"
        before = chapter
        printf "- [%s]{.number} <a id=\"%s\" href=\"#%s\" data-stage=\"%s\">%s</a>\n", $1, $1, $1, $1, $2
    }' chapters/little/stages.txt
}

# Which pages: on paper the chapters are one volume, and the listings another.
listed() {
    case $volume in
    1) pages | grep '^[0-9]' ;;
    2) pages | grep '^tumble-'; pages | grep '^lib-' ;;
    *) pages ;;
    esac
}
book() { for one in $(listed); do awk -f $here/page.awk "chapters/woven/$one.md"; echo; done; }
whole() {
    subtitle="a world of particles and sticks"
    [ "$volume" != 2 ] || subtitle="Second volume: the header, function by function, and what no chapter shows, line by line"
    book | convert "$@" --toc --toc-depth="${deep:-2}" --metadata whole=true ${volume:+--metadata volume="$volume"} --resource-path="${BUILD:-build}/site:." \
        --metadata title=tumble --metadata subtitle="$subtitle" --metadata lang=en
}
embedded() {
    to=$1; shift
    embed=--embed-resources         # pandoc 3; before it:
    pandoc --help | grep -q -e "$embed" || embed=--self-contained
    whole html5 $embed --css $here/style.css --css $here/whole.css "$@" -o "$to"
}

# What says to those who listen how a page is built is most of its bytes.
pack() {
    if command -v qpdf > /dev/null; then qpdf --object-streams=generate "$1" "$2"; else cp "$1" "$2"; fi
}

# On paper a chapter has its title over its pages, and begins on a new one; a listing
# does not.  What is said of paper holds for the layout that paper.js looks at, too.
heads() {
    echo '<style>'
    if [ "$volume" = 2 ]; then echo 'section.level1 { break-before: auto; }'; else
        for one in $(listed); do
            printf '[id="%s"] { page: c%s } @page c%s { @top-left { content: "%s" } }\n' \
                "$one" "$one" "$one" "$(title "$one")"
        done
    fi
    echo '</style>'
    [ "$volume" = 2 ] || { echo '<script>'; cat $here/paper.js; echo '</script>'; }
}

# print PAGE FILE: a page on paper.
print() {
    "$found" --headless --no-sandbox --disable-gpu --no-pdf-header-footer --generate-pdf-document-outline \
        --virtual-time-budget=10000 --print-to-pdf="$2" "file://$1" 2> /dev/null && [ -s "$2" ]
}
# The contents, and what leads into the other volume, know their pages when all has been
# printed once.
number() {
    LC_ALL=C grep -aE '^[0-9]+ 0 obj|/Kids \[|/Pages [0-9]|/XYZ' "$part/$volume.pdf" | awk -f $here/pages.awk > "$part/$volume.pages"
    awk 'FILENAME ~ /2\.pages$/ { there[$1] = $2 } FILENAME ~ own { page[$1] = $2 } FILENAME !~ /html$/ { next }
         match($0, /^<li><a href="#[^"]*"/) && (name = substr($0, 15, RLENGTH - 15)) in page {
             sub(/<\/a>/, "<span class=\"at\">" page[name] "</span></a>")
         }
         { while (match($0, /<span class="there" data-page="[^"]*"><\/span>/)) {
               name = substr($0, RSTART + 31, RLENGTH - 40)
               $0 = substr($0, 1, RSTART - 1) (name in there ? " (II, " there[name] ")" : "") substr($0, RSTART + RLENGTH)
           } print }' own="$volume[.]pages\$" "$part"/*.pages "$part/$volume.html" > "$part/numbered.html" && print "$part/numbered.html" "$part/$volume.pdf"
}
# The second volume comes first: the other names its pages.
on_paper() {
    deep=1
    for volume in 2 1; do
        heads > "$part/heads" && embedded "$part/$volume.html" --include-in-header "$part/heads" &&
            sed 's/@media print/@media all/' "$part/$volume.html" > "$part/all.html" && mv "$part/all.html" "$part/$volume.html" &&
            print "$part/$volume.html" "$part/$volume.pdf" && number || return 1
    done
    pack "$part/1.pdf" "$file" && pack "$part/2.pdf" "${file%.pdf}-2.pdf"
}

case $form in
page) opened | awk -f $here/page.awk | turn --metadata pagetitle="$(title "$page")" ;;
index) awk -f $here/index.awk $here/index.md README.md | site --metadata home=true --metadata pagetitle="a world of particles and sticks" \
        --metadata description="A course and a C library in one tree: rigid bodies, cloth, rope and joints, made of nothing but particles and sticks, and running in the page." ;;
search) { book; tasks | awk -f $here/page.awk; } | awk '/^```/ { code = !code; next } !code' |
        pandoc -f "$reader" -t plain --wrap=none --lua-filter $here/search.lua -o "$file" ;;
write) write | awk -f $here/page.awk | site --metadata write="$page" \
        --metadata description="An exercise in C, written, compiled and judged in the page." --metadata pagetitle="$(sed -n '1s/^# //p' "exercises/$page/README.md")" ;;
little) stages | site --metadata write=little --metadata little=true --metadata pagetitle="Your engine" \
        --metadata description="A program in C that grows from a falling ball to an engine, written and run in the page, and saved as a page of its own." ;;
exercises) tasks | awk -f $here/page.awk | site --metadata pagetitle=Exercises --metadata description="All exercises of the course: a file with a hole in it, and tests that judge what you write there." ;;
html) embedded "$file" ;;
pdf)  wants chromium chromium-browser google-chrome
      on_paper ;;
epub) whole epub3 --css $here/epub.css --epub-embed-font $here/math.woff2 -o "$file" ;;
esac && [ -s "$file" ] || exit 1
case $form in html|pdf|epub) wc -c "$file" $([ $form != pdf ] || echo "${file%.pdf}-2.pdf") | sed -n 's/^ *\([0-9]*\) \(.*book.*\)/\2: \1 bytes/p' ;; esac
