# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""libclipc in Python, by ctypes: one HLSL shader or effect in, GLSL, SPIR-V, reflection and clip table out, all in
memory.

    compiler = clipc.Compiler()
    result = compiler.compile(text, path="water.hlsl", options=["-T", "vs_5_0"])
    print(result.glsl if result.ok else result.messages)

An effect, with the option --effect, has a program for each pass:

    result = compiler.compile(text, path="water.fx", options=["--effect", "--target=glsl330"])
    for technique in result.effect["techniques"]:
        for each in technique["passes"]:
            for program in each["programs"]:
                print(program["glsl"], program["pixel"])

The library is `libclipc.so.1` where the system's linker finds it, or the file that the environment variable
CLIPC_LIBRARY names. One Compiler serves one thread at a time.
"""

import ctypes
import dataclasses
import json
import os

ABI = 1
_STATUS = ("compiled", "has-errors", "bad-request", "no-memory", "cancelled")
# The numbers of clipc_part.
_PARTS = {
    "messages": 0,
    "messages_json": 1,
    "dependencies": 2,
    "glsl": 3,
    "pixel": 4,
    "spirv": 5,
    "reflection": 6,
    "table_json": 7,
    "pixel_spirv": 10,
    "hlsl": 11,
    "effect": 14,
}


class _Bytes(ctypes.Structure):
    _fields_ = (("data", ctypes.c_void_p), ("size", ctypes.c_size_t))


_ReadInclude = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(_Bytes)
)
_IsCancelled = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)


# The structs of clipc_effect.h, as far as they lead to the programs. A list is a pointer to pointers and a number.
class _Program(ctypes.Structure):
    _fields_ = (
        ("shaders", ctypes.c_void_p),
        ("shader_count", ctypes.c_size_t),
        ("result", ctypes.c_void_p),
        ("number", ctypes.c_size_t),
    )


class _Pass(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_char_p),
        ("is_left_out", ctypes.c_int),
        ("annotations", ctypes.c_void_p),
        ("annotation_count", ctypes.c_size_t),
        ("programs", ctypes.POINTER(ctypes.POINTER(_Program))),
        ("program_count", ctypes.c_size_t),
    )


class _Technique(ctypes.Structure):
    _fields_ = (
        ("kind", ctypes.c_char_p),
        ("group", ctypes.c_char_p),
        ("name", ctypes.c_char_p),
        ("annotations", ctypes.c_void_p),
        ("annotation_count", ctypes.c_size_t),
        ("passes", ctypes.POINTER(ctypes.POINTER(_Pass))),
        ("pass_count", ctypes.c_size_t),
    )


class _Effect(ctypes.Structure):
    _fields_ = (
        ("techniques", ctypes.POINTER(ctypes.POINTER(_Technique))),
        ("technique_count", ctypes.c_size_t),
    )


class _Shader(ctypes.Structure):
    _fields_ = (("stage", ctypes.c_char_p), ("text", _Bytes), ("spirv", _Bytes))


class _Request(ctypes.Structure):
    _fields_ = (
        ("size", ctypes.c_size_t),
        ("path", ctypes.c_char_p),
        ("text", ctypes.c_char_p),
        ("text_size", ctypes.c_size_t),
        ("options", ctypes.POINTER(ctypes.c_char_p)),
        ("option_count", ctypes.c_size_t),
        ("read_include", _ReadInclude),
        ("read_include_context", ctypes.c_void_p),
        ("is_cancelled", _IsCancelled),
        ("is_cancelled_context", ctypes.c_void_p),
    )


@dataclasses.dataclass
class Result:
    """What a compile gave. After an error only the messages and the dependencies are filled."""

    status: str  # compiled, has-errors, bad-request or cancelled
    messages: str  # as a terminal shows them
    diagnostics: list  # dictionaries: severity, name, code, message, file, line, column, ...
    dependencies: list  # the files that were read
    glsl: str
    pixel: str  # the pixel shader of a pair; with --lower=discard alone: GLSL that discards
    hlsl: str  # with --target=hlsl
    spirv: bytes
    pixel_spirv: bytes
    reflection: dict
    table: dict  # the clip table
    effect: dict  # with --effect: docs/effects.md; its programs have glsl, pixel, spirv, pixel_spirv, reflection and code
    # The shaders in the order of the pipeline, dictionaries: stage, text, spirv. `code` of a program is such a list.
    shaders: list

    @property
    def ok(self):
        return self.status == "compiled"


def _load():
    library = ctypes.CDLL(os.environ.get("CLIPC_LIBRARY", "libclipc.so.1"))
    library.clipc_compiler_create.restype = ctypes.c_void_p
    library.clipc_compiler_free.argtypes = (ctypes.c_void_p,)
    library.clipc_compile.argtypes = (
        ctypes.c_void_p,
        ctypes.POINTER(_Request),
        ctypes.POINTER(ctypes.c_void_p),
    )
    library.clipc_result_free.argtypes = (ctypes.c_void_p,)
    library.clipc_result_get.argtypes = (ctypes.c_void_p, ctypes.c_int)
    library.clipc_result_get.restype = _Bytes
    library.clipc_result_shader.argtypes = (ctypes.c_void_p, ctypes.c_size_t)
    library.clipc_result_shader.restype = ctypes.POINTER(_Shader)
    library.clipc_result_effect.argtypes = (ctypes.c_void_p,)
    library.clipc_result_effect.restype = ctypes.POINTER(_Effect)
    if library.clipc_abi() != ABI:
        raise ImportError(f"this is written for ABI {ABI}, and libclipc has {library.clipc_abi()}")
    return library


class Compiler:
    """A compiler of many shaders that keeps the data that they share."""

    def __init__(self):
        self._library = _load()
        self._compiler = self._library.clipc_compiler_create()
        if not self._compiler:
            raise MemoryError("clipc_compiler_create")

    def __del__(self):
        if getattr(self, "_compiler", None):
            self._library.clipc_compiler_free(self._compiler)

    def compile(self, text, path="shader.hlsl", options=(), read_include=None):
        """Compiles a shader. `options` are the command line's, but none that names files.

        `read_include`, if there is one, gets the path of each include file and returns its text, or None where there is
        no such file.
        """
        source = text.encode()
        words = [word.encode() for word in options]
        request = _Request(size=ctypes.sizeof(_Request), path=path.encode())
        request.text, request.text_size = source, len(source)
        request.options = (ctypes.c_char_p * len(words))(*words)
        request.option_count = len(words)
        kept = []  # the text of an include lives until the compile ends

        def read(_, include, to):
            found = read_include(os.fsdecode(include))
            if found is None:
                return 0
            kept.append(ctypes.create_string_buffer(found.encode()))
            to.contents.data = ctypes.addressof(kept[-1])
            to.contents.size = len(kept[-1]) - 1
            return 1

        if read_include:
            request.read_include = _ReadInclude(read)
        made = ctypes.c_void_p()
        status = self._library.clipc_compile(
            self._compiler, ctypes.byref(request), ctypes.byref(made)
        )
        if not made:
            raise MemoryError("clipc_compile")
        try:
            parts = {name: self._part(made, number) for name, number in _PARTS.items()}
            shaders = self._shaders(made)
            effect = self._effect(made, json.loads(parts["effect"] or b"{}"))
        finally:
            self._library.clipc_result_free(made)
        return self._result(_STATUS[status], parts, effect, shaders)

    def _shaders(self, result):
        shaders = []
        while shader := self._library.clipc_result_shader(result, len(shaders)):
            each = shader.contents
            texts = [ctypes.string_at(part.data, part.size) for part in (each.text, each.spirv)]
            shaders.append(
                {"stage": each.stage.decode(), "text": texts[0].decode(), "spirv": texts[1]}
            )
        return shaders

    def _effect(self, result, document):
        """The JSON of an effect, with what its programs became."""
        effect = self._library.clipc_result_effect(result)
        for i, technique in enumerate(document.get("techniques", [])):
            for k, each in enumerate(technique["passes"]):
                programs = effect.contents.techniques[i].contents.passes[k].contents.programs
                for n, program in enumerate(each["programs"]):
                    self._fill(programs[n].contents.result, program)
        return document

    def _fill(self, result, program):
        def part(name):
            return self._part(result, _PARTS[name]) if result else b""

        for name in ("glsl", "pixel"):
            program[name] = part(name).decode()
        for name in ("spirv", "pixel_spirv"):
            program[name] = part(name)
        program["code"] = self._shaders(result) if result else []
        program["reflection"] = json.loads(part("reflection") or b"{}")

    def _part(self, result, number):
        part = self._library.clipc_result_get(result, number)
        return ctypes.string_at(part.data, part.size)

    @staticmethod
    def _result(status, parts, effect, shaders):
        document = json.loads(parts["messages_json"] or b"{}")
        return Result(
            status=status,
            messages=parts["messages"].decode(errors="replace"),
            diagnostics=document.get("diagnostics", []),
            dependencies=os.fsdecode(parts["dependencies"]).splitlines(),
            glsl=parts["glsl"].decode(),
            pixel=parts["pixel"].decode(),
            hlsl=parts["hlsl"].decode(),
            spirv=parts["spirv"],
            pixel_spirv=parts["pixel_spirv"],
            reflection=json.loads(parts["reflection"] or b"{}"),
            table=json.loads(parts["table_json"] or b"{}"),
            effect=effect,
            shaders=shaders,
        )
