//> mesh-pieces
//>   The engine knows convex bodies only. So a triangle becomes one, a prism
//>   below it, when something comes near, and stays one until many have been
//>   left behind. All prisms of a surface are pieces of one body, whose seams
//>   chapter 11 closes.
#include "inside.h"
#include "table.h"
#include "weight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Room for one piece more.
static bool reserve_piece(body_place *x)
{
    body_mesh *m = x->mesh;
    if (x->pieces < m->room) return true;
    int room = table_room(x->pieces + 1, m->room);
    bool ok = true;
    TABLE_GROW(ok, x->piece, x->pieces, room);
    TABLE_GROW(ok, m->of, x->pieces, room);
    if (ok) m->room = room;
    return ok;
}

// Adds a triangle's prism to the bodies.  Where memory is refused it stays away;
// that is a failure, and has a sentence.
static bool add_prism(tumble_world *w, int place, int triangle)
{
    body_place *x = slots_at(&w->bodies, place);
    shape made;
    vec3 center;
    int number;
    if (!inside_reserve_owner(w)) return false;
    if (!reserve_piece(x)) return inside_is_ok(w, status_out_of_memory());
    status done = surface_shape(&x->mesh->surface, triangle, &made, &center);
    tumble_shape s = inside_keep(w, &made, done);
    shape_place *of = slots_find(&w->shapes, s.place, s.generation);
    if (!of) return false;
    if (!inside_is_ok(w, world_add_part(&w->world, of->shape, center,
                                        x->piece[0].number, &number))) {
        inside_drop(w, (int)s.place);
        return false;
    }
    of->bodies = 1;
    w->owner[number] = place;
    x->mesh->piece[triangle] = x->pieces;
    x->mesh->of[x->pieces] = (mesh_piece){ triangle, x->mesh->clearings };
    x->piece[x->pieces++] = (body_piece){ number, (int)s.place };
    return true;
}

// Takes the last pieces away, all but so many.
static void remove_prisms(tumble_world *w, body_place *x, int kept)
{
    int n = x->pieces - kept;
    int *number = malloc(((size_t)n + 1) * sizeof *number);
    if (!number) return;        // they may stay
    for (int k = 0; k < n; k++) number[k] = x->piece[kept + k].number;
    world_remove_parts(&w->world, number, n);
    for (int k = kept; k < x->pieces; k++) {
        x->mesh->piece[x->mesh->of[k].triangle] = -1;
        inside_drop(w, x->piece[k].shape);
    }
    x->pieces = kept;
    free(number);
}
//<

//> mesh-near
//>   Where a body is, and where it may get in this part of a frame.
typedef struct {
    int body;
    sphere ball;
    vec3 delta;         // m
    real beside;        // m, how far any of it gets out of the ball beside that
    aabb reach;         // around all that
} presence;

// m, how far a rope or cloth may get out of its ball.
static real soft_beside(const world *w, const body *x)
{
    const particle *p = w->pool.at + x->first;
    real g = vec3_length(w->options.gravity), most = 0;
    for (int i = 0; i < body_particles(x); i++)
        most = real_max(most, vec3_distance(p[i].position, p[i].previous));
    return most * w->frame / w->age + g * w->frame * w->frame;
}

static presence presence_of(const world *w, int b)
{
    const prediction *ahead = &w->rigid.ahead[b];
    const body *x = &w->body[b];
    presence it = { .body = b, .ball = world_ball(w, b), .delta = ahead->delta };
    it.beside = body_is_soft(x) ? soft_beside(w, x) : ahead->turn;
    it.reach = aabb_wider((aabb){ it.ball.center, it.ball.center },
                         it.ball.radius + it.beside + vec3_length(it.delta));
    return it;
}

static bool is_in_ball(vec3 x, real radius, sphere ball)
{
    real room = ball.radius - radius;
    return room >= 0 && vec3_distance(x, ball.center) <= room;
}
//<

//> mesh-surround
//>   Most bodies are where they were, or near it. So for each there is a ball, a
//>   little larger than it, in which all triangles are pieces already.
typedef struct {
    tumble_world *w;
    int place;
    bool some;          // came,
    bool lost;          // and some found no memory
} surrounding;

static real surround_prism(void *context, int triangle)
{
    surrounding *s = context;
    const body_place *x = slots_at(&s->w->bodies, s->place);
    const body_mesh *m = x->mesh;
    if (m->piece[triangle] < 0) {
        bool is_there = add_prism(s->w, s->place, triangle);
        s->some |= is_there;
        s->lost |= !is_there;
    }
    if (m->piece[triangle] >= 0)
        m->of[m->piece[triangle]].used = m->clearings;
    return 1;
}

// The place of body b among those that were seen; if it is not, where it belongs.
static int find_seen_body(const body_mesh *m, int b)
{
    int low = 0, high = m->seens;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (m->seen[middle].body < b) low = middle + 1;
        else                          high = middle;
    }
    return low;
}

// NULL, with a failure, if memory is refused.
static sphere *seen_of(tumble_world *w, body_mesh *m, int b)
{
    int k = find_seen_body(m, b);
    if (k < m->seens && m->seen[k].body == b) return &m->seen[k].ball;
    if (!TABLE_ADD(m->seen, m->seens, m->seen_room))
        return inside_is_ok(w, status_out_of_memory()), NULL;
    memmove(m->seen + k + 1, m->seen + k,
            (size_t)(m->seens++ - k) * sizeof *m->seen);
    m->seen[k] = (mesh_seen){ b, { { 0, 0, 0 }, -1 } };
    return &m->seen[k].ball;
}

// Is body b, which the step looks at, one that the surface must be there for?
static bool is_awaited(const world *w, int b, int piece)
{
    const body *x = &w->body[b];
    if (body_is_gone(x) || !body_meets(x, &w->body[piece])) return false;
    return body_is_soft(x) ? !body_is_static(x) : body_yields(x);
}

// What flies further than its own size is surrounded along its way, and each
// time again.
// Prisms are placed that far around a body, for the next frames.
static const real LOOKS_WIDER = 1.2;        // tuned, radii

static void surround_body(surrounding *s, const presence *it)
{
    const body_place *x = slots_at(&s->w->bodies, s->place);
    body_mesh *m = x->mesh;
    real far = vec3_length(it->delta), radius = it->ball.radius;
    real reach = far + it->beside;
    bool is_fast = far > radius;
    if (!aabbs_meet(&m->surface.prisms.node[1], &it->reach)
        || !is_awaited(&s->w->world, it->body, x->piece[0].number)) return;
    sphere *seen = seen_of(s->w, m, it->body);
    if (!seen || is_in_ball(it->ball.center, radius + reach, *seen)) return;
    radius = LOOKS_WIDER * radius + 2 * (is_fast ? it->beside : reach);
    aabb at = { it->ball.center, it->ball.center };
    surface_query q = { .thing = aabb_wider(at, radius), .most = 1,
                        .meets = surround_prism, .context = s };
    if (is_fast) q.delta = it->delta;
    s->lost = false;
    surface_visit(&m->surface, &q);
    *seen = (sphere){ it->ball.center, is_fast || s->lost ? -1 : radius };
}
//<

//> mesh-clear
//>   When there are twice as many pieces as were needed once, those that are not
//>   needed go. What is asleep needs those that it lies on.
// Puts the pieces that are needed first; the first stays.  Returns how many.
static int sort_needed(body_place *x)
{
    body_mesh *m = x->mesh;
    int kept = 1;
    for (int k = 1; k < x->pieces; k++) {
        if (m->of[k].used != m->clearings) continue;
        SWAP(body_piece, x->piece[k], x->piece[kept]);
        SWAP(mesh_piece, m->of[k], m->of[kept]);
        m->piece[m->of[kept].triangle] = kept;
        kept++;
    }
    for (int k = kept; k < x->pieces; k++) m->piece[m->of[k].triangle] = k;
    return kept;
}

static void clear(surrounding *s)
{
    enum { SPARE = 64 };
    tumble_world *w = s->w;
    body_place *x = slots_at(&w->bodies, s->place);
    body_mesh *m = x->mesh;
    if (x->pieces < 2 * m->kept + SPARE) return;
    m->clearings++;
    int seens = 0;
    for (int k = 0; k < m->seens; k++) {
        presence it = presence_of(&w->world, m->seen[k].body);
        m->seen[k].ball.radius = -1;
        surround_body(s, &it);
        if (m->seen[k].ball.radius >= 0) m->seen[seens++] = m->seen[k];
    }
    m->seens = seens;
    remove_prisms(w, x, sort_needed(x));
    m->kept = x->pieces;
    s->some = true;
}

// Some bodies at once are asked of each surface: where they are is found once.
enum { FACES_AT_ONCE = 64 };

static void surround_some(surrounding *s, int first)
{
    const rigid_tables *t = &s->w->world.rigid;
    presence it[FACES_AT_ONCE];
    int n = int_min(t->awakes - first, FACES_AT_ONCE);
    for (int k = 0; k < n; k++)
        it[k] = presence_of(&s->w->world, t->awake[first + k]);
    for (int m = s->w->first_mesh; m > 0; m = inside_next_mesh(s->w, m)) {
        s->place = m - 1;
        for (int k = 0; k < n; k++) surround_body(s, &it[k]);
    }
}

static bool surround(void *surroundings)
{
    tumble_world *w = surroundings;
    surrounding s = { w, 0, false, false };
    for (int k = 0; k < w->world.rigid.awakes; k += FACES_AT_ONCE)
        surround_some(&s, k);
    for (int m = w->first_mesh; m > 0; m = inside_next_mesh(w, m)) {
        s.place = m - 1;
        clear(&s);
    }
    return s.some;
}
//<

//> mesh-enters
//>   The way of a centre goes in through a triangle; or, if through none and if it
//>   began in no prism, through another face of one.
typedef struct {
    const surface *surface;
    vec3 from, to;          // m
    real first, below;      // shares of the way; HUGE_VAL: it does not go in
    int  triangle;          // through which it goes in first
    plane side, side_below;
    bool is_inside;
} face_passage;

static real enter_prism(void *context, int triangle)
{
    face_passage *p = context;
    plane side;
    real fraction = surface_entry(p->surface, triangle, p->from, p->to);
    if (fraction < p->first || (fraction == p->first && triangle < p->triangle)) {
        p->first = fraction;
        p->triangle = triangle;
        p->side = surface_plane(p->surface, triangle);
    }
    fraction = surface_entry_below(p->surface, triangle, p->from, p->to, &side);
    p->is_inside |= fraction < 0;
    if (fraction >= 0 && fraction < p->below) {
        p->below = fraction;
        p->side_below = side;
    }
    return 1;
}

static bool enters(void *surroundings, int b, vec3 from, vec3 to, plane *side)
{
    const tumble_world *w = surroundings;
    face_passage p = { .from = from, .to = to, .first = HUGE_VAL,
                  .below = HUGE_VAL };
    for (int k = w->first_mesh; k > 0; k = inside_next_mesh(w, k)) {
        const body_place *x = slots_at(&w->bodies, k - 1);
        surface_query q = { .thing = aabb_with((aabb){ from, from }, to),
                            .most = 1, .meets = enter_prism, .context = &p };
        p.surface = &x->mesh->surface;
        if (!aabbs_meet(&p.surface->prisms.node[1], &q.thing)
            || !is_awaited(&w->world, b, x->piece[0].number)) continue;
        surface_visit(p.surface, &q);
    }
    bool is_below = !(p.first <= 1) && !p.is_inside;
    *side = is_below ? p.side_below : p.side;
    return (is_below ? p.below : p.first) <= 1;
}

void inside_watch_meshes(tumble_world *w)
{
    w->world.options.host.surround = surround;
    w->world.options.host.enters = enters;
    w->world.options.host.surroundings = w;
}
//<

//> face-mesh
//>   A surface is a body with one piece, and then more.
// What goes to the body, if there is one: *m.  All of it goes back if not.
static tumble_body add_body_mesh(tumble_world *w, body_mesh *m,
                                 tumble_body_options o)
{
    shape made;
    vec3 center;
    int first = m->surface.prisms.number[0];
    status done = surface_shape(&m->surface, first, &made, &center);
    tumble_shape s = inside_keep(w, &made, done);
    o.kind = TUMBLE_STATIC;
    o.pose = (tumble_pose){ to_user(center), { 0, 0, 0, 1 } };
    tumble_body b = tumble_body_add(w, s, o);
    const shape_place *of = slots_find(&w->shapes, s.place, s.generation);
    body_place *x = slots_find(&w->bodies, b.place, b.generation);
    if (!x) {
        inside_free_mesh(m);
        if (of) inside_drop(w, (int)s.place);
        return b;
    }
    x->mesh = m;
    m->room = m->kept = 1;
    m->piece[first] = 0;
    m->of[0].triangle = first;
    m->next = w->first_mesh;
    w->first_mesh = 1 + (int)b.place;
    inside_watch_meshes(w);
    return b;
}

static status make(body_mesh *m, const vec3 *point, int points,
                   const int (*triangle)[3], int triangles, vec3 down,
                   real thickness)
{
    status done = surface_make(&m->surface, point, points, triangle, triangles,
                               down, thickness);
    if (!done.ok) return done;
    m->piece = malloc((size_t)triangles * sizeof *m->piece);
    m->of = calloc(1, sizeof *m->of);
    if (!m->piece || !m->of) return status_out_of_memory();
    for (int k = 0; k < triangles; k++) m->piece[k] = -1;
    return done;
}

// A surface whose points are those in the frame of the pose, which become the
// world's.  Frees both tables; NULL: memory was refused.
static tumble_body add_surface(tumble_world *w, vec3 *point, int points,
                               int (*triangle)[3], int triangles, vec3 down,
                               real thickness, tumble_body_options o)
{
    placement at = { .is_static = true };
    body_mesh *m = calloc(1, sizeof *m);
    status done = status_out_of_memory();
    inside_place(&at, o.pose);
    if (m && point && triangle) {
        for (int k = 0; k < points; k++)
            point[k] = vec3_add(at.position, placement_vector(&at, point[k]));
        m->pose = o.pose;
        done = make(m, point, points, (const int (*)[3])triangle, triangles,
                    vec3_scale(down.y, at.y), thickness);
    }
    free(point);
    free(triangle);
    if (inside_is_ok(w, done)) return add_body_mesh(w, m, o);
    inside_free_mesh(m);
    return (tumble_body){ 0, 0 };
}

static bool is_thickness(tumble_world *w, double thickness)
{
    if (thickness >= 0 && thickness < HUGE_VAL) return true;
    return inside_fail(w, "the thickness of a surface is %g: it must be finite, "
                       "and 0 or more", thickness);
}

// m, of the sides of all triangles.
static real mean_side(const vec3 *point, int points, const int *v, int n)
{
    real sum = 0;
    for (int k = 0; k < 3 * n; k++) {
        int a = v[k], b = v[k % 3 == 2 ? k - 2 : k + 1];
        if (a >= 0 && a < points && b >= 0 && b < points)
            sum += vec3_distance(point[a], point[b]) / (3.0 * n);
    }
    return sum;
}

tumble_body tumble_body_add_mesh(tumble_world *w, const tumble_vec3 *point,
                                 int points, const int *triangle, int triangles,
                                 double thickness, tumble_body_options o)
{
    const vec3 down = { 0, 0, 0 };
    tumble_body b = { 0, 0 };
    if (!inside_is_world(w) || !is_thickness(w, thickness)) return b;
    if (!inside_is_list(w, point, points, "points")
        || !inside_is_list(w, triangle, triangles, "triangles")) return b;
    if (points < 1 || triangles < 1)
        return inside_fail(w, "a surface of %d points and %d triangles: it has "
                           "some of both", points, triangles), b;
    vec3 *at = malloc((size_t)points * sizeof *at);
    int (*of)[3] = malloc((size_t)triangles * sizeof *of);
    for (int k = 0; at && k < points; k++) at[k] = from_user(point[k]);
    if (of) memcpy(of, triangle, (size_t)triangles * sizeof *of);
    if (at && thickness == 0)
        thickness = mean_side(at, points, triangle, triangles);
    return add_surface(w, at, points, of, triangles, down, thickness, o);
}
//<

//> face-heights
//>   A terrain is a surface over a grid, cut as a cloth is.
enum { MOST_ROWS = 1 << 13 };     // points along a side

static void place_heights(vec3 *at, const double *height, int columns, int rows,
                          real width, real depth)
{
    int across = columns - 1, along = rows - 1;
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++)
            at[j * columns + i] =
                vec3_make(width * (2 * i - across) / (2 * across),
                          height[j * columns + i],
                          depth * (2 * j - along) / (2 * along));
}

static bool is_grid(tumble_world *w, const double *height, int columns,
                    int rows, double width, double depth)
{
    if (columns < 2 || rows < 2 || columns > MOST_ROWS || rows > MOST_ROWS)
        return inside_fail(w, "a terrain of %d x %d points: it has from 2 to %d "
                           "along each side", columns, rows, MOST_ROWS);
    if (!inside_is_list(w, height, columns, "heights")) return false;
    if (width > 0 && width < HUGE_VAL && depth > 0 && depth < HUGE_VAL)
        return true;
    return inside_fail(w, "a terrain is %g m wide and %g m deep: both must be "
                       "finite, and more than 0", width, depth);
}

tumble_body tumble_body_add_heights(tumble_world *w, const double *height,
                                    int columns, int rows, double width,
                                    double depth, double thickness,
                                    tumble_body_options o)
{
    tumble_body b = { 0, 0 };
    if (!inside_is_world(w) || !is_thickness(w, thickness)
        || !is_grid(w, height, columns, rows, width, depth)) return b;
    int points = columns * rows, triangles = 2 * (columns - 1) * (rows - 1);
    vec3 *at = malloc((size_t)points * sizeof *at);
    int (*cell)[3] = malloc((size_t)triangles * sizeof *cell);
    real side = real_max(width / (columns - 1), depth / (rows - 1));
    vec3 down = { 0, thickness > 0 ? -thickness : -2 * side, 0 };
    if (at) place_heights(at, height, columns, rows, width, depth);
    if (cell) shape_cut_cells(cell, columns, rows);
    return add_surface(w, at, points, cell, triangles, down, 0, o);
}
//<
