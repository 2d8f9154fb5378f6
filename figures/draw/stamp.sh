# stamp.sh - is each figure and each table as its program would make it today?
# made.txt in figures/tables has a line for each: checksums of the data that were
# written, of what its chart is drawn from, of what it is gathered from, of the
# settings (compiler's flags, TUMBLE_QUICK), and of the sources of its program,
# folder by folder, without comments and white space; and after an @ the machine
# that measured it.
#   sh figures/draw/stamp.sh 10-slow hard...   these have just been made
#   sh figures/draw/stamp.sh -d 10-slow...     these are drawn from the data as they
#                                              were
#   sh figures/draw/stamp.sh -n                what to make, to renew what is older
#   sh figures/draw/stamp.sh                   which are older, and than what?
# A product is a figure of a chapter, by its name; a table, hard; a comparison,
# peers; or moving, README's moving picture.

export LC_ALL=C
made=figures/tables/made.txt
mode=check
case $1 in -d) mode=drawn; shift ;; -n) mode=goals ;; *) [ $# = 0 ] || mode=made ;; esac
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/bare"

# What is there; the products and their programs; what each is made of.
ls lib/*.h lib/*/*.[ch] tests/*/*.[ch] figures/[0-9]*/* figures/draw/* figures/measure/*.[ch] \
    figures/command/*.[ch] figures/scenes/*.[ch] figures/manual/*.[ch] figures/moving/* figures/peers/* figures/tables/*.csv 2> /dev/null > "$work/files"
awk -v speed="$(sed -n '/^SPEED :=/,/[^\\]$/p' Makefile | sed 's/.*:=//; s/\\$//' | tr '\n' ' ')" \
    -f figures/draw/products.awk "$work/files" > "$work/products" || exit 1
awk -v into="$work/bare" -f figures/draw/stamp.awk \
    $(grep '\.[ch]$\|\.cpp$\|\.edits$\|table\.awk$\|moving\.sh$' "$work/files") < "$work/products" || exit 1
{
    (cd "$work/bare" && ls | grep -v '^made-of$' | xargs cksum | sed 's/%/\//g; s/ \([^ ]*\)$/ bare:\1/')
    grep '\.csv$\|\.gp$\|draw/chart\.' "$work/files" | xargs cksum
} > "$work/sums"

# made.txt as a run of today would write it.
usual="$(sed -n 's/^EXACT *:= *//p' Makefile) $(sed -n 's/^CFLAGS *?= *//p' Makefile)"
settings() { echo "$1" | cksum | cut -d' ' -f1; }
now() {     # SETTINGS
    awk -v settings="$(settings "$1")" '
        function add(key, path) {
            if (!(key in total)) order[++keys] = key
            total[key] = (total[key] * 31 + sum[path]) % 2147483647
        }
        FILENAME ~ /sums$/ { sum[$3] = $1; next }
        FILENAME ~ /products$/ { data[$1] = $3; drawn[$1] = $4; from[$1] = $5; next }
        {
            split("", total); keys = 0
            n = split(data[$1], part, ","); total["data"] = 0; order[++keys] = "data"; for (i = 1; i <= n; i++) add("data", part[i])
            n = split(drawn[$1], part, ","); total["drawn"] = 0; order[++keys] = "drawn"; for (i = 1; i <= n; i++) add("drawn", part[i])
            n = split(from[$1], part, ","); total["from"] = 0; order[++keys] = "from"; for (i = 1; i <= n; i++) add("from", part[i])
            line = $1; for (i = 2; i <= NF; i++) {
                folder = $i; sub(/\/[^\/]*$/, "", folder); if (folder ~ /^figures\/[0-9]/) folder = "program"
                add(folder, "bare:" $i)
            }
            for (i = 1; i <= keys; i++) line = line " " order[i] "=" sprintf("%.0f", total[order[i]])
            print line " settings=" settings
        }' "$work/sums" "$work/products" "$work/bare/made-of"
}
machine() {
    chip=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2> /dev/null | head -n 1)
    echo "${CC:-cc} $(${CC:-cc} -dumpversion 2> /dev/null), ${chip:-$(uname -sm)}"
}
if [ $mode = made ] || [ $mode = drawn ]; then
    now "${SETTINGS:-$usual}${TUMBLE_QUICK:+ TUMBLE_QUICK}" > "$work/now"
    for name in "$@"; do
        new=$(grep "^$name " "$work/now") || { echo "stamp.sh: figures/ has no $name"; exit 1; }
        was=$(grep "^$name data=" $made)
        if [ $mode = drawn ] && [ "$was" ]; then
            drawn=${new#* drawn=}; new=$(echo "$was" | sed "s/ drawn=[^ ]*/ drawn=${drawn%% *}/")
        else new="$new @ $(machine)"; fi
        { grep -v "^$name " $made; echo "$new"; } | sort > $made.new && mv $made.new $made || exit 1
    done
    exit 0
fi

now "$usual" > "$work/now"
failed=
awk -v goals=$([ $mode = goals ] && echo 1) '
    function say(sentence, goal) { if (goals) print goal; else print sentence ": run make " goal; bad = 1 }
    function pairs(line, into,    word, n, i, k) {
        split("", into); n = split(line, word, " "); k = 0
        for (i = 2; i <= n && word[i] != "@"; i++) { split(word[i], pair, "="); into[pair[1]] = pair[2]; key[++k] = pair[1] }
        return k
    }
    FILENAME ~ /products$/ { file[$1] = $6; picture[$1] = $7; command[$1] = $8; gsub(/~/, " ", command[$1]); next }
    FILENAME ~ /made.txt$/ { was[$1] = $0; next }
    {
        name = $1; changed = ""
        if (was[name] !~ / data=/) { say(file[name] " has no stamp", command[name]); next }
        n = pairs(was[name], old)
        for (i = 1; i <= n; i++) last[i] = key[i]
        k = pairs($0, new)
        for (i = 1; i <= k; i++) if (key[i] !~ /^(data|drawn|from|settings)$/ && old[key[i]] != new[key[i]])
            changed = changed ", " (key[i] == "program" ? "its program" : key[i])
        for (i = 1; i <= n; i++) if (!(last[i] in new)) changed = changed ", " last[i] " (which it no longer uses)"
        if (old["from"] != new["from"]) changed = changed ", the tables that it is gathered from"
        if (changed) say(file[name] " is older than " substr(changed, 3), command[name])
        else if (old["settings"] != new["settings"]) say(file[name] " was made with other settings than those of make", command[name])
        else if (old["data"] != new["data"]) say(file[name] " is not what its program wrote", command[name])
        else if (old["drawn"] != new["drawn"]) say(picture[name] " is older than its data or its .gp", "chart-" name)
    }
    END { exit bad }' "$work/products" $made "$work/now" || failed=1
[ $mode = check ] || exit 0

complain() { echo "$1"; failed=1; }
cat chapters/*.md README.md > "$work/prose"
for picture in $(awk '$7 != "-" { print $7 }' "$work/products"); do
    [ -s "$picture" ] || complain "$picture is missing"
    grep -qF "$picture" "$work/prose" || complain "$picture stands in no chapter"
done
for left in figures/[0-9]*/*.png figures/[0-9]*/*.csv; do
    [ ! -e "$left" ] || [ -e "${left%.*}.c" ] || complain "$left has no program"
done
for chart in figures/[0-9]*/*.svg; do
    [ -e "${chart%.svg}.gp" ] || complain "$chart has no .gp"
    [ ! -e "${chart%.svg}.png" ] || complain "${chart%.svg}.png: it is a chart now, $chart"
done
[ -z "$failed" ]
