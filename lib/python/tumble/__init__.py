"""tumble for Python: what tumble.h declares, without the prefix.

A function of the header whose first argument is a world is a method of World
(tumble_body_push is World.body_push, and tumble_world_step World.step), any other
is one of this module; each has the header's comment as its help.
Vectors may be any three numbers.  What fails raises Failure, with its sentence.
"""

import ctypes
import os

from .header import Header, Value

_here = os.path.dirname(__file__)
with open(os.path.join(_here, "tumble.h"), encoding="utf-8") as _file:
    _text = _file.read()
_header = Header(_text)
_library = ctypes.CDLL(os.path.join(_here, "tumble.dll" if os.name == "nt" else "libtumble.so"))
__version__ = _text.split('#define TUMBLE_VERSION "')[1].split('"')[0]


class Failure(Exception):
    """A function could not do what it was asked for, and changed nothing."""


def _pointer(p):
    return p.pointer or p.size is not None


def _c_type(p):
    if p.type == "char" and p.pointer:
        return ctypes.c_char_p
    return ctypes.c_void_p if _pointer(p) else _header.types[p.type]


def _given(kind, value):
    """The value as the C type, which a tuple, a list or an array may stand for."""
    if isinstance(kind, type) and issubclass(kind, Value) and not isinstance(value, kind):
        return kind(*(_given(field[1], v) for field, v in zip(kind._fields_, value)))
    return value


def _array(kind, values):
    """Memory that holds them one after another: a buffer of doubles as it is."""
    if isinstance(values, ctypes.Array):
        return values
    count = len(values)
    try:
        flat = memoryview(values)
        if flat.format == "d" and flat.c_contiguous:
            return (ctypes.c_byte * flat.nbytes).from_buffer_copy(flat)
    except TypeError:
        pass
    return (kind * count)(*(_given(kind, v) for v in values))


def numbers(array):
    """An array of structs of doubles as memory of rows, not copied; numpy.asarray
    makes an array of it, not copied either."""
    width = ctypes.sizeof(array._type_) // ctypes.sizeof(ctypes.c_double)
    flat = memoryview(array).cast("B")
    return flat.cast("d", (len(array), width)) if len(array) else flat.cast("d")


def _short(name):
    """tumble_body_push is body_push; a world's own, tumble_world_step, is step."""
    first = _header.functions[name][1][:1]
    own = "tumble_world_" if first and first[0].type == "tumble_world" else "tumble_"
    return name[len(own if name.startswith(own) else "tumble_"):]


def _made(name):
    """A function of Python for one of the header; its first may be a world."""
    result, parameters, comment = _header.functions[name]
    function = getattr(_library, name)
    function.argtypes = [_c_type(p) for p in parameters]
    function.restype = _c_type(result)
    last = parameters[-1] if parameters else None
    lists = len(parameters) > 1 and last.name == "most" and parameters[-2].pointer and not parameters[-2].const
    answers = bool(parameters) and not last.const and _pointer(last) and last.type in _header.types \
        and _header.types[last.type] is not None
    world = bool(parameters) and parameters[0].type == "tumble_world"
    asks = parameters[world:len(parameters) - (2 if lists else 1 if answers else 0)]

    def call(w, *given):
        if len(given) != len(asks):
            raise TypeError(f"{_short(name)} takes {', '.join(p.name for p in asks) or 'nothing'}")
        c = [w] if world else []
        for p, value in zip(asks, given):
            c.append(_array(_header.types[p.type], value) if _pointer(p) and p.type in _header.types
                     and p.type != "void" and not isinstance(value, (bytes, str, type(None)))
                     else os.fsencode(value) if p.type == "char" else _given(_c_type(p), value))
        if lists:
            kind, most = _header.types[parameters[-2].type], 256 if parameters[0].const else 65536
            while True:
                out = (kind * most)()
                count = function(*c, out, most)
                if count <= most or not parameters[0].const:
                    return (kind * min(count, most)).from_buffer(out)
                most = count
        if answers:
            kind = _header.types[last.type]
            out = (kind * last.size)() if last.size else kind()
            said = function(*c, ctypes.byref(out))
            if result.pointer:
                return (_header.types[result.type] * out.value).from_address(said) if said else ()
            return out if result.type == "void" or said else None
        return function(*c)

    if world:
        def method(self, *given):
            said = call(self._world, *given)
            if not parameters[0].const and (not said or isinstance(said, Value) and not any(said)):
                self._check()
            return said
    else:
        def method(*given):
            return call(None, *given)
    method.__name__ = _short(name)
    method.__doc__ = ", ".join(p.name for p in asks) + "\n\n" + comment
    return method


class World:
    """Bodies, joints and planes.  World(dt=1/120, substeps=8) sets options."""

    def __init__(self, **options):
        o = _library.tumble_options_default()
        for name, value in options.items():
            setattr(o, name, _given(dict(o._fields_)[name], value))
        self._begin(_library.tumble_world_make(ctypes.byref(o)))

    def _begin(self, world):
        self._world = world
        if not world:
            self._check()

    def _check(self):
        why = _library.tumble_world_failure(self._world)
        if why:
            _library.tumble_world_forget_failure(self._world)
            raise Failure(why.decode())

    def __del__(self):
        if getattr(self, "_world", None):
            _library.tumble_world_free(self._world)
            self._world = None

    def save(self):
        """All that the world is, as bytes."""
        size = _library.tumble_world_save(self._world, None, 0)
        out = ctypes.create_string_buffer(size)
        _library.tumble_world_save(self._world, out, size)
        return out.raw

    @classmethod
    def load(cls, saved):
        """The world that was saved; its steps have the bits that those would have had."""
        self = cls.__new__(cls)
        self._begin(_library.tumble_world_load(saved, len(saved)))
        return self

    def restore(self, saved):
        """Puts what was saved in the place of this world."""
        if not _library.tumble_world_restore(self._world, saved, len(saved)):
            self._check()

    def _in_bulk(self, function, kinds, bodies):
        bodies = self.bodies() if bodies is None else _array(body, bodies)
        out = [(kind * len(bodies))() for kind in kinds]
        function(self._world, bodies, len(bodies), *out)
        return [numbers(array) for array in out]

    def poses(self, bodies=None):
        """Of many bodies at once (None: of all), a row each: x y z, and the
        quaternion's x y z w.  numpy.asarray(world.poses())[:, :3] is where they are."""
        return self._in_bulk(_library.tumble_body_poses, [pose], bodies)[0]

    def velocities(self, bodies=None):
        """Likewise: rows of velocities, and rows of spins, of three numbers each."""
        return self._in_bulk(_library.tumble_body_velocities, [vec3, vec3], bodies)


_hidden = {"world_make", "free", "failure", "forget_failure", "save", "world_load", "run_on",
           "draw", "body_poses", "body_velocities", "restore", "choose_contacts"}
for _key, _value in _header.constants.items():
    globals()[_key.replace("TUMBLE_", "")] = _value
for _key, _value in _header.types.items():
    if _key.startswith("tumble_") and _value is not None:
        globals()[_key[7:]] = _value
for _key, (_result, _parameters, _) in _header.functions.items():
    _function = _made(_key)
    if _short(_key) in _hidden:
        continue
    if _parameters and _parameters[0].type == "tumble_world":
        setattr(World, _short(_key), _function)
    else:
        globals()[_short(_key)] = _function


_at = body_at


def body_at(x, y, z, **options):
    """Options of a body at a place: body_at(0, 3, 0, kind=STATIC, friction=0.3)."""
    o = _at(x, y, z)
    for name, value in options.items():
        setattr(o, name, _given(dict(o._fields_)[name], value))
    return o


# The names of version 2, as the header has them.
for _key, _new in _header.old_names.items():
    if hasattr(World, _short(_new)) and _short(_new) not in _hidden:
        setattr(World, _key[7:], getattr(World, _short(_new)))
    elif _short(_new) in globals():
        globals()[_key[7:]] = globals()[_short(_new)]
