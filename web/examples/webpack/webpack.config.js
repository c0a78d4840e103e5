// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
export default {
  mode: 'development',
  entry: './main.js',
  module: { rules: [{ test: /\.hlsl$/, loader: 'clipc/webpack', options: { target: 'webgl2' } }] },
  devServer: { static: '.', devMiddleware: { publicPath: '/dist/' } }, // where index.html and `npm run build` have it
};
