# pages.awk - on which page of a PDF is what its links lead to?  Prints a name and a page
# a line.  All but what the pages show is plain text in what Chromium writes:
#   LC_ALL=C grep -aE '^[0-9]+ 0 obj|/Kids \[|/Pages [0-9]|/XYZ' FILE.pdf | awk -f pages.awk

/^[0-9]+ 0 obj/ { object = $1 }
/\/Kids \[/ { sub(/.*\/Kids \[/, ""); sub(/\].*/, ""); gsub(/ 0 R/, ""); kids[object] = $0 }
/\/Pages [0-9]/ { sub(/.*\/Pages /, ""); root = $1 }
/^(<<)?\/[^ ]* \[[0-9]+ 0 R \/XYZ/ {
    sub(/^(<<)?\//, "")
    name = $1
    sub(/^[^[]*\[/, "")
    of[++n] = name
    at[n] = $1
}
# Pages are the leaves of a tree.
function walk(node,    k, count, list) {
    if (!(node in kids)) { number[node] = ++pages; return }
    count = split(kids[node], list, " ")
    for (k = 1; k <= count; k++) walk(list[k])
}
END {
    walk(root)
    for (k = 1; k <= n; k++) print of[k], number[at[k]]
}
