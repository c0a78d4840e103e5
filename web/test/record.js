// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Runs in a page before its own scripts. Draws of triangles by WebGL 2 are kept as descriptions that `clipc-draw image` draws
// too: window.draws, by the canvas's id. Images are not smoothed, and stay to be read.
(() => {
  const gl2 = WebGL2RenderingContext.prototype;
  const [texts, parts, names, data, states] = [
    new WeakMap(),
    new WeakMap(),
    new WeakMap(),
    new WeakMap(),
    new WeakMap(),
  ];
  window.draws = {};

  const context = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return context.call(
      this,
      kind,
      kind === 'webgl2' ? { ...options, antialias: false, preserveDrawingBuffer: true } : options,
    );
  };

  /** Calls `note(gl, arguments, result)` after each call of a function of WebGL. */
  const after = (name, note) => {
    const call = gl2[name];
    gl2[name] = function (...given) {
      const result = call.apply(this, given);
      note(this, given, result);
      return result;
    };
  };
  const state = (gl) => {
    if (!states.has(gl))
      states.set(gl, {
        bound: {},
        bases: {},
        arrays: {},
        constants: {},
        uniforms: new Map(),
        distances: 0,
        reversed: false,
        clear: [0, 0, 0, 0],
      });
    return states.get(gl);
  };
  const bits = (floats) => [...new Uint32Array(new Float32Array(floats).buffer)];

  after('shaderSource', (gl, [shader, text]) => texts.set(shader, text));
  after('attachShader', (gl, [program, shader]) =>
    parts.set(program, [...(parts.get(program) ?? []), shader]),
  );
  after('useProgram', (gl, [program]) => (state(gl).program = program));
  after('bindBuffer', (gl, [target, buffer]) => (state(gl).bound[target] = buffer));
  after('bindBufferBase', (gl, [target, index, buffer]) => {
    state(gl).bound[target] = buffer;
    state(gl).bases[index] = buffer;
  });
  after('bufferData', (gl, [target, values]) => {
    if (typeof values === 'number') return;
    const bytes = ArrayBuffer.isView(values)
      ? values.buffer.slice(values.byteOffset, values.byteOffset + values.byteLength)
      : values.slice(0);
    data.set(state(gl).bound[target], bytes);
  });
  after(
    'vertexAttribPointer',
    (gl, [index, size]) =>
      (state(gl).arrays[index] = {
        ...state(gl).arrays[index],
        size,
        buffer: state(gl).bound[gl.ARRAY_BUFFER],
      }),
  );
  after(
    'enableVertexAttribArray',
    (gl, [index]) => (state(gl).arrays[index] = { ...state(gl).arrays[index], isOn: true }),
  );
  after(
    'disableVertexAttribArray',
    (gl, [index]) => (state(gl).arrays[index] = { ...state(gl).arrays[index], isOn: false }),
  );
  after('vertexAttrib4f', (gl, [index, ...values]) => (state(gl).constants[index] = bits(values)));
  after('vertexAttribI4ui', (gl, [index, ...values]) => (state(gl).constants[index] = values));
  after(
    'vertexAttribI4i',
    (gl, [index, ...values]) => (state(gl).constants[index] = values.map((x) => x >>> 0)),
  );
  after('getUniformLocation', (gl, [, name], place) => place && names.set(place, name));
  for (const width of [1, 2, 3, 4])
    after(`uniform${width}fv`, (gl, [place, values]) =>
      state(gl).uniforms.set(names.get(place), bits(values)),
    );
  after('uniformMatrix4fv', (gl, [place, , m]) =>
    state(gl).uniforms.set(
      names.get(place),
      bits([0, 1, 2, 3].flatMap((column) => [0, 4, 8, 12].map((row) => m[row + column]))),
    ),
  );
  const clip =
    (mask) =>
    (gl, [what]) => {
      if (what >= 0x3000 && what < 0x3008)
        state(gl).distances = mask(state(gl).distances, 1 << (what - 0x3000)); // CLIP_DISTANCE0_WEBGL
    };
  after(
    'enable',
    clip((now, bit) => now | bit),
  );
  after(
    'disable',
    clip((now, bit) => now & ~bit),
  );
  after('clearColor', (gl, color) => (state(gl).clear = color));
  after('clearDepth', (gl, [depth]) => (state(gl).reversed = depth === 0));

  function attributesOf(gl, { program, arrays, constants }, vertices) {
    const attributes = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); ++i) {
      const { name, type } = gl.getActiveAttrib(program, i);
      const location = gl.getAttribLocation(program, name);
      if (location < 0) continue;
      const widths = [
        [gl.FLOAT, gl.FLOAT_VEC2, gl.FLOAT_VEC3, gl.FLOAT_VEC4],
        [gl.INT, gl.INT_VEC2, gl.INT_VEC3, gl.INT_VEC4],
        [gl.UNSIGNED_INT, gl.UNSIGNED_INT_VEC2, gl.UNSIGNED_INT_VEC3, gl.UNSIGNED_INT_VEC4],
      ];
      const width = 1 + Math.max(...widths.map((types) => types.indexOf(type)));
      const { isOn, size, buffer } = arrays[location] ?? {};
      const words = isOn && new Uint32Array(data.get(buffer));
      const rest = bits([0, 0, 0, 1]);
      attributes[name] = Array.from({ length: vertices * width }, (_, at) => {
        const [vertex, part] = [Math.floor(at / width), at % width];
        if (!isOn) return constants[location][part];
        return part < size ? words[vertex * size + part] : rest[part];
      });
    }
    return attributes;
  }

  after('drawElements', (gl, [mode]) => {
    const now = state(gl);
    if (mode !== gl.TRIANGLES) return;
    window.draws[gl.canvas.id] = () => {
      const { program, bound, bases, distances, reversed, clear, uniforms } = now.last;
      const [vertex, fragment] = parts.get(program).map((shader) => texts.get(shader));
      const indices = [...new Uint32Array(data.get(bound[gl.ELEMENT_ARRAY_BUFFER]))];
      const vertices = 1 + indices.reduce((most, x) => Math.max(most, x), 0);
      const blocks = {};
      for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORM_BLOCKS); ++i) {
        const binding = gl.getActiveUniformBlockParameter(program, i, gl.UNIFORM_BLOCK_BINDING);
        blocks[gl.getActiveUniformBlockName(program, i)] = [
          ...new Uint32Array(data.get(bases[binding])),
        ];
      }
      const { width, height } = gl.canvas;
      return {
        vertex,
        fragment,
        width,
        height,
        clear,
        reversed,
        clipDistances: distances,
        float: false,
        vertices,
        indices,
        blocks,
        attributes: attributesOf(gl, now.last, vertices),
        uniforms: Object.fromEntries(uniforms),
      };
    };
    now.last = {
      ...now,
      bound: { ...now.bound },
      bases: { ...now.bases },
      arrays: { ...now.arrays },
      constants: { ...now.constants },
      uniforms: new Map(now.uniforms),
    };
  });
})();
