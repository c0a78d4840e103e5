// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
import clipc from 'clipc/vite';

export default { plugins: [clipc({ target: 'webgl2' })] };
