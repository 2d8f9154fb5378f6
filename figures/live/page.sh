# page.sh - a folder with a page of some live figures of a chapter, and all that
# it needs.
# page.sh CHAPTER FOLDER COMMON OWN FIGURE...: writes FOLDER/index.html.  COMMON
# has the scripts and panels, OWN the figures' WebAssembly; or COMMON is film, and
# OWN has the figures' programs, which make films.

chapter=$1 folder=$2 common=$3 own=$4
shift 4
mkdir -p "$folder"

panels() {
    echo '(window.tumble||={}).panels={'
    for figure in "$@"; do printf '%s:%s,' "$figure" "$(cat "$common/$figure.json")"; done
    echo '};'
}
if [ "$common" != film ]; then
    { panels "$@"; cat "$common/main.js"; } > "$folder/live.js"
    cp "$common/space.js" "$folder"
    for figure in "$@"; do cp "$own/$figure.js" "$folder"; done
fi

# The caption of a figure, from the picture's line in the chapter.
caption() {
    cat chapters/"$chapter"*.md | sed -n "s|^!\[\(.*\)\](../figures/live/$1.webp)\$|\1|p" | head -n 1
}
{
    cat <<'HEAD'
<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<style>
:root { color-scheme: light dark; }
body { max-width: 760px; margin: 2em auto; padding: 0 14px; background: #fffefb; color: #22252a; font: 17px/1.55 Georgia, "DejaVu Serif", serif; }
@media (prefers-color-scheme: dark) { body { background: #16181c; color: #e4e2dc; } }
</style>
HEAD
    title=$(sed -n '1s/^# //p' chapters/"$chapter"-*.md)
    printf '<title>%s</title>\n<h1>%s</h1>\n' "$title" "$title"
    for figure in "$@"; do
        printf '<figure data-live="%s">' "$figure"
        [ "$common" != film ] || "$own/$figure" --film
        printf '<figcaption>%s</figcaption></figure>\n' "$(caption "$figure")"
    done
    if [ "$common" = film ]; then
        echo '<p>Films of two seconds. With clang for WebAssembly and npm (<code>make deps-site</code>) the figures run here, and their dials turn.</p>'
    else
        echo '<script src="live.js"></script>'
    fi
} > "$folder/index.html"
