"""Builds the wheel, for pip and for `make python`; it needs a C compiler alone.

    python3 build_wheel.py FOLDER       writes FOLDER/tumble-VERSION-....whl

CC names the compiler, cc if it does not; TUMBLE_OBJECT an object of the whole
library that is built already.
"""

import base64
import glob
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
LIB = os.path.dirname(HERE)
# The same bits everywhere, and no name seen but those of tumble.h.
FLAGS = ["-std=c11", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-fvisibility=hidden",
         "-include", os.path.join(LIB, "mended.h")]


def version():
    with open(os.path.join(LIB, "tumble.h"), encoding="utf-8") as header:
        return re.search(r'#define TUMBLE_VERSION "(.*)"', header.read()).group(1)


def compile_library(path):
    """Compiles the library to a shared one."""
    built = os.environ.get("TUMBLE_OBJECT")
    rooms = glob.glob(os.path.join(LIB, "*", ""))
    parts = [os.path.abspath(built)] if built else sorted(glob.glob(os.path.join(LIB, "*", "*.c")))
    pic = [] if os.name == "nt" else ["-fPIC"]
    command = [*os.environ.get("CC", "cc").split(), "-shared", "-s", *pic, *FLAGS, "-I" + LIB, *("-I" + r for r in rooms),
               *parts, "-lm", "-o", path]
    subprocess.run(command, check=True)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"tumble-{version()}"
    tag = "py3-none-" + re.sub(r"[^A-Za-z0-9]", "_", sysconfig.get_platform())
    library = "tumble.dll" if os.name == "nt" else "libtumble.so"
    content = {}
    with tempfile.TemporaryDirectory() as folder:
        compile_library(os.path.join(folder, library))
        for file, source in [(library, folder), ("__init__.py", os.path.join(HERE, "tumble")),
                             ("header.py", os.path.join(HERE, "tumble")), ("tumble.h", LIB)]:
            with open(os.path.join(source, file), "rb") as f:
                content["tumble/" + file] = f.read()
    with open(os.path.join(LIB, "..", "LICENSE"), "rb") as f:
        content[f"{name}.dist-info/LICENSE"] = f.read()
    content[f"{name}.dist-info/METADATA"] = (
        f"Metadata-Version: 2.1\nName: tumble\nVersion: {version()}\n"
        "Summary: Rigid bodies, rope and cloth of particles and sticks\nLicense: MIT\nRequires-Python: >=3.8\n").encode()
    content[f"{name}.dist-info/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: tumble\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    record = f"{name}.dist-info/RECORD"
    lines = [f"{path},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}"
             for path, data in content.items()]
    content[record] = "\n".join([*lines, record + ",,", ""]).encode()
    with zipfile.ZipFile(os.path.join(wheel_directory, f"{name}-{tag}.whl"), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in content.items():
            wheel.writestr(path, data)
    return f"{name}-{tag}.whl"


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("tumble is built from its own tree: pip install tumble/lib/python")


if __name__ == "__main__":
    print(os.path.join(sys.argv[1], build_wheel(sys.argv[1])))
