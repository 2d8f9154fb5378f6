# check_readme.sh - do the links of README and of the folders' pages lead somewhere,
# do their tables name each chapter and module, is the moving picture one, and is
# every command there that they, a chapter or make's own help name?

unset MAKEFLAGS MFLAGS      # a make that called us must not hand down its own
failed=
fault() { echo "$1"; failed=1; }

links=0 folders='exercises/README.md figures/README.md figures/command/README.md lib/README.md'
for page in README.md $folders; do
    for link in $(grep -o '](\([^)]*\))' $page | sed 's/^](//; s/)$//; s/#.*//' | sort -u); do
        links=$((links + 1))
        case $link in http*) ;; *) [ -e "$(dirname $page)/$link" ] || fault "$page links to $link, which is not there" ;; esac
    done
done

# A WebP says so at its beginning, and in its first lines that it is animated.
moving=figures/moving/moving.webp
head -c 64 $moving | tr -d '\0\n' | LC_ALL=C grep -aq 'RIFF.*WEBP.*ANIM' || fault "$moving does not move"
[ "$(wc -c < $moving)" -lt 2000000 ] || fault "$moving has more than 2 MB"

# Goals are the words after make, up to two blanks, that are no variables and no
# files: in the help, in blocks of commands, and between backticks.  (Pages are
# not for echo, which may take the \c of a formula for their end.)
known=$(make -pn help 2> /dev/null | sed -n 's/^\([a-z0-9][a-z0-9_-]*\):.*/\1/p')
pages() { cat README.md $folders chapters/[0-9]*.md; }
goals=$({ make -s help | grep -o '^  make [a-z0-9][a-z0-9_ /-]*'
    pages | awk '/^```/ { inside = !inside && /```sh$/ } inside' | grep -o '^make [a-z0-9][a-z0-9_ /-]*'
    pages | grep -o '`make [a-z0-9][a-z0-9_ /-]*'
} | sed 's/^ *`*make //; s/  .*//' | tr ' ' '\n' | grep . | grep -v / | sort -u)
for goal in $goals; do
    echo "$known" | grep -qx "$goal" || fault "there is no command  make $goal"
done

# README's table: every chapter by its title; that of lib/: every module in its row.
for page in chapters/[0-9]*.md; do
    title=$(sed -n '1s/^# [0-9]*[a-z]\{0,1\}\. //p' "$page")
    grep -qF "[$title](chapters/woven/${page#*/})" README.md || fault "README.md does not call $page by its title, $title"
done
for module in $(sed -n '/^define ORDER/,/^endef/p' Makefile | grep /); do
    grep "^| ${module%/*} |" lib/README.md | grep -qF "\`${module#*/}\`" ||
        fault "lib/README.md does not name the module ${module#*/} beside chapter ${module%/*}"
done

# Its numbers are those of the tables.
fresh=$(mktemp)
awk -f chapters/numbers.awk -f chapters/readme.awk README.md > "$fresh" || failed=1
cmp -s "$fresh" README.md || { fault "README.md has other numbers than its tables: run make book"; diff "$fresh" README.md | head -n 4; }
rm -f "$fresh"

version=$(sed -n 's/^#define TUMBLE_VERSION "\(.*\)"/\1/p' lib/tumble.h)
grep -qF "{Version $version, commit" README.md || fault "README.md cites another version than $version"

[ -z "$failed" ] && echo "README: $links links, $(echo "$goals" | wc -l) commands, all there"
