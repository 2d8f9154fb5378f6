// truth_wide.h - the arithmetic of truth.c, for one type of number: `wide`, with
// `WIDE_EPS` the relative error of one operation.  Names end in _WIDE_NAME.
//
// Included once for each type, so it has no guard.

#define NAMED2(name, type) name##_##type
#define NAMED1(name, type) NAMED2(name, type)
#define W(name) NAMED1(name, WIDE_NAME)

typedef struct { wide x, y, z; } W(vec);

static W(vec) W(widened)(vec3 a)
{
    return (W(vec)){ (wide)a.x, (wide)a.y, (wide)a.z };
}
static W(vec) W(minus)(W(vec) a, W(vec) b)
{
    return (W(vec)){ a.x - b.x, a.y - b.y, a.z - b.z };
}
static W(vec) W(times)(wide t, W(vec) a)
{
    return (W(vec)){ t * a.x, t * a.y, t * a.z };
}
static wide W(dot)(W(vec) a, W(vec) b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static W(vec) W(cross)(W(vec) a, W(vec) b)
{
    return (W(vec)){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                     a.x * b.y - a.y * b.x };
}
static wide W(root)(wide a)             // Newton, from the long double's root
{
    if (!(a > 0)) return 0;
    wide r = (wide)sqrtl((long double)a);
    for (int k = 0; k < 2; k++) r = (r + a / r) / 2;
    return r;
}

// Both bodies, measured from the first vertex of A.
typedef struct {
    int na, nb;
    W(vec) a[TRUTH_POINTS], b[TRUTH_POINTS];
    char use_a[TRUTH_POINTS], use_b[TRUTH_POINTS];  // vertices to be tried
} W(pair);

static void W(widen)(W(pair) *p, hull a, hull b)
{
    W(vec) o = W(widened)(a.at[0]);
    p->na = a.count, p->nb = b.count;
    for (int i = 0; i < a.count; i++)
        p->a[i] = W(minus)(W(widened)(a.at[i]), o), p->use_a[i] = 1;
    for (int i = 0; i < b.count; i++)
        p->b[i] = W(minus)(W(widened)(b.at[i]), o), p->use_b[i] = 1;
}

// How far A - B reaches along n, in units of |n|.
static wide W(width)(const W(pair) *p, W(vec) n)
{
    wide most = W(dot)(n, p->a[0]), least = W(dot)(n, p->b[0]);
    for (int i = 1; i < p->na; i++) {
        wide h = W(dot)(n, p->a[i]);
        if (h > most) most = h;
    }
    for (int i = 1; i < p->nb; i++) {
        wide h = W(dot)(n, p->b[i]);
        if (h < least) least = h;
    }
    return most - least;
}

// The best so far: v leads from B to A, points of both joined; no body is
// nearer to the other than `proven`, the height of a plane between them.
typedef struct { wide square, proven; W(vec) v, axis; } W(best);

static void W(offer)(W(best) *r, W(vec) v, W(vec) axis)
{
    wide vv = W(dot)(v, v);
    if (vv < r->square) r->square = vv, r->v = v, r->axis = axis;
}

// p to the segment a, b; sign: -1 where p is B's.
static void W(point_edge)(W(best) *r, W(vec) p, W(vec) a, W(vec) b, int sign)
{
    W(vec) e = W(minus)(b, a), g = W(minus)(p, a);
    wide ee = W(dot)(e, e), t = ee > 0 ? W(dot)(g, e) / ee : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    W(vec) v = W(times)((wide)sign, W(minus)(g, W(times)(t, e)));
    W(offer)(r, v, v);
}

static void W(point_face)(W(best) *r, W(vec) p, W(vec) a, W(vec) e, W(vec) f,
                          W(vec) n, wide nn, int sign)
{
    W(vec) g = W(minus)(p, a);
    wide u = W(dot)(W(cross)(g, f), n) / nn, t = W(dot)(W(cross)(e, g), n) / nn;
    if (u < 0 || t < 0 || u + t > 1) return;
    W(vec) v = W(minus)(W(minus)(g, W(times)(u, e)), W(times)(t, f));
    W(offer)(r, W(times)((wide)sign, v), n);
}

static void W(edge_edge)(W(best) *r, W(vec) a, W(vec) b, W(vec) c, W(vec) d)
{
    W(vec) e = W(minus)(b, a), f = W(minus)(d, c), g = W(minus)(c, a);
    W(vec) n = W(cross)(e, f);
    wide nn = W(dot)(n, n);
    if (!(nn > 0)) return;
    wide s = W(dot)(W(cross)(g, f), n) / nn, t = W(dot)(W(cross)(g, e), n) / nn;
    if (s < 0 || s > 1 || t < 0 || t > 1) return;
    W(vec) v = W(minus)(W(minus)(W(times)(s, e), g), W(times)(t, f));
    W(offer)(r, v, n);
}

static void W(faces)(W(best) *r, const W(vec) *q, const char *use_q, int nq,
                     const W(vec) *p, const char *use_p, int np, int sign)
{
    for (int i = 0; i < nq; i++)
        for (int j = i + 1; j < nq; j++)
            for (int k = j + 1; k < nq; k++) {
                if (!use_q[i] || !use_q[j] || !use_q[k]) continue;
                W(vec) e = W(minus)(q[j], q[i]), f = W(minus)(q[k], q[i]);
                W(vec) n = W(cross)(e, f);
                wide nn = W(dot)(n, n);
                if (!(nn > 0)) continue;
                for (int l = 0; l < np; l++)
                    if (use_p[l])
                        W(point_face)(r, p[l], q[i], e, f, n, nn, sign);
            }
}

static wide W(proof)(const W(pair) *p, W(vec) n)
{
    wide length = W(root)(W(dot)(n, n));
    if (!(length > 0)) return -(wide)1e300;     // no plane: no proof
    wide one = -W(width)(p, n), other = -W(width)(p, W(times)(-1, n));
    return (one > other ? one : other) / length;
}

// Every feature of the one with every feature of the other.
static W(best) W(apart)(const W(pair) *p)
{
    W(best) r = { .square = (wide)1e300 * (wide)1e300 };
    for (int i = 0; i < p->na; i++)
        for (int k = 0; k < p->nb; k++) {
            if (!p->use_a[i] || !p->use_b[k]) continue;
            W(vec) v = W(minus)(p->a[i], p->b[k]);
            W(offer)(&r, v, v);
            for (int j = i + 1; j < p->na; j++)
                if (p->use_a[j])
                    W(point_edge)(&r, p->b[k], p->a[i], p->a[j], -1);
            for (int l = k + 1; l < p->nb; l++)
                if (p->use_b[l])
                    W(point_edge)(&r, p->a[i], p->b[k], p->b[l], 1);
            for (int j = i + 1; j < p->na; j++)
                for (int l = k + 1; l < p->nb; l++)
                    if (p->use_a[j] && p->use_b[l])
                        W(edge_edge)(&r, p->a[i], p->a[j], p->b[k], p->b[l]);
        }
    W(faces)(&r, p->a, p->use_a, p->na, p->b, p->use_b, p->nb, -1);
    W(faces)(&r, p->b, p->use_b, p->nb, p->a, p->use_a, p->na, 1);
    wide one = W(proof)(p, r.v), other = W(proof)(p, r.axis);
    r.proven = one > other ? one : other;
    return r;
}

// A direction given by two edges: its width and how wrong that may be.
static wide W(width_across)(const W(pair) *p, W(vec) e, W(vec) f, wide size,
                            wide *error)
{
    W(vec) n = W(cross)(e, f);
    wide length = W(root)(W(dot)(n, n));
    wide noise = 16 * WIDE_EPS * W(root)(W(dot)(e, e) * W(dot)(f, f));
    *error = length > noise ? size * noise / length : -1;
    if (!(length > noise)) return 0;
    wide one = W(width)(p, n), other = W(width)(p, W(times)(-1, n));
    return (one < other ? one : other) / length;
}

#undef NAMED2
#undef NAMED1
#undef W
