# lines.awk - is a stage's program in form?  Prints what is not:
#   awk -v most=900 -f lines.awk stage-07b.c
length($0) > 80 { say(FNR ": a line of " length($0) " columns") }
/^[a-z].*[^;]$/ && !/^(typedef|enum|struct|static.*=)/ { from = FNR; what = $0 }
/^}$/ && from { if (FNR - from + 1 > 30) say(from ": a function of " FNR - from + 1 " lines: " what); from = 0 }
END { if (NR > most) say("the program has " NR " lines, and may have " most); exit bad }
function say(why) { print "  " FILENAME ":" why; bad = 1 }
