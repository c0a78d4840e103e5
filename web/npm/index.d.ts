// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

export interface CompileOptions {
  /** The name of the shader in messages, and where its includes are looked up. Default: "shader.hlsl". */
  path?: string;
  /** `-T`: "vs_5_0", "vs_4_0_level_9_1", ... */
  profile?: string;
  /** `-E`. Default: "main". */
  entry?: string;
  /** `--target`: "glsl450", "vulkan", "webgl1", "webgl2", "hlsl" */
  target?: string;
  /** `--lower`: how clip planes are lowered. */
  lower?: string;
  /** `--geometry-entry`: the geometry shader of the same text is compiled too, between the other two. */
  geometryEntry?: string;
  /** `--hull-entry` and `--domain-entry`: so are the hull and the domain shader. */
  hullEntry?: string;
  domainEntry?: string;
  /** `--pixel-entry`: the pixel shader of the same text is compiled too, and both fit each other. */
  pixelEntry?: string;
  /** `--pixel-shader`: the pixel shader is in the text that `readInclude` gives for this name. */
  pixelShader?: string;
  /** `-D`; `true` defines a name without a value, as `-D NAME` does. */
  defines?: Record<string, string | number | true>;
  /** Any other options of the program, but none that names inputs or outputs: `["-Zpr", "-spirv"]`. */
  options?: string[];
  /**
   * The text of the include file at `path`: a folder of `-I` or of the including file, a slash, and the name as the shader
   * has it. Nothing: there is no such file. What it throws, `compile` throws.
   */
  readInclude?: (path: string) => string | Uint8Array | null | undefined;
}

/** A place in a text: lines and columns from 1, columns in bytes of UTF-8, the end after the last byte. */
export interface Place {
  file?: string;
  line?: number;
  column?: number;
  endLine?: number;
  endColumn?: number;
}

export interface Diagnostic extends Place {
  severity: 'error' | 'warning' | 'note';
  /** As in docs/diagnostics.md: "undeclared-name". */
  name: string;
  /** fxc's code, where it has one: "X3004". */
  code?: string;
  message: string;
  fixes?: (Place & { text: string })[];
  notes?: Diagnostic[];
}

/** A shader of a program. */
export interface Shader {
  /** "vertex", "hull", "domain", "geometry", "pixel" or "compute" */
  stage: string;
  /** GLSL, or with `target: "hlsl"` HLSL */
  text: string;
  /** With the option `-spirv`. */
  spirv: Uint32Array;
}

export interface CompileResult {
  /** Whether `status` is "compiled". */
  ok: boolean;
  /**
   * "errors": the shader has errors. "bad-request": an option is wrong or unknown. "no-memory": the shader needs more memory or stack
   * than WebAssembly gives.
   */
  status: 'compiled' | 'errors' | 'bad-request' | 'no-memory' | 'cancelled';
  /** As a terminal shows them, with the lines of the source. */
  messages: string;
  /** The same for programs. */
  diagnostics: Diagnostic[];
  /** The files that were read. */
  dependencies: string[];
  /** The vertex shader. This and what follows is empty after an error. */
  glsl: string;
  /** With `lower: "discard"`: GLSL that discards, for the fragment shader. */
  discard: string;
  /** The pixel shader, with `pixelEntry`, `pixelShader` or the option `--pixel-output=.frag`. */
  pixel: string;
  /** Every shader of the program, in the order of the pipeline. */
  shaders: Shader[];
  /** With the option `-spirv`. */
  spirv: Uint32Array;
  pixelSpirv: Uint32Array;
  /** docs/reflection.md */
  reflection: any | null;
  /** The clip table, docs/clip-table.schema.json. */
  table: any | null;
  /** The clip table as a record of Direct3D; empty for planes that it cannot say. */
  tableBinary: Uint8Array;
  /** The clip table as a C++ header. */
  tableHeader: string;
  /** With `target: "hlsl"`: the same HLSL with clip distances; `glsl` is empty then. */
  hlsl: string;
  /**
   * With the option `--effect`: docs/effects.md. Each program of a pass has `glsl`, `pixel`, `spirv`, `pixelSpirv` and `reflection`
   * in place of files, and `code`, a list of `Shader`; they are empty where it has errors. It is there after errors too, if the
   * effect could be read.
   */
  effect: any | null;
}

/** Compiles shaders one after the other, and keeps what they share. One for each worker. */
export class Compiler {
  /** `module` is clipc.wasm, compiled. */
  constructor(module: WebAssembly.Module);
  readonly version: string;
  compile(text: string | Uint8Array, options?: CompileOptions): CompileResult;
  /** The text of `CompileResult.spirv`, as `spirv-dis` writes it. */
  disassemble(spirv: Uint32Array): string;
}

/** A compiler of its own. `wasm`: clipc.wasm, compiled; without, it is loaded from the package. */
export function createCompiler(
  wasm?: WebAssembly.Module | Promise<WebAssembly.Module>,
): Promise<Compiler>;

/** Compiles a shader by a compiler that all calls share. It is loaded at the first call. */
export function compile(
  text: string | Uint8Array,
  options?: CompileOptions,
): Promise<CompileResult>;
