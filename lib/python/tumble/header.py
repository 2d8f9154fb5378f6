"""Reads tumble.h: its types as those of ctypes, and what its functions take.

So Python's functions are those of the header that was compiled, whatever it has.
"""

import ctypes
import re

PLAIN = {"void": None, "bool": ctypes.c_bool, "int": ctypes.c_int, "unsigned": ctypes.c_uint,
         "double": ctypes.c_double, "size_t": ctypes.c_size_t, "char": ctypes.c_char,
         "unsigned long long": ctypes.c_ulonglong}


class Value(ctypes.Structure):
    """A struct of tumble.h: its members have names, and come in their order."""

    def __iter__(self):
        return (getattr(self, name) for name, *_ in self._fields_)

    def __repr__(self):
        return type(self).__name__ + "(" + ", ".join(f"{n}={v!r}" for (n, *_), v in zip(self._fields_, self)) + ")"

    def __eq__(self, other):
        return type(self) is type(other) and bytes(self) == bytes(other)

    def __hash__(self):
        return hash(bytes(self))


class Parameter:
    """One of a function: const T name, *name or name[size]."""

    def __init__(self, text, size_of):
        self.const = "const " in text
        text = text.replace("const ", "")
        callback = re.match(r".*\(\*(\w+)\)\(", text)
        if callback:
            self.type, self.name, self.pointer, self.size = "function", callback.group(1), True, None
            return
        self.type, stars, self.name, size = re.fullmatch(
            r"\s*(unsigned long long|\w+)\s*(\**)\s*(\w*)(?:\[(\w+)\])?\s*", text).groups()
        self.pointer = stars != ""
        self.size = size and size_of(size)


class Header:
    """The types, the numbers with names, and the functions: name -> (what it
    returns, its parameters, the comment above it); what old names stand for."""

    def __init__(self, text):
        self.types, self.constants, self.functions = dict(PLAIN), {}, {}
        self.old_names = dict(re.findall(r"^#define (tumble_\w+) (tumble_\w+)$", text, re.M))
        text = re.sub(r"^//[<>].*\n", "", text, flags=re.M)
        text = re.sub(r"^[ \t]*#.*\n", "", text, flags=re.M)
        text = re.sub(r"^static inline.*?^\}$", "", text, flags=re.M | re.S)
        text = re.sub(r'extern "C" \{|^\}$(?!\s*\w)', "", text, flags=re.M)
        comment = ""
        for match in re.finditer(r"((?:^//.*\n)+)|^(typedef|enum)\b[^;{]*(?:\{((?:[^{}])*)\}\s*(\w*))?[^;]*;|^[a-z][\w ]*[ *]\**tumble_\w+\([^;]*\);",
                                 text, re.M):
            if match.group(1):
                comment = re.sub(r"^// ?", "", match.group(1), flags=re.M)
            elif match.group(2):
                self._declare(match.group(0), match.group(3), match.group(4))
                comment = ""
            else:
                self._function(re.sub(r"//.*", "", match.group(0)), comment)

    def _number(self, word):
        return int(word) if word.isdigit() else self.constants[word]

    def _declare(self, whole, inside, name):
        if inside is None:
            opaque = re.match(r"typedef struct (\w+) (\w+);", whole)
            if opaque:
                self.types[opaque.group(2)] = None
            return
        inside = re.sub(r"//.*", "", inside)
        if "enum" in whole.split("{")[0]:
            next_value = 0
            for item in filter(str.strip, inside.split(",")):
                key, _, value = (s.strip() for s in item.partition("="))
                next_value = int(value) if value else next_value
                self.constants[key] = next_value
                next_value += 1
            if name:
                self.types[name] = ctypes.c_int
            return
        fields = []
        for member in filter(str.strip, inside.split(";")):
            member = " ".join(member.replace("const ", "").split())
            callback = re.match(r".*\(\*(\w+)\)", member)
            if callback:
                fields.append((callback.group(1), ctypes.c_void_p))
                continue
            kind, rest = re.match(r"(unsigned long long|\w+)\s*(.*)", member).groups()
            for each in rest.split(","):
                stars, word, size = re.fullmatch(r"\s*(\**)(\w+)(?:\[(\w+)\])?\s*", each).groups()
                base = ctypes.c_void_p if stars else self.types[kind]
                fields.append((word, base * self._number(size) if size else base))
        self.types[name] = type(name.replace("tumble_", ""), (Value,), {"_fields_": fields})

    def _function(self, text, comment):
        result, name, inside = re.match(r"(.*?[ *])(tumble_\w+)\((.*)\);", " ".join(text.split()), re.S).groups()
        parts, depth = [""], 0
        for c in inside:
            depth += (c == "(") - (c == ")")
            if c == "," and depth == 0:
                parts.append("")
            else:
                parts[-1] += c
        parameters = [Parameter(" ".join(p.split()), self._number) for p in parts if p.strip() not in ("", "void")]
        self.functions[name] = (Parameter(result.strip() + " result", self._number), parameters, comment.strip())
