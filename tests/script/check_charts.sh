# check_charts.sh - does every chart follow the page it stands on?  Each .gp has
# its SVG; outside of the style, which sets a colour for light pages and one for
# dark, no shape has a colour of its own; its words are text; it asks for nothing
# outside of itself, is small, no word leaves it and none stands on another.
# chart.awk refuses what is not in the palette.  With arguments, only the words
# of these charts are looked at.

export LC_ALL=C
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
failed=
complain() { echo "$1"; failed=1; }

# words CHART.svg: those that leave the picture, in a wide font, or stand in others.
words() {
    awk '/^<svg/ { high = wide = $0; sub(/.*" height="/, "", high); high += 0; sub(/.* width="/, "", wide); wide += 0 }
    /^<text/ && !/rotate/ {
        head = $0; sub(/>.*/, "", head)
        x = head; sub(/.* x="/, "", x); y = head; sub(/.* y="/, "", y); x += 0; y += 0
        size = 13; if (head ~ / font-size=/) { size = head; sub(/.* font-size="/, "", size); size += 0 }
        words = $0; gsub(/<[^>]*>/, "", words); gsub(/&[a-z]*;/, "x", words); gsub(/[\200-\277]/, "", words)
        long = length(words) * size * ($0 ~ /bold/ ? 0.62 : 0.54)
        left = x - long * (head ~ /"end"/ ? 1 : head ~ /"middle"/ ? 0.5 : 0)
        if (left < 0 || left + long > wide || y < 8 || y > high - 3) print "cuts off: " words
        n++; L[n] = left; R[n] = left + 0.98 * long; top[n] = y - 0.72 * size; low[n] = y; said[n] = words
        for (i = 1; i < n; i++)
            if (L[i] < R[n] - 1 && L[n] < R[i] - 1 && top[i] < low[n] - 1 && top[n] < low[i] - 1)
                print "writes one thing over another: " said[i] " and " words
    }' "$1"
}

# faults CHART.svg: what is wrong with it.
faults() {
    [ -s "$1" ] || { echo "is missing"; return; }
    [ "$(wc -c < "$1")" -le 65536 ] || echo "has more than 64 kB"
    grep -q '^@media(prefers-color-scheme:dark){.page{color:#16181c}' "$1" || echo "does not follow a dark page"
    sed '/^<style>$/,/^<\/style>$/d' "$1" > "$place/body"
    grep -o '\(#[0-9a-fA-F]\{3,8\}\|rgb(\|fill="\|stroke="\| style="\)[^"]*' "$place/body" | sed 's/^/sets a colour of its own: /' | sort -u
    grep -q '<image\|href=' "$place/body" && echo "asks for something outside of itself"
    grep -q 'viewBox="0 0 720 ' "$1" || echo "is not 720 wide"
    for size in $(grep -o '<text[^>]* font-size="[0-9]*"' "$place/body" | sed 's/.*="//; s/"//' | sort -u); do
        [ "$size" -ge 12 ] && [ "$size" -le 16 ] || echo "has type of $size px"
    done
    words "$1"
    shades=$(sed 's/.*class="\([a-z]*\).*/\1/; /^[<.@]/d' "$place/body" | sort -u)
    for class in $shades; do
        [ "$(grep -c "[.]$class{color:#" "$1")" = 2 ] || echo "$class has no colour for light and dark"
    done
}

if [ $# -gt 0 ]; then
    for chart in "$@"; do words "$chart" | sed "s|^|$chart: |"; done | grep . && exit 1
    exit 0
fi
for plot in figures/[0-9]*/*.gp figures/peers/*.gp; do
    chart=${plot%.gp}.svg
    found=$(faults "$chart")
    [ -z "$found" ] || complain "$chart: $found"
done

# What must be seen is seen.
a=$(ls figures/[0-9]*/*.svg | head -n 1)
broken() {
    sed "$1" "$a" > "$place/broken.svg"
    faults "$place/broken.svg" | grep -q "$2" || complain "a chart that $2 passes"
}
[ -z "$(faults "$a")" ] || complain "$a itself is not sound"
broken '/^<path class="page/s/class="page fill"/fill="#ffffff"/' 'sets a colour of its own'
broken '/^@media/d' 'does not follow a dark page'
broken 's/<text/<text font-size="9"/' 'has type of 9 px'
broken 's/class="ink"/class="mauve"/' 'mauve has no colour'
broken 's/<text class="ink" x="[0-9.]*"/<text class="ink" x="700"/' 'cuts off'
broken '/^<text/p' 'writes one thing over another'
broken 's/<\/svg>/<image href="x.png"\/><\/svg>/' 'asks for something outside'

# refuses WHAT LINE: chart.awk says so, and fails.
refuses() {
    printf '<svg\n viewBox="0 0 720 9"\n>\n<g fill="none" stroke-width="1.00">\n%s\n</g></svg>\n' "$2" > "$place/raw"
    awk -f figures/draw/chart.awk "$place/raw" > "$place/drawn" 2> "$place/said" && complain "chart.awk takes $1"
    grep -qF "$1" "$place/said" || complain "chart.awk does not name $1"
}
refuses 'rgb(255,0,255)' "<path stroke='rgb(255,  0, 255)' d='M0,0 L1,1'/>"
refuses 'point type 14' "<use xlink:href='#gpPt13' transform='translate(1,1) scale(2)' color='black'/>"
printf "<svg\n viewBox='0 0 720 9'\n>\n<g fill=\"none\" stroke-width=\"2.00\">\n<path stroke='rgb( 31, 111, 180)' d='M0.04,1.26 L1,1'/></g></svg>\n" > "$place/raw"
awk -f figures/draw/chart.awk "$place/raw" | grep -qxF '<path class="blue line" stroke-width="2" d="M0 1.3l1-0.3"/>' || complain "chart.awk does not draw a blue line"
[ -z "$failed" ]
