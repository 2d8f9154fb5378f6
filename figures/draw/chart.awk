# chart.awk - the SVG of a chart, as gnuplot wrote it, in colours that follow the
# page it stands on, light or dark, and in a few bytes.  Each colour becomes a
# class; one that is not in the palette is an error, and so is a shape that is
# not known here.

BEGIN {
    RS = "<"
    split("page ink quiet rule blue orange green purple red grey", name, " ")
    split("#fffefb #22252a #5d636d #d9d6cd #1f6fb4 #c8570b #2c7d3f #7b4ba8 #b8252f #6b7078", light, " ")
    split("#16181c #e4e2dc #a3a8b0 #3a3f47 #6cb0ee #f0a060 #74c284 #b794dc #ef7a80 #9aa0a8", dark, " ")
    for (i = 1; i in name; i++) class[rgb(light[i])] = name[i]
    class["white"] = "page"; class["black"] = "ink"
    used["page"] = 1
}

# "#1f6fb4" is what gnuplot calls "rgb(31,111,180)".
function rgb(hex) { return "rgb(" byte(hex, 2) "," byte(hex, 4) "," byte(hex, 6) ")" }
function byte(hex, at) { return digit(hex, at) * 16 + digit(hex, at + 1) }
function digit(hex, at) { return index("0123456789abcdef", substr(hex, at, 1)) - 1 }

function fail(why) { print FILENAME ": " why > "/dev/stderr"; failed = 1; exit 1 }

# The value of an attribute of this tag, or nothing.
function value(key,    a) {
    if (!match($0, "[ \t\n]" key " *= *['\"]")) return ""
    a = substr($0, RSTART + RLENGTH)
    sub(/['"].*/, "", a)
    return a
}

function colour(c) {
    gsub(/ /, "", c)
    if (!(c in class)) fail("the colour " c " is not in the palette")
    used[class[c]] = 1
    return class[c]
}

# A tenth of a pixel is enough.
function tenth(x) { x = sprintf("%.1f", x); sub(/\.0$/, "", x); return x == "-0" ? "0" : x }

function attribute(key, x) { return x == "" ? "" : " " key "=\"" x "\"" }

# Shapes that differ in nothing but their place become one.
function shape(head, d) {
    if (head != before || head ~ /fill.*opacity/) { flush(); before = head }
    body = body d
}
function flush() {
    if (body != "") out = out "<path" before " d=\"" body "\"/>\n"
    body = before = ""
}

# A path is written as steps from point to point, which are short.
function begin_path() { d = ""; moved = 0 }
function move_to(x, y) {
    px = tenth(x); py = tenth(y)
    d = d "M" px " " py
    moved = 0
}
function line_to(x, y,    dx, dy) {
    x = tenth(x); y = tenth(y)
    dx = tenth(x - px); dy = tenth(y - py)
    if (dx == "0" && dy == "0") return
    d = d (!moved ? "l" dx : dx ~ /^-/ ? dx : " " dx) (dy ~ /^-/ ? dy : " " dy)
    px = x; py = y; moved = 1
}

function path(    n, t, i, x, y) {
    begin_path()
    n = split(value("d"), t, /[ \t\n]+/)
    for (i = 1; i <= n; i++) {
        if (t[i] == "") continue
        if (t[i] ~ /^[Zz]$/) { d = d "z"; moved = 0; continue }
        if (t[i] !~ /^[ML]?[-0-9.]+,[-0-9.]+$/) fail("what is " t[i] " in a path?")
        x = t[i]; sub(/^[ML]/, "", x); y = x; sub(/,.*/, "", x); sub(/.*,/, "", y)
        if (t[i] ~ /^M/ || d ~ /z$/) move_to(x, y); else line_to(x, y)
    }
    shape(" class=\"" colour(value("stroke")) " line\"" attribute("stroke-width", width) \
          attribute("stroke-dasharray", value("stroke-dasharray")) attribute("opacity", value("opacity")), d)
}

function polygon(    n, t, i, x, y) {
    begin_path()
    n = split(value("points"), t, /[ \t\n]+/)
    for (i = 1; i <= n; i++) {
        if (t[i] == "") continue
        x = y = t[i]; sub(/,.*/, "", x); sub(/.*,/, "", y)
        if (d == "") move_to(x, y); else line_to(x, y)
    }
    shape(" class=\"" colour(value("fill")) " fill\"" attribute("opacity", value("fill-opacity") + 0 ? value("fill-opacity") + 0 : ""), d "z")
}

# gnuplot's point types, counted from 0: crosses, squares, circles, triangles, diamonds.
function point(    kind, at, x, y, r, head) {
    kind = value("xlink:href"); sub(/#gpPt/, "", kind)
    at = value("transform")
    gsub(/[a-z(),]+/, " ", at); split(at, place, " ")
    x = place[1]; y = place[2]; r = place[3]
    head = attribute("opacity", value("opacity"))
    if (kind == 6) {        # a line of no length with a round end
        shape(" class=\"" colour(value("color")) " dot\"" attribute("stroke-width", tenth(2 * r)) head, "M" tenth(x) " " tenth(y) "h0")
        return
    }
    if (kind ~ /^(0|1|3|5)$/) head = " line\"" attribute("stroke-width", width) head
    else if (kind ~ /^(4|8|10|12)$/) head = " fill\"" head
    else fail("what is point type " kind + 1 "?")
    shape(" class=\"" colour(value("color")) head, \
          kind == 0 ? from(x - r, y) "h" tenth(2 * r) from(x, y - r) "v" tenth(2 * r) : \
          kind == 1 ? from(x - r, y - r) by(2 * r, 2 * r) from(x - r, y + r) by(2 * r, -2 * r) : \
          kind == 3 || kind == 4 ? from(x - r, y - r) "h" tenth(2 * r) "v" tenth(2 * r) "h" tenth(-2 * r) "z" : \
          kind == 5 ? from(x - r, y) "a" tenth(r) " " tenth(r) " 0 1 0 " tenth(2 * r) " 0a" tenth(r) " " tenth(r) " 0 1 0 " tenth(-2 * r) " 0z" : \
          kind == 8 ? from(x, y - 1.33 * r) by(-1.33 * r, 2 * r) by(2.66 * r, 0) "z" : \
          kind == 10 ? from(x, y + 1.33 * r) by(-1.33 * r, -2 * r) by(2.66 * r, 0) "z" : \
          from(x, y - 1.4 * r) by(1.4 * r, 1.4 * r) by(-1.4 * r, 1.4 * r) by(-1.4 * r, -1.4 * r) "z")
}
function from(x, y) { return "M" tenth(x) " " tenth(y) }
function by(x, y) { return "l" tenth(x) " " tenth(y) }

function begin_text(    at, k) {
    at = value("transform"); gsub(/[a-z(),]+/, " ", at)
    k = split(at, place, " ")
    head = " class=\"" colour(value("fill")) "\"" \
        (k > 2 && place[3] ? " transform=\"translate(" tenth(place[1]) " " tenth(place[2]) ") rotate(" place[3] ")\"" \
                           : " x=\"" tenth(place[1]) "\" y=\"" tenth(place[2]) "\"") \
        (value("text-anchor") ~ /middle|end/ ? attribute("text-anchor", value("text-anchor")) : "")
    size = value("font-size") + 0
    head = head (size == 13 ? "" : attribute("font-size", size))
    words = spans = ""; shift = 0
}
function span(    s, dy, look) {
    s = $0; sub(/^[^>]*>/, "", s)
    dy = value("dy"); sub(/px/, "", dy); shift += dy
    if (s == "") return
    look = (value("font-size") != "" && value("font-size") + 0 != size ? attribute("font-size", value("font-size") + 0) : "") \
        attribute("font-weight", value("font-weight")) attribute("font-style", value("font-style")) \
        (shift ? attribute("dy", tenth(shift)) : "")
    words = words (look == "" ? s : "<tspan" look ">" s "</tspan>")
    shift = 0
}

/^svg/ { split(value("viewBox"), box, " ") }
/^g fill="none"/ { width = value("stroke-width") + 0; width = width == 1 ? "" : width }
/^path stroke=/ { path() }
/^polygon/ { polygon() }
/^use xlink:href='#gpPt[0-9]+' transform=/ { point() }
/^g transform=/ { begin_text() }
/^(text|tspan)/ { span() }
/^\/text/ && words ~ /[^ \t\n]/ { flush(); sub(/^ +/, "", words); out = out "<text" head ">" words "</text>\n" }

function colours(which,    i, all) {
    for (i = 1; i in name; i++) if (name[i] in used) all = all "." name[i] "{color:" which[i] "}"
    return all
}

END {
    if (failed) exit 1
    flush()
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n", box[3], box[4], box[3], box[4]
    print "<style>"
    print "svg{font:13px system-ui,-apple-system,\"Segoe UI\",Roboto,\"DejaVu Sans\",sans-serif}"
    print "text,.fill{fill:currentColor}.line,.dot{fill:none;stroke:currentColor;stroke-linejoin:round}.dot{stroke-linecap:round}"
    print colours(light)
    print "@media(prefers-color-scheme:dark){" colours(dark) "}"
    print "</style>"
    printf "<path class=\"page fill\" d=\"M0 0h%dv%dH0z\"/>\n%s</svg>\n", box[3], box[4], out
}
