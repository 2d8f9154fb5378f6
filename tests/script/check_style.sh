# check_style.sh - is the book in plain English (chapters/style.awk)?
#
#   sh tests/script/check_style.sh [page.md ...]
#
# Without pages: README, and all chapters and exercises but those of LATER,
# which are not yet rewritten.  The list must only become shorter.

# A chapter a line, for merging.
LATER="
"
LATER_EXERCISES="
"
LATER_PAGES=""

export LC_ALL=C
page=$(mktemp)
trap 'rm -f "$page"' EXIT
failed=

# The check itself is shown each fault first.
{
    echo "It met a wall, who was nailed. The reader, who is patient, may go on."
    echo
    echo "One two three four five six seven eight nine ten one two three four five six seven eight nine ten one two three"
    echo "four five six seven eight nine ten one two three four five six seven eight nine ten one two three four five six."
    echo
    echo "Sweep and prune is \"dear\", and \`whoever\` is code. \$\`x\`\$ is not."
    printf '```\nwhoever\n```\n'
} > "$page"
said=$(awk -f chapters/style.awk "$page" | sed 's/.*:\([0-9]*: [^:]*\):.*/\1/' | sort)
[ "$said" = '1: "nailed" (pinned; static)
1: who, for a thing or without a noun
3: 46 words' ] || { echo "style.awk does not see what it should, but: $said"; failed=1; }

listed() { case " $(echo $2) " in *" $1 "*) ;; *) false ;; esac; }
chosen() {
    for p in README.md exercises/README.md figures/README.md figures/command/README.md lib/README.md; do listed $p "$LATER_PAGES" || echo $p; done
    for p in chapters/[0-9]*.md; do
        n=${p#chapters/}; listed "${n%%-*}" "$LATER" || echo "$p"
    done
    for p in exercises/*/README.md exercises/*/hints; do
        n=${p#exercises/}; listed "x${n%%-*}" "$LATER_EXERCISES" || echo "$p"
    done
}
[ $# -gt 0 ] || set -- $(chosen)
if awk -f chapters/style.awk "$@"; then
    echo "style: $# pages, and no sentence is too long or speaks our private tongue"
else failed=1; fi
[ -z "$failed" ]
