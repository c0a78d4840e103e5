// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Run by web/build.sh in a copy of this folder, beside the package and the gallery.
import { fileURLToPath } from 'node:url';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

export default {
  mode: 'production',
  entry: './main.js',
  output: {
    path: at('../../page'),
    filename: 'main.js',
    chunkFilename: '[name].js',
    assetModuleFilename: '[name][ext]',
  },
  resolve: { alias: { clipc$: at('../package/browser.js'), clipc: at('../package') } },
  module: {
    rules: [
      { test: /\.wasm$/, type: 'asset/resource' },
      { test: /gallery|\.csv$/, type: 'asset/source' },
    ],
  },
  performance: { hints: false },
};
