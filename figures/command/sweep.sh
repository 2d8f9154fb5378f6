#!/bin/sh
# sweep.sh - runs the rows of a sweep through GNU Parallel, and puts what they
# print together in the order of the rows.  `tumble --sweep` becomes it, and `make
# hard` calls it:
#   AGAIN FOLDER ROWS JOBLOG CSV JOBS HOSTS COMMAND [WORD ...]
# `COMMAND WORD ... 7` prints the line of row 7, which begins with 7, and remarks,
# which begin with #: they go to FOLDER/7, and what it says on stderr to
# FOLDER/7.err, to be seen at the end.  FOLDER holds the head of the table.
# ROWS is how many there are, or their numbers, with a space after the last.
# AGAIN says how to go on when it was stopped.  CSV, JOBS and HOSTS may be empty.
# Hosts must see FOLDER, that of the call and the command under the same names.

again=$1 folder=$2 rows=$3 joblog=$4 csv=$5 jobs=$6 hosts=$7
shift 7
name=$(basename "$1")

numbers() { case $rows in *[!0-9]*) printf '%s\n' $rows ;; *) seq "$rows" ;; esac; }
fail() { echo "$name: $1" >&2; exit "${2:-1}"; }

# Another program is called parallel, too.
parallel --version 2> /dev/null | grep -q '^GNU parallel' ||
    fail "a sweep needs GNU Parallel, which is not here (make deps-dev installs it); $again"

# Parallel is asked to begin no more rows before it is told to end those that run:
# a row that TERM catches being begun would go on without it, and hold the folder.
stop() {
    kill -HUP $!; sleep 0.2
    kill -TERM $! 2> /dev/null; sleep 0.2; kill -TERM $! 2> /dev/null
    wait $!; fail "the sweep is stopped; $again" "$1"
}
trap 'stop 129' HUP
trap 'stop 130' INT
trap 'stop 143' TERM

# The rows run under sh, also where the environment names another shell or none.
SHELL=/bin/sh PARALLEL_SHELL=/bin/sh
export SHELL PARALLEL_SHELL

[ -z "$hosts" ] || set -- --sshloginfile "$hosts" --workdir "$PWD" "$@"
[ -z "$jobs" ] || set -- --jobs "$jobs" "$@"
numbers | parallel --quote --joblog "$joblog" --resume-failed --results "$folder/{}" "$@" > /dev/null &
wait $! || {
    cat "$folder"/*.err 2> /dev/null | sort -u | head -n 5 >&2
    fail "some rows failed, see the column Exitval of $joblog; $again"
}

# A line a row, each with its number.
(cd "$folder" && numbers | xargs cat) > "$folder/lines" &&
    awk -F , '!/^#/ { print $1 }' "$folder/lines" > "$folder/found" &&
    numbers | cmp -s - "$folder/found" ||
    fail "$folder: the lines of the rows are not whole"
(cd "$folder" && numbers | sed 's/$/.err/' | xargs cat) >&2
if [ -n "$csv" ]; then cat "$folder/head" "$folder/lines" > "$csv"
else cat "$folder/head" "$folder/lines"; fi || fail "the table cannot be written; $again"
rm -r "$folder"
[ -z "$csv" ] || echo "wrote $csv: $(numbers | wc -l) rows"
