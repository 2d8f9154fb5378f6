# dark.sh - a painting once more, for a page with dark paper:
#   sh figures/draw/dark.sh PROGRAM PICTURE.png    writes PICTURE-dark.webp

command -v cwebp > /dev/null || {
    echo "  ${2%.png}-dark.webp is left as it was: there is no cwebp (make deps-book installs it)"
    exit 0
}
part=$(mktemp -d) || exit 1
trap 'rm -rf "$part"' EXIT
TUMBLE_DARK=1 "$1" "$part/dark.png" > /dev/null || exit 1
wide=$(od -An -tu1 -j18 -N2 "$part/dark.png" | awk '{ print 256 * $1 + $2 }')
[ "$wide" -gt 1472 ] && shrink='-resize 1472 0'
cwebp -quiet -preset drawing -q 75 -m 6 $shrink "$part/dark.png" -o "${2%.png}-dark.webp"
