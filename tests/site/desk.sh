# desk.sh - what the desk says of some answers to an exercise, for check_workshop.mjs:
#   sh tests/site/desk.sh NN/name FOLDER NUMBER...
# FOLDER/NUMBER/mine.c is an answer; what `make exercise` would say of it goes to
# FOLDER/NUMBER/told.

name=$1 folder=$2
shift 2
. exercises/judge.sh
load "$name" && prepare "$(library_parts; test_parts)" || exit 1
alone "$out" || { echo "$name is being judged by another command" >&2; exit 1; }
trap 'leave_it "$out"' EXIT
for number in "$@"; do
    compile "$folder/$number/mine.c" 2> /dev/null && judge_fairly "$folder/$number/mine.c" > "$folder/$number/told" 2>&1
done
exit 0
