# spell.sh - the words of these pages that neither an English dictionary nor
# chapters/words.txt knows, each with its place.   sh chapters/spell.sh page ...
# Fails if there are any; without aspell it says so and passes.

command -v aspell > /dev/null && aspell dump dicts | grep -qx en_GB || {
    echo "spelling is not checked: there is no aspell with English (make deps installs it)"
    exit 0
}
prose=$(mktemp) || exit 1
trap 'rm -f "$prose"' EXIT
unknown() { aspell list --lang=en_GB --encoding=utf-8; }

# Twice: the second time without an 's.
awk -f chapters/prose.awk "$@" > "$prose"
words=$(unknown < "$prose" | sed "s/'s\$//" | unknown | sort -u | awk '
    FILENAME == "chapters/words.txt" { if ($1 != "#") known[$1]; next }
    length > 2 && !($0 in known) && !(tolower(substr($0, 1, 1)) substr($0, 2) in known)
' chapters/words.txt -)
for word in $words; do
    place=$(grep -nwF -- "$word" "$@" /dev/null | sed 's/^\([^:]*:[0-9]*\):.*/\1/; q')
    echo "$place: is $word spelt so?  If it is: chapters/words.txt"
done
[ -z "$words" ] && echo "spelling: $(wc -w < "$prose") words of $# pages, and none is unknown"
