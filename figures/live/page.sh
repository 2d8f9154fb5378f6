# page.sh - a page of a chapter's live figures alone, beside their scripts.
# page.sh CHAPTER FOLDER FIGURE...: writes FOLDER/CHAPTER.html.

chapter=$1 folder=$2
shift 2
# The caption of a figure, from the picture's line in the chapter.
caption() {
    sed -n "s|^!\[\(.*\)\](../figures/live/$1.webp)\$|\1|p" chapters/"$chapter"-*.md | head -n 1
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
        printf '<figure data-live="%s"><figcaption>%s</figcaption></figure>\n' "$figure" "$(caption "$figure")"
    done
    printf '<script src="live.js"></script>\n'
} > "$folder/$chapter.html"
