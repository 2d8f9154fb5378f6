# meant.sh - a command that there is none of: which one was meant?
# Called by make, with the command and the numbers of the chapters.

export LC_ALL=C
given=$1; shift
what=${given%%[0-9]*} number=${given#"${given%%[0-9]*}"}
for last in "$@"; do :; done

case $given in
[0-9][0-9]/*) meant="exercise $given" ;;
*/*)    meant= ;;
lib)    meant=library ;;
chapters) meant=book ;;
[0-9] | test-[0-9] | figure-[0-9])
    meant=${what}0$number ;;
figure-[0-9]*-*)
    chapter=${number%%-*}
    have=$(cd figures && ls "$chapter"/*.c 2> /dev/null | sed 's|.*/|figure-|; s/\.c$//' | paste -s -d ' ' -)
    echo "There is no figure $number: ${have:-chapter $chapter has none.}" >&2
    exit 1 ;;
[0-9]* | test-[0-9]* | figure-[0-9]*)
    echo "There is no chapter $number: there are $1 to $last." >&2
    exit 1 ;;
*)  # The nearest name of make's own help: so many letters put in, left out or changed.
    meant=$(make -s help | sed -n 's/^  make \([a-z][a-z-]*\)\( .*\)\{0,1\}$/\1/p' | awk -v given="$given" '
        function least(a, b) { return a < b ? a : b }
        {
            for (j = 0; j <= length($0); j++) row[j] = j
            for (i = 1; i <= length(given); i++) {
                slant = row[0]; row[0] = i
                for (j = 1; j <= length($0); j++) {
                    changed = slant + (substr(given, i, 1) != substr($0, j, 1))
                    slant = row[j]
                    row[j] = least(changed, 1 + least(row[j], row[j - 1]))
                }
            }
            if (best == "" || row[length($0)] < best) { best = row[length($0)]; name = $0 }
        }
        END { if (best <= 2 && best < length(given)) print name }') ;;
esac
if [ -n "$meant" ]
then echo "There is no command  make $given; did you mean  make $meant?" >&2
else echo "There is no command and no file $given: make help lists the commands." >&2
fi
exit 1
