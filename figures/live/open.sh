# open.sh - shows a page, or says where it is.

page=file://$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
echo "$page"
[ -n "$DISPLAY$WAYLAND_DISPLAY" ] && command -v xdg-open > /dev/null && xdg-open "$page" > /dev/null 2>&1 && exit
[ "$(uname)" = Darwin ] && open "$page" && exit
echo "Open this address in a browser."
