//> little_order 08a 08z
// --- Order ------------------------------------------------------------------

// Puts the sticks into an order: first those at the particle `from`, then those
// that a path of one stick leads to, of two, and so on.
static void sticks_order(int from)
{
    static stick ordered[STICKS];
    static bool reached[PARTICLES];
    int count = 0;
    for (int i = 0; i < particle_count; i++) reached[i] = i == from;
    for (int ring = 0; ring < particle_count && count < stick_count; ring++) {
        int before = count;
        for (int i = 0; i < stick_count; i++)
            if (sticks[i].rest_length > 0
                && (reached[sticks[i].a] || reached[sticks[i].b])) {
                ordered[count++] = sticks[i];
                sticks[i].rest_length = 0;
            }
        for (int i = before; i < count; i++)
            reached[ordered[i].a] = reached[ordered[i].b] = true;
    }
    for (int i = 0; i < count; i++) sticks[i] = ordered[i];
}
//<
