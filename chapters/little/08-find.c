//> little_find_all 06a 06a
// Asks about any two pieces of two bodies.
static void find(void)
{
    for (int i = 0; i < piece_count; i++)
        for (int j = 0; j < i; j++)
            if (pieces[i].body != pieces[j].body) meet(&pieces[i], &pieces[j]);
}
//<

//> little_find_spheres 06b 06b
// Asks about two pieces of two bodies if their spheres touch.
static void find(void)
{
    static sphere around[PIECES];
    for (int i = 0; i < piece_count; i++)
        around[i] = sphere_of_piece(&pieces[i]);
    for (int i = 0; i < piece_count; i++)
        for (int j = 0; j < i; j++) {
            if (pieces[i].body == pieces[j].body) continue;
            compared++;
            if (!spheres_apart(around[i], around[j]))
                meet(&pieces[i], &pieces[j]);
        }
}
//<

//> little_find_tree 06c 09z
// Opens the larger of two branches, down to single pieces.
static void branches_meet(branch a, branch b)
{
//<
//> little_find_count 06c 06c
    compared++;
//<
//> little_find_tree_tail 06c 09z
    if (spheres_apart(nodes[a.node], nodes[b.node])) return;
    if (a.count == 1 && b.count == 1) {
        meet(&pieces[a.first], &pieces[b.first]);
        return;
    }
    bool open_a = a.count >= b.count;
    for (int half = 0; half < 2; half++)
        if (open_a) branches_meet(branch_half(a, half), b);
        else branches_meet(a, branch_half(b, half));
}

static void find(void)
{
//<
//> little_find_forget 07a 09z
    contact_count = 0;
//<
//> little_find_bodies 06c 09z
    for (int i = 0; i < body_count; i++) branch_update(branch_of(&bodies[i]));
    for (int i = 0; i < body_count; i++)
        for (int j = 0; j < i; j++)
            branches_meet(branch_of(&bodies[i]), branch_of(&bodies[j]));
}
//<
