# page.sh - the book beside book.md: sh chapters/page.sh html|pdf|epub FILE
# One page of HTML with all in it; that page printed by a browser; an e-book.

form=$1
file=$2
export LC_ALL=C

# wants PROGRAM...: the first of these that is here, in $found.
wants() {
    for found in "$@"; do command -v "$found" > /dev/null && return; done
    echo "make $form needs $1, which is not here; make deps-book installs it." \
         "book.md needs nothing: it is the same book." >&2
    exit 1
}

wants pandoc
[ "$form" != pdf ] || { wants chromium chromium-browser google-chrome; browser=$found; }

# What the three have in common: the text as pandoc reads it, on its way to $1.
write() {
    sh chapters/weave.sh "$file.woven" && awk -f chapters/page.awk "$file.woven/book.md" > "$file.in" &&
    pandoc -f gfm+tex_math_dollars+attributes+footnotes --standalone --mathml \
        --toc --toc-depth=2 --highlight-style=kate --lua-filter chapters/book.lua \
        --metadata title="tumble" --metadata lang=en \
        --metadata subtitle="a world of particles and sticks" \
        "$@" "$file.in"
    status=$?
    rm -rf "$file.in" "$file.woven"
    return $status
}

page() {
    embed=--embed-resources         # pandoc 3; before it:
    pandoc --help | grep -q -e "$embed" || embed=--self-contained
    write -t html5 $embed --css chapters/book.css \
        --include-after-body chapters/side.html -o "$1"
}

case $form in
html) page "$file" ;;
pdf)  # A link on every line of code, and a tag on every word of it for those who
      # listen, are three quarters of the bytes; to listen there is the page.
      page "$file.page" && sed 's/<a href="#cb[0-9-]*"/<a/g' "$file.page" > "$file.html" &&
      "$browser" --headless --no-sandbox --disable-gpu --no-pdf-header-footer \
          --disable-pdf-tagging --virtual-time-budget=10000 --print-to-pdf="$file" \
          "file://$(cd "$(dirname "$file")" && pwd)/$(basename "$file").html" 2> /dev/null
      status=$?; rm -f "$file.page" "$file.html"; [ "$status" = 0 ] ;;
epub) write -t epub3 --css chapters/epub.css \
          --epub-embed-font chapters/math.woff2 -o "$file" ;;
esac && [ -s "$file" ] && echo "$file: $(wc -c < "$file") bytes"
