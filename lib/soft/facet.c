//> facet-between
//>   A new pair has no plane yet. It gets the one through the side that most of
//>   the facet is on.
#include "facet.h"
#include "query.h"

#include <stddef.h>

// The plane with this normal (of any length) that the body touches from behind.
static plane touching_plane(const obstacle *b, vec3 normal)
{
    plane p = { vec3_unit(normal), -HUGE_VAL };
    for (int v = 0; v < b->vertices.count; v++)
        p.offset = real_max(p.offset, vec3_dot(p.normal, b->vertices.at[v]));
    p.offset += b->round;
    return p;
}

// One that nothing is known of is to leave by the side that most of it is on.
static plane guess(const obstacle *b, const vec3 end[FACET])
{
    vec3 facet = { 0, 0, 0 }, body = { 0, 0, 0 };
    for (int k = 0; k < FACET; k++)
        facet = vec3_add_scaled(facet, 1.0 / FACET, end[k]);
    for (int v = 0; v < b->vertices.count; v++)
        body = vec3_add_scaled(body, 1.0 / b->vertices.count,
                               b->vertices.at[v]);
    vec3 out = vec3_sub(facet, body);
    if (vec3_length_squared(out) > 0) return touching_plane(b, out);
    return obstacle_plane(b, end[0], 0);
}
//<

//> facet-nearest
// The query of two bodies, of the facet moved by so much.
static gjk_result query_moved(const obstacle *b, const vec3 end[FACET],
                              vec3 by, real reach)
{
    vec3 at[FACET];
    for (int k = 0; k < FACET; k++) at[k] = vec3_add(end[k], by);
    return gjk_distance((hull){ at, FACET }, b->vertices, reach + b->round,
                        NULL);
}

bool facet_nearest(const obstacle *b, const vec3 end[FACET], plane *between,
                   real reach, facet_touch *out)
{
    vec3 by = { 0, 0, 0 };
    gjk_result g = query_moved(b, end, by, reach);
    if (g.status == GJK_OVERLAP) {
        // So far along the normal of the plane that they are surely apart.
        if (!(vec3_length_squared(between->normal) > 0))
            *between = guess(b, end);
        real far = reach - facet_height(end, *between);
        by = vec3_scale(far, between->normal);
        g = query_moved(b, end, by, HUGE_VAL);
    }
    *out = (facet_touch){ .gap = 0 };
    if (!(g.distance > 0)) return false;
    *between = touching_plane(b, g.axis);
    feature_point facet, body;
    query_features(&g.last, &facet, &body);
    out->at = (surface_point){ vec3_add_scaled(g.on_b, b->round,
                                               between->normal),
                               between->normal };
    for (int k = 0; k < facet.count; k++)
        out->weight[facet.vertex[k]] = facet.weight[k];
    // Where it is, if both are as flat as they look there.
    out->gap = g.distance - b->round - vec3_dot(by, between->normal);
    return g.status == GJK_APART && out->gap < reach;
}
//<
