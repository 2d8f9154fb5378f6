# products.awk - the figures and tables, of a list of what is there: a line each,
# NAME PROGRAMS DATA DRAWN FROM FILE PICTURE COMMAND.  Its programs' own sources,
# the data that they write, what a chart is drawn from, and what a table is
# gathered from stand between commas, - for none; blanks of a command are ~.
{
    folder = $0; sub(/\/[^\/]*$/, "", folder); name = $0; sub(/.*\//, "", name)
    kind = name; sub(/.*\./, "", kind); sub(/\.[a-z0-9]*$/, "", name)
    there[$0] = 1
    if (folder ~ /^figures\/[0-9]/) {
        if (kind == "c" || (kind == "gp" && !(name in room))) add(name, folder)
    } else if (folder ~ /^figures\/(tables|peers)$/ && kind == "csv" && name !~ /^(machine|stages|piles-curves|(box3d|jolt)-[a-z]*)$/) add(name, folder)
    else if (folder ~ /^tests\// && kind == "c") test[name] = $0
}
END {
    add("moving", "figures/moving")
    for (i = 1; i <= n; i++) print_line(order[i], room[order[i]])
}
function add(name, folder) { if (!(name in room)) { order[++n] = name; room[name] = folder } }
# Those of these files that are there.
function those(list,    part, i, m, out) {
    m = split(list, part, " ")
    for (i = 1; i <= m; i++) if (part[i] in there) out = out (out == "" ? "" : ",") part[i]
    return out == "" ? "-" : out
}
function print_line(name, folder,    own, program, data, drawn, from, picture, command, part, i, m) {
    own = folder "/" name; data = those(own ".csv " own "-curves.csv " own "-times.csv " own "-default.csv " own "-cloth.csv " own "-machine.csv"); from = drawn = picture = "-"
    program = those(own ".c " own ".cpp " own ".edits " own ".sh"); command = "figure-" name
    if (those(own ".gp") != "-") {
        picture = own ".svg"
        drawn = those(own ".gp " (those(own "-curves.csv") != "-" ? own "-curves.csv" : own ".csv") " figures/draw/chart.awk figures/draw/chart.gp figures/draw/chart.sh")
        if (program == "-") command = "chart-" name
    } else if (folder ~ /\/[0-9]/) picture = own ".png"
    if (name == "moving") { picture = own ".webp"; command = "moving" }
    if (folder == "figures/tables") { program = (name == "hard-plain" ? test["plain"] : name == "ledger" ? test["battery"] : test[name]); command = name == "ledger" ? name : "hard" }
    if (folder == "figures/peers") command = name == "piles" ? "peers" : name == "box3d" ? "box3d~BOX3D=FOLDER" : name == "jolt" ? "jolt~JOLT=FOLDER" : name == "queries" ? "queries-race~GJK=FOLDER~JOLT=FOLDER~BOX3D=FOLDER" : name
    if (name == "speed" || name == "profile") {
        m = split(name == "speed" ? speed : "21-profile", part, " "); list = ""
        for (i = 1; i <= m; i++) list = list " figures/" substr(part[i], 1, index(part[i], "-") - 1) "/" part[i] ".csv"
        from = those(list); program = "figures/draw/table.awk"; command = "tables"
    }
    if (name == "20-margins") from = "figures/tables/hard.csv"
    if (program == "") program = "-"
    print name, program, data, drawn, from, (data == "-" ? picture : substr(data ",", 1, index(data ",", ",") - 1)), picture, command
}
