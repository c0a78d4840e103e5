// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A loader: { test: /\.hlsl$/, loader: 'clipc/webpack', options: { target: 'webgl2' } }
import { compileModule } from './shader.js';

export default function loader(text) {
  const done = this.async();
  compileModule(this.resourcePath, text, this.resourceQuery.slice(1), this.getOptions()).then(
    ({ result, files, code }) => {
      for (const file of files) this.addDependency(file);
      if (!result.ok) return done(new Error(result.messages));
      if (result.messages) this.emitWarning(new Error(result.messages));
      done(null, code);
    },
    done,
  );
}
