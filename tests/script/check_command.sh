# check_command.sh - runs the command `tumble` over good and bad command lines
# and looks at what it says, its exit status, and the files that it leaves.
# The command is $1, or $TUMBLE, or build/tumble.

tumble=${1:-${TUMBLE:-build/tumble}}
case $tumble in /*) ;; *) tumble=$PWD/$tumble ;; esac
data=$(cd "$(dirname "$0")/../data" && pwd) || exit 1
[ -x "$tumble" ] || { echo "check_command: there is no $tumble" >&2; exit 1; }

checks=0 failures=0
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder" "$folder.out" "$folder.err"' EXIT
cd "$folder" || exit 1

# verdict NAME WHY: counts a check; it failed if WHY is not empty.
verdict() {
    checks=$((checks + 1))
    [ -z "$2" ] && return
    failures=$((failures + 1))
    echo "check_command: $1: $2"
}

# run ARGUMENTS: the exit status is in $code, what it wrote in $out and $err,
# which lie outside the folder that is searched for left-over files.
out=$folder.out err=$folder.err
run() {
    "$tumble" "$@" > "$out" 2> "$err" < /dev/null
    code=$?
}

# refuses STATUS WORDS ARGUMENTS: ends with that status and one line on stderr
# that has these words, prints nothing else, and leaves no file.
# Rejects: a crash (139), a second sentence, half a file.
refuses() {
    want=$1 words=$2 why=
    shift 2
    before=$(ls -A)
    run "$@"
    [ $code -eq "$want" ] || why="exit status $code, not $want"
    [ "$(wc -l < "$err")" -eq 1 ] || why="not one line on stderr: $(cat "$err")"
    grep -q -- "$words" "$err" || why="says \"$(cat "$err")\", not \"$words\""
    [ -s "$out" ] && why="prints on stdout"
    [ "$(ls -A)" = "$before" ] || why="leaves $(ls -A | tr '\n' ' ')"
    verdict "tumble $*" "$why"
}

# accepts WORDS ARGUMENTS: ends well, silent on stderr, with these words.
accepts() {
    words=$1 why=
    shift
    run "$@"
    grep -q -- "$words" "$out" || why="does not print \"$words\""
    [ $code -eq 0 ] || why="exit status $code: $(cat "$err")"
    [ -s "$err" ] && why="status $code, says \"$(cat "$err")\""
    verdict "tumble $*" "$why"
}

# --- The command line is wrong: 2 ---------------------------------------------
refuses 2 'no scene is named; there are room.* cloth-on-rope.* pyramid.* blanket.* and cape'
refuses 2 'no scene is named'               --bodies 3
refuses 2 'did you mean room'               rom
refuses 2 'there is no scene "waterfall" (see'  waterfall
refuses 2 'did you mean pyramid'            piramid
refuses 2 'pyramid stands first'            --seconds 2 pyramid
refuses 2 'there is no scene ""'            ''
refuses 2 'two scenes are named'            room cloth-on-cube
refuses 2 'no option --bodys; did you mean --bodies' room --bodys 3
refuses 2 'no option -x'                    room -x
refuses 2 'no option --'                    room --
refuses 2 'no option --frobnicate'          --frobnicate
refuses 2 '--bits takes no value'           room --bits=1
refuses 2 'one at a time'                   room --plain --paper
for option in '--threads 2' '--hertz 30' '--stay 0' '--restitution 1' \
              '--most-substeps 9' '--sleep-speed 0' '--time-to-sleep 1' \
              --no-warm-start; do
    refuses 2 "${option% *} is the engine"  room --plain $option
done
refuses 2 '--no-warm-start takes no value'  room --no-warm-start=1
refuses 2 '--threads 65: must lie between 1 and 64' room --threads 65
for option in bodies cloth seconds dt substeps iterations tolerance gravity \
              friction restitution hertz stay most-substeps sleep-speed \
              time-to-sleep threads seed mesh film frames csv obj every \
              record replay; do
    refuses 2 "--$option needs a value"     room --$option
    refuses 2 "--$option needs a value"     room --$option --bits
done
refuses 2 '--film: the name is empty'       room --film ''
refuses 2 '--csv is given twice'            room --csv a --csv b
refuses 2 '--seed is given twice'           room --seed=1 --bodies 2 --seed 1
refuses 2 '--film is given twice'           pyramid --film a.png --film b.png
refuses 2 '--csv: the name is empty'        room --csv=
for option in bodies cloth substeps iterations most-substeps threads; do
    for number in ten 3x 1.5 1e3 '' ' 3' nan 0x10; do
        refuses 2 "--$option .*not a whole number" room --$option="$number"
    done
    for number in 0 -1 1000000 99999999999999999999 -99999999999999999999; do
        refuses 2 "--$option $number: must lie between" room --$option=$number
    done
done
for option in seconds dt tolerance gravity friction restitution hertz stay \
              sleep-speed time-to-sleep every; do
    for number in ten 3x '' ' 3' 1/x 1//2 1/-2 1/2/3; do
        refuses 2 "--$option .*not a number" room --$option="$number"
    done
    for number in nan NaN -nan inf -inf infinity 1e999 1/0 0/0; do
        refuses 2 "--$option $number: not a finite" room --$option=$number
    done
    for number in -1 -1e-9 1e10; do
        refuses 2 "--$option $number: must lie between" room --$option=$number
    done
done
refuses 2 '--dt 0: must lie between'        room --dt 0
refuses 2 '--dt 1.01: must lie between'     room --dt 1.01
refuses 2 'the most is 1e7'                 room --dt 1e-9 --seconds 10
for number in -1 ten 1.5 '' +1 ' 1'; do
    refuses 2 '--seed .*not a whole number' room --seed="$number"
done
refuses 2 'larger than 2^64'                room --seed 18446744073709551616

# --- Files that cannot be: 1, before the first step ---------------------------
# 100000 s would take hours: who answers at once has not begun.
long='--seconds 100000'
mkdir folder
echo old > plain
: > folder/inside
refuses 1 'none/x.png: cannot write: No such'   room $long --film none/x.png
refuses 1 'none/x.csv: cannot write: No such'   room $long --csv none/x.csv
refuses 1 'folder: cannot write: it is a folder' room $long --film folder
refuses 1 'folder: cannot write: it is a folder' room $long --csv folder
refuses 1 'plain/x.csv: cannot write: Not a dir' room $long --csv plain/x.csv
refuses 1 'none/x: cannot make this folder'     room $long --frames none/x
refuses 1 'plain: is not a folder'              room $long --frames plain
refuses 1 'none.obj: cannot be opened'          room $long --mesh none.obj
refuses 1 'folder'                              room $long --mesh folder
ln -s folder/inside through
for name in plain ./plain folder/../plain "$folder/plain" new; do
    refuses 1 'name the same file'  room $long --film ${name##*/} --csv "$name"
done
refuses 1 'name the same file'      room $long --film through --csv folder/inside
rm through
# What is being written stands in x.part, so x.part is no name for another file.
refuses 1 'name the same file'      room $long --csv x --film x.part
refuses 1 'name the same file'      room $long --film ./x --csv x.part
# A picture is a PNG, whatever it is called.
refuses 1 'its name ends in .png'   room $long --film a.jpg
refuses 1 'its name ends in .png'   marbles --seconds 3600 --film a.jpg
mkdir frames
refuses 1 'name of a frame'  room $long --frames frames --csv frames/frame-00000.png
refuses 1 'name of a frame'  room $long --frames frames --film ./frames/../frames/frame-x
ln -s ../plain frames/frame-00000.png
refuses 1 'is a link'        room --bodies 1 --seconds 0 --frames frames
rm -r frames
# A folder made for the frames goes again if the scene cannot be built.
refuses 1 'none.obj'   room $long --mesh none.obj --frames made
refuses 1 'none.obj'   room $long --mesh none.obj --csv plain
verdict 'a refused run leaves the old file' \
    "$([ "$(cat plain)" = old ] || echo it is gone)"
if [ "$(id -u)" -ne 0 ]; then
    mkdir locked && chmod 500 locked
    refuses 1 'locked/x.png: cannot write: Perm' room $long --film locked/x.png
    refuses 1 'cannot write: Perm'               room $long --frames locked
    : > readonly && chmod 400 readonly
    refuses 1 'readonly: cannot write: Perm'     room $long --csv readonly
fi
if [ -c /dev/full ]; then
    brief='--seconds 0.05 --bodies 2'
    refuses 1 '/dev/full: cannot write: No space' room $brief --csv /dev/full
    refuses 1 '/dev/full: cannot write: it is a device' room $long --film /dev/full
    refuses 1 '/dev/full: cannot write: it is a device' \
        marbles --seconds 3600 --film /dev/full
    accepts 'wrote /dev/null'  room $brief --film /dev/null
    "$tumble" room $brief > /dev/full 2> "$err"
    code=$?
    verdict 'a full disk behind stdout' "$([ $code -eq 1 ] &&
        grep -q 'standard output' "$err" || echo "exit status $code")"
fi

# A disk that fills up while rows are written: the file may grow to 1024 bytes.
if (trap '' XFSZ; ulimit -f 2) 2> /dev/null; then
    full() { (trap '' XFSZ; ulimit -f 2; exec "$real" "$@"); }
    real=$tumble tumble=full
    refuses 1 'big.csv: cannot write: File too large' \
        room --bodies 2 --seconds 5 --csv big.csv
    refuses 1 'big.png: cannot write: File too large' \
        room --bodies 2 --seconds 0 --csv small.csv --film big.png
    tumble=$real
fi

# --- Meshes -------------------------------------------------------------------
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n' > corners
cp corners good.obj
printf 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >> good.obj
cp good.obj good.was
# Steps of a second are more than the contacts bear, and that is said.
run room --dt 1
verdict 'a long step is named' "$([ $code -eq 0 ] && grep -q 'not converged' "$out" &&
    grep -q -- '--dt 1 is long' "$err" || echo "exit status $code")"
accepts ' 20 steps' room --dt 1/20 --seconds 1
accepts '1 body of good.obj' room --mesh good.obj --bodies 1 --seconds 0.1
{ cat corners; printf 'f 1 3 2\nf 1 2 4\nf 1 4 3\n'; } > open.obj
{ echo v 0 nan 0; cat good.obj; } > nan.obj
{ cat corners; printf 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 9\n'; } > range.obj
: > empty.obj
for mesh in open nan range empty; do
    refuses 1 "$mesh.obj" room $long --mesh $mesh.obj
done
# A needle: convex, but no solid for the engine.
printf 'v 0 0 0\nv 1 0 0\nv 0 1e-8 0\nv 0 0 1e-8\n' > thin.obj
printf 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >> thin.obj
refuses 1 'thin.obj: .*too thin to be solid' room $long --mesh thin.obj

# A pipe without a writer would wait for ever; a result would replace its mesh.
mkfifo pipe.obj
refuses 1 'pipe.obj: is not a regular file' room $long --mesh pipe.obj
ln -s good.obj link.obj
ln good.obj hard.obj
cp good.obj x.csv.part
for option in csv film; do
    refuses 1 "--mesh good.obj and --$option" \
        room $long --mesh good.obj --$option good.obj
    refuses 1 "--mesh good.obj and --$option" \
        room $long --mesh good.obj --$option ./link.obj
    refuses 1 "--mesh hard.obj and --$option" \
        room $long --mesh hard.obj --$option good.obj
    refuses 1 "--mesh x.csv.part and --$option" \
        room $long --mesh x.csv.part --$option x.csv
done
mkdir frames && cp good.obj frames/frame-00001.png
refuses 1 '--mesh .* has the name of a frame' \
    room $long --mesh frames/frame-00001.png --frames frames
verdict 'a mesh among frames is left alone' "$(cmp good.obj frames/frame-00001.png 2>&1)"
verdict 'a mesh that is named like a .part is left alone' "$(cmp good.obj x.csv.part 2>&1)"
rm -r frames hard.obj x.csv.part
verdict 'a mesh that is named twice is left alone' \
    "$(cmp good.obj good.was 2>&1)"

# The meshes of check_obj: these are convex, in every other one is a fault.
for mesh in "$data"/*.obj; do
    case $(basename "$mesh") in
    cube.obj | octahedron-inwards.obj | tetrahedron.obj)
        accepts '1 body' room --bodies 1 --seconds 0.1 --mesh "$mesh" ;;
    *) refuses 1 "$(basename "$mesh")" room $long --mesh "$mesh" ;;
    esac
done

# --- What it does well --------------------------------------------------------
accepts 'cloth-on-rope'     --list
accepts '--substeps N'      --list
accepts 'Exit status'       --help
accepts 'Exit status'       -h
accepts 'tumble wrecker .--seconds S. .--film FILE.png'  wrecker --help
accepts '^tumble [0-9]'     --version
accepts 'largest strain'    room --bodies 2 --seconds 0.1
accepts 'largest strain'    room --seconds 0
accepts 'a cloth of 8 x 8'  cloth-on-cube --cloth 8 --seconds 0.1 --substeps 2
accepts 'a cloth of 8 x 8'  cloth-on-rope --cloth=8 --seconds=0.1
accepts ' 6 steps of'       room --bodies 2 --seconds 0.1 --dt 1/60
accepts ' 100 steps of'     room --bodies 2 --seconds 1 --dt 0.01

# Every option of the table is in the help.
run --list
for option in bodies cloth seconds dt substeps iterations tolerance seed \
              gravity friction restitution hertz stay most-substeps \
              no-warm-start sleep-speed time-to-sleep threads mesh film frames \
              obj every record replay csv help list version bits plain paper; do
    verdict "--list names --$option" \
        "$(grep -q -- "^  --$option " "$out" || echo it does not)"
done

# The paper's system runs the same scenes, mended and as printed.
for scene in room cloth-on-cube cloth-on-rope; do
    accepts 'as mended'  $scene --plain --seconds 0.2
    accepts 'as printed' $scene --paper --seconds 0.2
    accepts '3 substeps, 2 rounds of 5 iterations' \
        $scene --plain --seconds 0.1 --substeps 3 --iterations 5
done
verdict '--plain has other bits than the engine' \
    "$([ "$("$tumble" room --seconds 0.1 --bits | tail -1)" != \
         "$("$tumble" room --seconds 0.1 --bits --plain | tail -1)" ] || echo no)"

# The same seed gives the same bits, another seed others.
bits() {
    case $1 in --bodies) ;; *) set -- --bodies 4 --seconds 0.5 "$@" ;; esac
    "$tumble" room --bits "$@" | sed -n 's/^bits //p'
}
first=$(bits --seed 7)
verdict 'bits are 16 hexadecimal digits' \
    "$(echo "$first" | grep -q '^[0-9a-f]\{16\}$' || echo "they are $first")"
verdict 'the same seed, the same bits' \
    "$([ "$first" = "$(bits --seed 7)" ] || echo they differ)"
verdict 'another seed, other bits' \
    "$([ "$first" != "$(bits --seed 8)" ] || echo they are the same)"

# So many that four threads have something to share.
many=$(bits --bodies 150 --seconds 0.3)
for threads in 1 2 3 4 64; do
    verdict "$threads threads, the same bits" \
        "$([ "$many" = "$(bits --bodies 150 --seconds 0.3 --threads $threads)" ] || echo they differ)"
done

# Every option of the engine's does something.
usual=$(bits --bodies 9 --seconds 1)
for option in '--gravity 1.6' '--friction 0' '--restitution 1' '--hertz 10' \
              '--stay 0' --no-warm-start '--substeps 6' '--dt 1/100'; do
    verdict "$option moves the bits" \
        "$([ "$usual" != "$(bits --bodies 9 --seconds 1 $option)" ] || echo it does not)"
done
verdict '--friction is obeyed by the plain system' \
    "$([ "$(bits --plain)" != "$(bits --plain --friction 0)" ] || echo no)"

verdict 'drawing and measuring leave the bits alone' \
    "$([ "$first" = "$(bits --seed 7 --csv r.csv --film film.png)" ] ||
        echo they do not)"

# A row for every step, over an old file; a strip; frames 30 a second.
echo old > rows.csv
accepts 'wrote rows.csv: 30 rows' room --bodies 2 --seconds 0.5 --csv rows.csv
verdict 'a head and 30 rows of 8 numbers' "$(awk -F, 'NF != 8 { bad = 1 }
    NR > 1 && $0 ~ /nan|inf|[g-z]/ { bad = 1 }
    END { if (bad || NR != 31) print NR " lines" }' rows.csv)"
accepts '2 frames' cloth-on-rope --cloth 6 --seconds 0.05 --every 1/30 --frames made
for picture in film.png made/frame-00000.png made/frame-00001.png; do
    verdict "$picture is a PNG" \
        "$(head -c 8 $picture | od -An -tx1 |
            grep -q '89 50 4e 47 0d 0a 1a 0a' || echo it is not)"
done
verdict 'nothing half written is left' "$(ls -A . made | grep part)"

# An option that the scene has no use for is said, not obeyed.
run cloth-on-cube --cloth 4 --seconds 0.05 --bodies 9
verdict 'an idle option is named' "$([ $code -eq 0 ] &&
    grep -q -- '--bodies means nothing' "$err" || echo "exit status $code")"

# --- OBJ ------------------------------------------------------------------------
# read_obj FILE: how many objects, vertices, faces, vertices on lines; then, of
# each object that is closed, its volume; or a fault: a corner that is no vertex
# of its own object, a number that is none, a line that the format does not have.
cat > read_obj.awk <<'END'
function fault(what) { print FILENAME ", line " FNR ": " what; bad = 1; exit }
function whole(c) { if (c !~ /^[0-9]+$/ || c <= before || c > v) fault("corner " c) }
function finish() { if (faces) volumes = volumes sprintf(" %.6f", volume / 6) }
$1 == "#" { next }
$1 == "o" { if (NF != 2 || $2 in seen) fault("object " $2)
            finish(); seen[$2]; objects++; before = v; faces = volume = 0; next }
$1 == "v" { if (NF != 4) fault(NF - 1 " numbers")
            for (k = 2; k <= 4; k++) if ($k !~ /^-?[0-9.]+(e[-+][0-9]+)?$/) fault($k)
            v++; x[v] = $2; y[v] = $3; z[v] = $4; next }
$1 == "f" { if (NF != 4) fault(NF - 1 " corners")
            for (k = 2; k <= 4; k++) whole($k)
            a = $2; b = $3; c = $4; f++; faces++
            volume += x[a] * (y[b] * z[c] - z[b] * y[c]) + y[a] * (z[b] * x[c] - x[b] * z[c]) \
                    + z[a] * (x[b] * y[c] - y[b] * x[c]); next }
$1 == "l" { for (k = 2; k <= NF; k++) whole($k); line += NF - 1; next }
{ fault("a line of " $1) }
END { if (!bad) { finish(); print objects, v, f + 0, line + 0 volumes } }
END
accepts 'wrote meshes/frame-00000.obj and on: 7 frames' \
    room --bodies 3 --seconds 0.1 --obj meshes
for frame in 0 6; do
    said=$(awk -f read_obj.awk meshes/frame-0000$frame.obj)
    verdict "frame $frame: three icosahedra of radius .5, seen from outside" \
        "$([ "$said" = '3 36 60 0 0.317019 0.317019 0.317019' ] || echo "$said")"
done
verdict 'and they move' "$(! cmp -s meshes/frame-00000.obj meshes/frame-00006.obj || echo they do not)"
accepts '3 frames' room --bodies 1 --seconds 0.5 --every 0.2 --obj meshes --mesh "$data/cube.obj"
said=$(awk -f read_obj.awk meshes/frame-00002.obj)
verdict 'a cube of radius .5' \
    "$([ "${said% *}" = '1 8 12 0' ] || echo "$said")"
accepts '2 frames' cloth-on-rope --cloth 8 --seconds 0.05 --every 1/30 --obj meshes
said=$(awk -f read_obj.awk meshes/frame-00001.obj)
verdict 'a rope is a line, a cloth has faces' \
    "$([ "${said% *}" = '2 115 98 51' ] || echo "$said")"
accepts '1 frame$' cloth-on-cube --plain --cloth 8 --seconds 0.01 --every 1 --obj meshes
verdict 'what is not asked for is not there' "$(ls meshes | grep -v '\.obj$')"
refuses 1 'plain: is not a folder' room $long --obj plain
refuses 1 'name of a frame'  room $long --obj meshes --csv meshes/frame-00000.obj
refuses 1 'name of a frame'  room $long --obj meshes --mesh meshes/frame-00000.obj

# --- Record and replay ----------------------------------------------------------
accepts 'wrote run' room --bodies 4 --seconds 2.5 --friction 0.3 --no-warm-start --record run
verdict 'the record has a hash every 60 steps and at the end' \
    "$([ "$(grep -v '^#' run | sed -n 's/^\([0-9]*\) [0-9a-f]\{16\}$/\1/p' | tr '\n' ' ')" = \
        '0 60 120 150 ' ] || cat run)"
accepts 'run: 4 hashes equal, to step 150'  --replay run
accepts '4 hashes equal'   --replay run --threads 2 --csv rows.csv --record again
verdict 'the record of a replay is the record' "$(grep -v '^#' run > was; grep -v '^#' again | cmp - was)"
verdict 'the last hash is that of --bits' \
    "$("$tumble" --replay run --bits | grep -q "$(sed -n 's/^150 /bits /p' run)" || echo no)"
# parts FILE STEP: says at which step, and fails.
parts() {
    run --replay "$1"
    verdict "$1 parts at step $2" "$([ $code -eq 1 ] &&
        grep -q "not that of $1: the hashes part at step $2" "$err" || echo "$code: $(cat "$err")")"
}
sed 's/^--seed=1$/--seed=2/' run > seed && parts seed '0$'
sed 's/^--no-warm-start$/--warm-start/' run > word
refuses 1 'word: there is no option --warm-start; did you mean --no-warm' --replay word
sed '/^--no-warm-start$/d' run > other && parts other '60, after step 0$'
sed 's/^120 ./120 g/' run > letter
refuses 1 'letter, line 11: not a hash' --replay letter
sed '/^120/s/$/0/' run > digit
refuses 1 'digit, line 11: not a hash' --replay digit
sed '/^120/s/ .*/ 0123456789abcdef/' run > hash && parts hash '120, after step 60$'
sed 's/^120/59/' run > order
refuses 1 'order, line 11: this step cannot' --replay order
sed 's/^150/151/' run > late
refuses 1 'late, line 12: this hash stands after the last' --replay late
grep -v '^[0-9]' run > none
refuses 1 'none, line 8: the file ends without a hash' --replay none
refuses 1 'nothing: cannot be opened' --replay nothing
refuses 1 'pipe.obj: is not a regular' --replay pipe.obj
refuses 1 '--replay run and --csv run' --replay run --csv run
refuses 2 '--bodies is said by the record' --replay run --bodies 4
refuses 2 'the scene is named by the record' room --replay run
cmp -s run again || accepts '4 hashes equal' --replay again

# --- Ctrl-C -------------------------------------------------------------------
# interrupts SIGNAL STATUS OPTIONS: stops, keeps the rows and pictures, says so.
# A shell starts what is in the background deaf to INT, so env opens its ears.
interrupts() {
    rm -f stop.csv stop.png
    signal=$1 want=$2
    shift 2
    env --default-signal=INT "$tumble" room --bodies 3 --seconds 90000 \
        --csv stop.csv "$@" > "$out" 2> "$err" &
    child=$!
    # Rows show that it runs; until then they are in stop.csv.part.
    tries=0
    until [ "$(cat stop.csv.part 2> /dev/null | wc -l)" -gt 20 ]; do
        tries=$((tries + 1))
        [ $tries -lt 200 ] || break
        sleep 0.1
    done
    kill -"$signal" $child
    wait $child
    code=$? why=
    [ $code -eq "$want" ] || why="exit status $code, not $want"
    grep -q 'stopped after step' "$err" || why="says \"$(cat "$err")\""
    grep -q 'largest strain' "$out" || why='prints no table'
    [ "$(tail -c 1 stop.csv | od -An -c | tr -d ' ')" = '\n' ] ||
        why='the last row is cut'
    [ $# -eq 0 ] || [ "$(head -c 4 stop.png | tail -c 3)" = PNG ] ||
        why='there is no strip'
    [ -z "$(ls -A | grep part)" ] || why='something half written is left'
    verdict "stopped by $signal" "$why"
}
if env --default-signal=INT true 2> /dev/null; then
    interrupts INT 130 --film stop.png
fi
interrupts TERM 143

# What waits for the other end of a pipe hears a signal, too.
mkfifo pipe
for signal in INT TERM; do
    case $signal in INT) want=130 ;; *) want=143 ;; esac
    ears=--default-signal=INT
    env $ears true 2> /dev/null || { ears=; [ $signal = TERM ] || continue; }
    env $ears "$tumble" room --csv pipe > "$out" 2> "$err" &
    child=$!
    sleep 0.5
    kill -$signal $child
    (sleep 5; kill -KILL $child) 2> /dev/null & guard=$!
    wait $child
    code=$?
    kill $guard
    verdict "a pipe without a reader hears $signal" "$([ $code -eq $want ] &&
        grep -q 'before the first step' "$err" || echo "exit status $code")"
done
# Nor does a reader that reads nothing hold it for ever.
sleep 20 < pipe & reader=$!
"$tumble" room --bodies 2 --seconds 90000 --csv pipe > "$out" 2> "$err" &
child=$!
sleep 2
kill -TERM $child; sleep 0.3; kill -TERM $child
wait $child
code=$?
kill $reader
verdict 'a second signal ends it at once' \
    "$([ $code -eq 143 ] && [ ! -s "$out" ] || echo "exit status $code")"
rm pipe

# --- Two at once ----------------------------------------------------------------
# begin FILE: a run without end that writes there.
begin() {
    "$tumble" room --bodies 3 --seconds 90000 --csv "$1" > "$out" 2> "$err" &
    child=$!
    tries=0
    until [ "$(cat "$1.part" 2> /dev/null | wc -l)" -gt 20 ]; do
        tries=$((tries + 1))
        [ $tries -lt 200 ] || break
        sleep 0.1
    done
}
begin two.csv
"$tumble" room $long --csv two.csv > "$out.2" 2> "$err.2"
code=$?
verdict 'a second writer is refused' "$([ $code -eq 1 ] &&
    grep -q 'two.csv: cannot write: another program' "$err.2" ||
    echo "exit status $code: $(cat "$err.2")")"
kill -TERM $child
wait $child
verdict 'the first one writes on' "$(awk -F, 'NF != 8 || NR > 2 && $1 + 0 <= last {
    bad = NR } NR > 1 { last = $1 + 0 } END { if (bad || NR < 20) print "line " bad }' two.csv)"
begin killed.csv
kill -KILL $child
wait $child 2> /dev/null
accepts '3 rows' room --bodies 2 --seconds 0.05 --csv killed.csv
verdict 'what a killed run left is taken over' "$(ls -A | grep part)"
rm -f "$out.2" "$err.2"

# --- Sweeps ---------------------------------------------------------------------
# table TEXT: writes it.
table() { printf '%b' "$1" > table.csv; }
table 'scene,bodies,seed,seconds\nroom,4,7,0.5\n\n# two more\nroom,5,2,.1\nroom,,3,.1\n'
accepts "^1,room,4,7,0.5,30,done,.*,$first,[0-9.e-]*\$" --sweep table.csv --row 1
accepts '^3,room,,3,.1,6,done' --sweep table.csv --row 3
refuses 1 'table.csv: has only 3 rows' --sweep table.csv --row 4
refuses 1 'nothing: cannot be opened'  --sweep nothing
for bad in 'scene,bodys\nroom,3\n:line 2: there is no option --bodys; did you mean --bodies' \
           'scene\n:has no row' 'scene,bodies\n\nroom\n:line 3: has 1 cells, and the head 2' \
           'scene,bodies\nroom,"3"\n:line 2: quotes are not read' \
           'bodies\n3\n:line 2: no scene is named' \
           'scene,bodies\nroom,3\nroom,0\n:line 3: --bodies 0: must lie' \
           'scene,list\nroom,yes\n:line 2: a row is the run of a scene' \
           'scene,bits\nroom,1\n:line 2: --bits takes no value'; do
    table "${bad%%:*}"
    refuses 1 "table.csv.*${bad#*:}" --sweep table.csv
done
refuses 2 '--bodies is said by the rows'  --sweep table.csv --bodies 4
refuses 2 'the scene is named by the table' room --sweep table.csv
for option in '--jobs 2' --resume '--joblog x' '--sshloginfile x' '--row 1'; do
    refuses 2 "${option% *} is for a sweep" room $option
done

table 'scene,bodies,seed,seconds\n'
for row in 1 2 3 4 5 6 7 8 9 10 11 12; do echo "room,5,$row,0.2" >> table.csv; done
refuses 1 '--csv table.csv is the table'  --sweep table.csv --csv table.csv
refuses 1 'good.obj: is no job log'       --sweep table.csv --joblog good.obj
verdict 'a file that is no job log is left alone' "$(cmp good.obj good.was 2>&1)"

# Scenes that know nothing but tumble.h.
refuses 2 '--obj: what comes behind it'    wrecker --obj
refuses 2 'takes --seconds, --film'         wrecker --threads 2
refuses 1 'good.obj: is not a folder'       wrecker --obj good.obj
accepts 'wrote steps: 4 frames'             blanket --seconds 0.05 --obj steps
verdict 'a step of a scene is a mesh: bodies, with triangles of vertices that are there' "$(awk '
    $1 == "o" { bodies++ } $1 == "v" { v++ }
    $1 == "f" { for (k = 2; k <= 4; k++) if (!($k >= 1 && $k <= v)) print "face " FNR; faces++ }
    END { if (bodies < 2 || v != 3 * faces) print bodies " bodies, " v " vertices, " faces " faces" }' steps/frame-00003.obj)"
rm -r steps

# In the place of GNU Parallel stands another program of its name.
mkdir fake && printf '#!/bin/sh\necho another\n' > fake/parallel && chmod +x fake/parallel
PATH=$PWD/fake:$PATH "$tumble" --sweep table.csv > "$out" 2> "$err"
code=$?
verdict 'a sweep without GNU Parallel says so' "$([ $code -eq 1 ] &&
    grep -q 'needs GNU Parallel.*make deps-dev' "$err" || echo "$code: $(cat "$err")")"
rm -r fake table.csv.joblog.rows

# same FILE: the lines of the first sweep, but for the times.
same() { cut -d , -f 1-14 "$1" | cmp - lines; }
if parallel --version 2> /dev/null | grep -q '^GNU parallel'; then
    accepts 'wrote one.csv: 12 rows' --sweep table.csv --csv one.csv --jobs 1
    cut -d , -f 1-14 one.csv > lines
    verdict 'a head and a line a row, in order' "$(awk -F , 'NF != 15 || NR > 1 && ($1 != NR - 1 ||
        $4 != NR - 1 || $7 != "done" || $14 !~ /^[0-9a-f]+$/) { print "line " NR }' one.csv)"
    accepts '^12,room,5,12,0.2,12,done' --sweep table.csv --jobs 2 --joblog log
    grep -v '^parallel:' "$out" > two.csv
    verdict 'two jobs, the same table' "$(same two.csv)"
    verdict 'a log has every row' "$([ "$(wc -l < log)" -eq 13 ] || cat log)"
    # A host that is this machine, behind a stand-in for ssh.
    printf '#!/bin/sh\nshift 2\nexec sh -c "$*"\n' > ssh && chmod +x ssh
    echo "1/$folder/ssh there" > hosts
    for SHELL in "$SHELL" /bin/false; do
        accepts '12 rows' --sweep table.csv --csv two.csv --sshloginfile hosts
    done
    verdict 'another host, the same table' "$(same two.csv)"
    verdict 'and it ran there' "$([ "$(grep -c 'ssh there' table.csv.joblog)" -eq 12 ] || cat table.csv.joblog)"

    # A row that cannot run: the others are kept, and it is tried again.
    printf 'scene,bodies,seconds,mesh\nroom,2,.1,\nroom,2,.1,later.obj\n' > some.csv
    run --sweep some.csv --csv some.out
    verdict 'a row that fails is named' "$([ $code -eq 1 ] && [ ! -e some.out ] &&
        grep -q 'later.obj: cannot be opened' "$err" &&
        grep -q 'some rows failed.*--resume' "$err" || echo "$code: $(cat "$err")")"
    cp good.obj later.obj
    accepts 'wrote some.out: 2 rows' --sweep some.csv --csv some.out --resume
    verdict 'and only that one runs again' \
        "$([ "$(awk 'NR > 1 { print $1 }' some.csv.joblog | sort | tr '\n' ' ')" = '1 2 2 ' ] || cat some.csv.joblog)"

    # Killed in the middle, by two signals, and resumed.  The twelfth row waits
    # for the reader of a pipe until it is killed.
    mkfifo wait
    awk -F , -v OFS=, 'NR == 1 { print $0, "csv"; next } { print $0, NR == 13 ? "wait" : "" }' table.csv > last.csv
    for signal in KILL TERM; do
        more=$([ $signal = KILL ] || echo --resume)
        if command -v setsid > /dev/null; then new=setsid; else new=; fi
        $new "$tumble" --sweep last.csv --csv two.csv --jobs 2 $more > "$out" 2> "$err" &
        child=$!
        tries=0
        rm -f last.csv.joblog.rows/12
        until [ -e last.csv.joblog.rows/12 ] && [ "$(cat last.csv.joblog 2> /dev/null | wc -l)" -ge 12 ] || [ $tries -eq 200 ]; do
            tries=$((tries + 1)); sleep 0.1
        done
        [ $signal = TERM ] || refuses 1 'this sweep is being run' --sweep last.csv --resume
        # Parallel gives every row a group of its own: this one goes on alone.
        if [ $signal = KILL ] && [ $new ]; then kill -s KILL -- -$child; cat wait > /dev/null
        else kill -s TERM $child; fi
        wait $child 2> /dev/null
        code=$?
    done
    verdict 'a stopped sweep says so' "$([ $code -eq 143 ] &&
        grep -q 'stopped; --resume goes on' "$err" || echo "$code: $(cat "$err")")"
    # On a busy machine the row that it had begun holds the log for a moment more.
    tries=0
    while "$tumble" --sweep last.csv --csv two.csv 2>&1 | grep -q 'being run' && [ $tries -lt 100 ]; do
        tries=$((tries + 1)); sleep 0.1
    done
    refuses 1 'a sweep stopped here: --resume' --sweep last.csv --csv two.csv
    sed 's/room,5/room,6/' last.csv > other.csv
    refuses 1 'is not the table' --sweep other.csv --joblog last.csv.joblog --resume
    rm wait
    accepts 'wrote two.csv: 12 rows' --sweep last.csv --csv two.csv --jobs 2 --resume
    cut -d , -f 1-5,7-15 two.csv > rows && same rows > "$out"
    verdict 'killed and resumed, the same table' "$(cat "$out")"
    verdict 'no row ran twice but the last' \
        "$(awk 'NR > 1 { print $1 }' last.csv.joblog | sort -n | uniq -d | grep -v 12)"
    verdict 'a finished sweep leaves its log alone' "$(ls -d ./*.rows 2> /dev/null)"
fi

echo "$(((checks - failures) * 100 / checks))%: Checks: $checks," \
     "Failures: $failures, Errors: 0"
[ $failures -eq 0 ]
