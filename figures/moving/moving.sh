# moving.sh - a moving picture: the frames of a program, 25 a second, the last one
# held.   sh figures/moving/moving.sh PROGRAM FILE.webp [SCENE QUALITY]

command -v img2webp > /dev/null || {
    echo "  $2 is left as it was: there is no img2webp (make deps-book installs it)"
    exit 0
}
frames=$(mktemp -d) || exit 1
trap 'rm -rf "$frames" "$2.part"' EXIT
case $2 in *-dark.webp) export TUMBLE_DARK=1 ;; esac    # for dark paper
"$1" "$frames" $3 || exit 1
for last in "$frames"/frame-*.png; do :; done
mv "$last" "$frames/last.png"

# Every frame whole (kmax 1): differences leave ghosts.
img2webp -loop 0 -kmin 0 -kmax 1 -lossy -q "${4:-75}" -m 6 -d 40 "$frames"/frame-*.png \
    -d 1600 "$frames/last.png" -o "$2.part" > "$frames/said" 2>&1 &&
    mv "$2.part" "$2" || { cat "$frames/said"; exit 1; }
[ "$2" != figures/moving/moving.webp ] || sh figures/draw/stamp.sh moving
