# measured.awk - what stages print, NAME VALUE UNIT, as CSV: stage and name, value,
# unit.   awk -f measured.awk printed.txt
/^= / { stage = $2; next }
{ name = $0; sub(/ +[^ ]+ +[^ ]+$/, "", name); gsub(/,/, "", name); print stage " " name "," $(NF - 1) "," $NF }
