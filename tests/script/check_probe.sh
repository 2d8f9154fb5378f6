# check_probe.sh - do tests ask a world through tumble.h, world.h or probe.h alone?
# A test that names the tables of a world would nail them down.

found=$(grep -nE '(^|[^a-z_.>])([a-z]+(\.|->))?(w|world)(\.|->)(rigid|soft|sleep|joints)[^a-z_(]' tests/*/*.[ch] |
    grep -v '^tests/support/probe\.h:')
[ -z "$found" ] || {
    echo "$found"
    echo "check_probe: these lines name a table of the world: ask tests/support/probe.h"
    exit 1
}

# The pattern itself is shown what it must find.
said='    ck_assert(w.sleep.asleep[b]);
    s.world.soft.near.made = 0;
    real *u = w->rigid.velocity[b].of;'
[ "$(echo "$said" | grep -cE '(^|[^a-z_.>])([a-z]+(\.|->))?(w|world)(\.|->)(rigid|soft|sleep|joints)[^a-z_(]')" -eq 3 ] ||
    { echo "check_probe: it overlooks what it should find"; exit 1; }
