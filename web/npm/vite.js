// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A plugin: plugins: [clipc({ target: 'webgl2' })]
import { readFile } from 'node:fs/promises';

import { compileModule } from './shader.js';

export default function clipc(options = {}) {
  return {
    name: 'clipc',
    enforce: 'pre',
    async load(id) {
      const [path, query = ''] = id.split('?');
      if (!/\.(hlsl|fx)$/.test(path) || /(^|&)(raw|url)(&|$)/.test(query)) return null;
      const { result, files, code } = await compileModule(
        path,
        await readFile(path, 'utf8'),
        query,
        options,
      );
      for (const file of files) this.addWatchFile(file);
      const first = result.diagnostics.find(({ severity }) => severity === 'error');
      const loc = first?.line
        ? { file: first.file, line: first.line, column: first.column - 1 }
        : undefined;
      if (!result.ok) this.error({ message: result.messages, id: path, loc });
      if (result.messages) this.warn(result.messages);
      return { code, map: { mappings: '' } };
    },
  };
}
