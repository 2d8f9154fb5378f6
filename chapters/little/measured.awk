# measured.awk - a stage's printed lines, NAME VALUE UNIT, as CSV: stage and name,
# value, unit.   awk -v stage=01b -f measured.awk printed.txt
{ name = $0; sub(/ +[^ ]+ +[^ ]+$/, "", name); gsub(/,/, "", name); print stage " " name "," $(NF - 1) "," $NF }
