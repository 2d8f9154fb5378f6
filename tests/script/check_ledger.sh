# check_ledger.sh - has each tuned number of lib/ a unit and a reason, and are
# they no more than they were?   sh tests/script/check_ledger.sh

# The list must only become shorter.
MOST=79

export LC_ALL=C
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failed=
numbers() { awk -f tests/ledger/numbers.awk "$@"; }
complain() { echo "ledger: $1"; failed=1; }

# The reader itself is shown each fault first.
refuses() {
    printf '%b\n' "$2" > "$work/a.c"
    numbers "$work/a.c" > /dev/null 2>&1 && complain "does not see $1"
}
refuses 'a number without a reason' 'int a;\n\nstatic const real A = 2;   // tuned, m'
refuses 'one without a name' '// Why.\n    return 2;   // tuned, m'
refuses 'two on a line' '// Why.\nstatic const real A = 2, B = 3;   // tuned, m'
printf '// Why: this\n// is so.\nenum { A = 2 };   // tuned, rad: more\nstatic const real B = 1e-3; // tuned, 1\n' > "$work/a.c"
[ "$(numbers "$work/a.c" | cut -f3-)" = "$(printf 'A\t2\trad\tWhy: this is so. (more)\nB\t1e-3\t1\tWhy: this is so.')" ] ||
    complain 'reads a sound line wrongly'

numbers lib/*/*.[ch] > "$work/all" || failed=1
count=$(wc -l < "$work/all")
[ "$count" -le $MOST ] || complain "$count numbers, where $MOST were enough"
twice=$(awk -F '\t' '{ print $1 " " $3 }' "$work/all" | sort | uniq -d)
[ -z "$twice" ] || complain "two of one name: $twice"
[ -z "$failed" ] && echo "ledger: $count numbers, each with a unit and a reason"
