# html.sh - writes the book as one page: sh chapters/html.sh build/book.html

command -v pandoc > /dev/null || {
    echo "make html needs pandoc, which is not here; make deps-book installs it." \
         "book.md needs nothing: it is the same book." >&2
    exit 1
}
page=$1
embed=--embed-resources         # pandoc 3; before it:
pandoc --help | grep -q -e "$embed" || embed=--self-contained

export LC_ALL=C
awk -f chapters/weave.awk lib/*.h lib/*.c tests/oracle.[hc] chapters/[0-9]*.md > "$page.md" &&
awk -f chapters/html.awk "$page.md" > "$page.in" &&
pandoc -f gfm+tex_math_dollars+attributes+footnotes -t html5 \
    --standalone $embed --toc --toc-depth=2 --mathml \
    --metadata title="tumble" --metadata subtitle="a world of particles and sticks" \
    --metadata lang=en --css chapters/book.css --highlight-style=kate \
    --lua-filter chapters/book.lua "$page.in" -o "$page" &&
rm -f "$page.in" "$page.md" && echo "$page: $(wc -c < "$page") bytes"
