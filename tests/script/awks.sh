# awks.sh - prints which awks there are, each once: awk itself is often one of the others.
seen=
for awk in awk mawk gawk; do
    at=$(readlink -f "$(command -v $awk)" 2> /dev/null) && [ -n "$at" ] || continue
    case " $seen " in *" $at "*) continue ;; esac
    seen="$seen $at"
    echo $awk
done
