// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The rules of eslint, run by tools/checks/check_scripts.py. The packages are those of web/page/package.json.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../build/web/page/package.json', import.meta.url));
const globals = require('globals');
const js = require('@eslint/js');

export default [
  js.configs.recommended,
  { languageOptions: { globals: { ...globals.browser, ...globals.node } } },
];
