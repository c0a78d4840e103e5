# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Shaders as a part of a build with Bazel.

    clipc_shader(
        name = "water",
        src = "water.hlsl",
        hdrs = ["planes.hlsli"],
        profile = "vs_5_0",
    )

writes water.vert, water.shader.h (`static const char water_vert[]`) and water.clip.h (`clipc::StaticClipTable water_clip_table`).

    clipc_hlsl(
        name = "water_clipped",
        src = "water.hlsl",
        hdrs = ["planes.hlsli"],
        entries = ["main"],
    )

writes water_clipped.hlsl, with clip distances in place of the clip planes, for a compiler that drops these.

    clipc_permutations(
        name = "permutations",
        srcs = ["water.hlsl"],
        hdrs = ["planes.hlsli"],
        defines = ["FOG={0,1}", "WAVES={0,1,2,3}"],
        parts = 4,
    )

compiles every permutation, in a folder with an index: an action for each part, and one that makes one folder of them. With
`manifest = "shaders.json"`, whose paths begin at the workspace, the sources are its shaders.

An include that is not among `hdrs` is not in the sandbox, and the build fails. The actions read their inputs, write their outputs and
know nothing else, so they may run on any machine of the same kind.
"""

def _run_clipc(ctx, outputs, arguments, mnemonic, message):
    arguments.add("-T", ctx.attr.profile)
    arguments.add("-I.")
    arguments.add_all(ctx.attr.defines, before_each = "-D")
    arguments.add_all(ctx.attr.options)
    ctx.actions.run(
        executable = ctx.executable.clipc,
        inputs = [ctx.file.src] + ctx.files.hdrs,
        outputs = outputs,
        arguments = [arguments],
        env = {},
        mnemonic = mnemonic,
        progress_message = message + ctx.label.name,
    )

def _clipc_shader_impl(ctx):
    name = ctx.label.name
    glsl = ctx.actions.declare_file(name + ".vert")
    header = ctx.actions.declare_file(name + ".shader.h")
    table = ctx.actions.declare_file(name + ".clip.h")
    arguments = ctx.actions.args()
    arguments.add(ctx.file.src)
    arguments.add("-o", glsl)
    arguments.add("-Fh", header)
    arguments.add("-Vn", name + "_vert")
    arguments.add(table, format = "--table=%s")
    arguments.add("-E", ctx.attr.entry)
    arguments.add(ctx.attr.target, format = "--target=%s")
    _run_clipc(ctx, [glsl, header, table], arguments, "ClipcShader", "Compiling shader ")
    headers = depset([header, table])
    return [
        DefaultInfo(files = depset([glsl, header, table])),
        CcInfo(compilation_context = cc_common.create_compilation_context(
            headers = headers,
            includes = depset([header.dirname]),
        )),
    ]

def _clipc_hlsl_impl(ctx):
    hlsl = ctx.actions.declare_file(ctx.label.name + ".hlsl")
    arguments = ctx.actions.args()
    arguments.add(ctx.file.src)
    arguments.add("--target=hlsl")
    arguments.add("-o", hlsl)
    arguments.add_all(ctx.attr.entries, before_each = "-E")
    _run_clipc(ctx, [hlsl], arguments, "ClipcHlsl", "Writing the clip planes as clip distances of ")
    return [DefaultInfo(files = depset([hlsl]))]

def _compile_part(ctx, part):
    folder = ctx.actions.declare_directory("%s.parts/%d" % (ctx.label.name, part))
    arguments = ctx.actions.args()
    if ctx.file.manifest:
        arguments.add(ctx.file.manifest, format = "--batch=%s")
    else:
        arguments.add_all(ctx.files.srcs)
        arguments.add("-T", ctx.attr.profile)
    arguments.add("-I.")
    arguments.add_all(ctx.attr.defines, before_each = "-D")
    arguments.add_all(ctx.attr.options)
    if ctx.attr.parts > 1:
        arguments.add("--shard=%d/%d" % (part, ctx.attr.parts))
    arguments.add_all([folder], before_each = "-o", expand_directories = False)
    ctx.actions.run(
        executable = ctx.executable.clipc,
        inputs = ctx.files.srcs + ctx.files.hdrs + ctx.files.manifest,
        outputs = [folder],
        arguments = [arguments],
        env = {},
        mnemonic = "ClipcPart",
        progress_message = "Compiling part %d of %d of %s" % (part, ctx.attr.parts, ctx.label.name),
    )
    return folder

# $1 is the folder of all parts, $2 the program, and the rest are the folders of the parts.
_MERGE = """
set -eu
out=$1 clipc=$2
shift 2
for part; do cp -R "$part"/. "$out"; done
chmod -R u+w "$out"
[ $# -eq 1 ] || "$clipc" --shard=merge "$out"/index.*-of-$#.json
rm -f "$out"/index.*-of-$#.json
"""

def _clipc_permutations_impl(ctx):
    if not ctx.files.srcs:
        fail("`srcs` has the shaders, those of a manifest too")
    parts = [_compile_part(ctx, part) for part in range(1, ctx.attr.parts + 1)]
    folder = ctx.actions.declare_directory(ctx.label.name)
    arguments = ctx.actions.args()
    arguments.add_all([folder], expand_directories = False)
    arguments.add(ctx.executable.clipc)
    arguments.add_all(parts, expand_directories = False)
    ctx.actions.run_shell(
        command = _MERGE,
        inputs = parts,
        tools = [ctx.executable.clipc],
        outputs = [folder],
        arguments = [arguments],
        mnemonic = "ClipcMerge",
        progress_message = "Merging %d parts of %s" % (ctx.attr.parts, ctx.label.name),
    )
    return [DefaultInfo(files = depset([folder]))]

_ATTRIBUTES = {
    "src": attr.label(allow_single_file = True, mandatory = True),
    "hdrs": attr.label_list(allow_files = True),
    "profile": attr.string(default = "vs_5_0"),
    "defines": attr.string_list(),
    "options": attr.string_list(),
    "clipc": attr.label(default = "@clipc//:clipc", allow_single_file = True, executable = True, cfg = "exec"),
}

clipc_shader = rule(
    implementation = _clipc_shader_impl,
    attrs = dict(
        _ATTRIBUTES,
        entry = attr.string(default = "main"),
        target = attr.string(default = "glsl450"),
    ),
)

clipc_hlsl = rule(
    implementation = _clipc_hlsl_impl,
    attrs = dict(_ATTRIBUTES, entries = attr.string_list()),
)

clipc_permutations = rule(
    implementation = _clipc_permutations_impl,
    attrs = {
        "srcs": attr.label_list(allow_files = True, mandatory = True),
        "hdrs": attr.label_list(allow_files = True),
        "manifest": attr.label(allow_single_file = True),
        "profile": attr.string(default = "vs_5_0"),
        "defines": attr.string_list(),
        "options": attr.string_list(),
        "parts": attr.int(default = 1),
        "clipc": attr.label(default = "@clipc//:clipc", allow_single_file = True, executable = True, cfg = "exec"),
    },
)
