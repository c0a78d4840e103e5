// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The compiler over an instance of clipc.wasm; web/module/module.cpp is the other side.
import { wordsOf } from './options.js';
import { emptySystem } from './system.js';

const STATUS = ['compiled', 'errors', 'bad-request', 'no-memory', 'cancelled', 'known'];
const PART = {
  messages: 0,
  messagesJson: 1,
  dependencies: 2,
  glsl: 3,
  discard: 4,
  spirv: 5,
  reflection: 6,
  tableJson: 7,
  tableBinary: 8,
  tableHeader: 9,
  pixelSpirv: 10,
  hlsl: 11,
  effect: 14,
};
const STOPPED = 'clipc: error: the shader needs more stack or memory than WebAssembly gives\n';

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Strings as the module takes lists of them: a zero after each. */
export function listOf(strings) {
  for (const string of strings) {
    if (string.includes('\0')) throw new TypeError('clipc: a name or an option contains a zero');
  }
  return encoder.encode(strings.map((string) => string + '\0').join(''));
}

/** An instance of the module, with what JavaScript needs to call it. */
export class Instance {
  /** @param {(path: string) => string | Uint8Array | null | undefined} readInclude */
  constructor(module, system, readInclude) {
    const imports = { clipc: { read_include: (path, to) => this.#readInclude(path, to) } };
    imports.wasi_snapshot_preview1 = system ?? emptySystem(module, () => this.exports.memory);
    this.readInclude = readInclude;
    this.instance = new WebAssembly.Instance(module, imports);
    this.exports = this.instance.exports;
  }

  bytesAt(address, size) {
    return new Uint8Array(this.exports.memory.buffer, address, size);
  }

  textAt(address) {
    const rest = new Uint8Array(this.exports.memory.buffer, address);
    return decoder.decode(rest.subarray(0, rest.indexOf(0)));
  }

  /** The address of a copy of `bytes`, which clipc_module_free takes. */
  copy(bytes) {
    const address = this.exports.clipc_module_allocate(bytes.length + 1);
    if (!address) throw new RangeError('clipc: no memory');
    this.bytesAt(address, bytes.length).set(bytes);
    return address;
  }

  /** A copy of a part of the last result. */
  part(number) {
    return this.#copyOf(this.exports.clipc_module_part(number));
  }

  /** A copy of a part of a program of the last result, which is an effect's. */
  programPart(program, number) {
    return this.#copyOf(this.exports.clipc_module_program_part(program, number));
  }

  /** A part of shader `index` of the last result, or of its program of that number; -1: of the result itself. */
  shaderPart(program, index, what) {
    return this.#copyOf(this.exports.clipc_module_shader(program, index, what));
  }

  /** A copy of the bytes that the pair of an address and a size at `at` names. */
  #copyOf(at) {
    const pair = new Uint32Array(this.exports.memory.buffer, at, 2);
    return this.bytesAt(pair[0], pair[1]).slice();
  }

  #readInclude(path, to) {
    const text = this.readInclude(this.textAt(path));
    if (text === undefined || text === null) return 0;
    const bytes = typeof text === 'string' ? encoder.encode(text) : text;
    const address = this.copy(bytes);
    new Uint32Array(this.exports.memory.buffer, to, 2).set([address, bytes.length]);
    return 1;
  }
}

const text = (bytes) => decoder.decode(bytes);
const json = (bytes) => (bytes.length ? JSON.parse(text(bytes)) : null);

/** Compiles shaders one after the other, and keeps what they share. */
export class Compiler {
  #module;
  #instance = null;

  /** @param {WebAssembly.Module} module clipc.wasm, compiled */
  constructor(module) {
    this.#module = module;
  }

  get version() {
    const instance = this.#started(() => null);
    return instance.textAt(instance.exports.clipc_module_version());
  }

  compile(source, options = {}) {
    const { words, isPair, mistake } = wordsOf(options);
    if (mistake) return nothing('bad-request', mistake);
    const strings = listOf([options.path ?? 'shader.hlsl', ...words]);
    const shader = typeof source === 'string' ? encoder.encode(source) : source;
    let thrown = null;
    const readInclude = (path) => {
      try {
        return options.readInclude?.(path);
      } catch (error) {
        thrown ??= error;
        return null;
      }
    };
    try {
      const instance = this.#started(readInclude);
      const result = this.#compile(instance, strings, shader, isPair);
      if (thrown) throw thrown;
      return result;
    } catch (error) {
      if (error === thrown) throw error;
      // The stack or the memory is at its end, and the instance is not to be called again.
      this.#instance = null;
      if (error instanceof RangeError || error instanceof WebAssembly.RuntimeError)
        return nothing('no-memory', STOPPED);
      throw error;
    }
  }

  /** Whether a compile since the last question needed glslang, which the page's first module does not have. */
  get missedGlslang() {
    return Boolean(this.#instance?.exports.clipc_module_missed_glslang?.());
  }

  /** The text of `result.spirv`, for people to read. */
  disassemble(spirv) {
    const instance = this.#started(() => null);
    const { clipc_module_disassemble: run, clipc_module_free: free, memory } = instance.exports;
    const at = instance.copy(new Uint8Array(spirv.buffer, spirv.byteOffset, spirv.byteLength));
    const place = run(at, spirv.length);
    const pair = new Uint32Array(memory.buffer, place, 2); // run may have moved the memory
    const listing = text(instance.bytesAt(pair[0], pair[1]));
    free(at);
    return listing;
  }

  #started(readInclude) {
    if (!this.#instance) {
      this.#instance = new Instance(this.#module, null, readInclude);
      this.#instance.exports._initialize();
    }
    this.#instance.readInclude = readInclude;
    return this.#instance;
  }

  #compile(instance, strings, shader, isPair) {
    const { clipc_module_compile: run, clipc_module_free: free } = instance.exports;
    const stringsAt = instance.copy(strings);
    const shaderAt = instance.copy(shader);
    const status = STATUS[run(stringsAt, strings.length, shaderAt, shader.length)];
    free(stringsAt);
    free(shaderAt);
    const part = (name) => instance.part(PART[name]);
    return {
      ok: status === 'compiled',
      status,
      messages: text(part('messages')),
      diagnostics: json(part('messagesJson'))?.diagnostics ?? [],
      dependencies: text(part('dependencies')).split('\n').slice(0, -1),
      glsl: text(part('glsl')),
      discard: isPair ? '' : text(part('discard')),
      pixel: isPair ? text(part('discard')) : '',
      shaders: shadersOf(instance, -1),
      spirv: new Uint32Array(part('spirv').buffer),
      pixelSpirv: new Uint32Array(part('pixelSpirv').buffer),
      reflection: json(part('reflection')),
      table: json(part('tableJson')),
      tableBinary: part('tableBinary'),
      tableHeader: text(part('tableHeader')),
      hlsl: text(part('hlsl')),
      effect: effectOf(instance, json(part('effect'))),
    };
  }
}

/** The shaders of the last result, or of its program of that number, in the order of the pipeline. */
function shadersOf(instance, program) {
  const shaders = [];
  for (;;) {
    const part = (what) => instance.shaderPart(program, shaders.length, what);
    const stage = text(part(0));
    if (!stage) return shaders;
    shaders.push({ stage, text: text(part(1)), spirv: new Uint32Array(part(2).buffer) });
  }
}

/** The JSON of an effect, with what its programs became; null where there is no effect. */
function effectOf(instance, effect) {
  for (const technique of effect?.techniques ?? []) {
    for (const pass of technique.passes) {
      for (const program of pass.programs) {
        const part = (name) => instance.programPart(program.number, PART[name]);
        program.glsl = text(part('glsl'));
        program.pixel = text(part('discard'));
        program.spirv = new Uint32Array(part('spirv').buffer);
        program.pixelSpirv = new Uint32Array(part('pixelSpirv').buffer);
        program.reflection = json(part('reflection'));
        program.code = shadersOf(instance, program.number);
      }
    }
  }
  return effect;
}

/** The result of a call that compiles nothing. */
export function nothing(status, messages) {
  return {
    ok: false,
    status,
    messages,
    diagnostics: [],
    dependencies: [],
    glsl: '',
    discard: '',
    pixel: '',
    shaders: [],
    spirv: new Uint32Array(),
    pixelSpirv: new Uint32Array(),
    reflection: null,
    table: null,
    tableBinary: new Uint8Array(),
    tableHeader: '',
    hlsl: '',
    effect: null,
  };
}
