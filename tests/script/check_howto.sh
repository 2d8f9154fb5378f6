# check_howto.sh - does each program of chapter 19b print what the chapter says, and
# is none of them missing there?  A block of text follows `build/PROGRAM` prints:.
# (check_install.sh builds them against an installed library.)

page=chapters/19b-howto.md
BUILD=${BUILD:-build} BUILD=${BUILD%/swapped}
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
failed= programs=0

# Lines: the command, and behind a tab a line that it prints.
awk '/^`build\/[a-z ]*` prints:$/ { split($0, part, "`"); command = part[2]; next }
     /^```text$/ && command != "" { inside = 1; next }
     /^```/ { if (inside) command = ""; inside = 0; next }
     inside { print command "\t" $0 }' "$page" > "$place/said"
cut -f 1 "$place/said" | uniq > "$place/commands"
while read -r command; do
    programs=$((programs + 1))
    awk -F '\t' -v c="$command" '$1 == c { print $2 }' "$place/said" > "$place/wanted"
    # shellcheck disable=SC2086
    "$BUILD/"${command#build/} > "$place/got" 2>&1 && cmp -s "$place/wanted" "$place/got" && continue
    diff "$place/wanted" "$place/got"
    echo "check_howto: $command fails, or prints something else than chapter 19b says"
    failed=1
done < "$place/commands"
for f in figures/manual/*.c; do
    grep -qx "@@ $(basename "$f" .c)" "$page" && grep -q "build/.*$(basename "$f" .c)\$" "$place/commands" ||
        { echo "check_howto: chapter 19b does not show $f, or what it prints"; failed=1; }
done
echo "how to: $programs programs, each prints what chapter 19b says"
[ -z "$failed" ]
