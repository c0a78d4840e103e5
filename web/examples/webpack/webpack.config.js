// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
export default {
  mode: 'development',
  entry: './main.js',
  module: { rules: [{ test: /\.hlsl$/, loader: 'clipc/webpack', options: { target: 'webgl2' } }] },
  devServer: { static: '.' },
};
