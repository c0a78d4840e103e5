// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What `import { glsl } from './water.hlsl'` gives: /// <reference types="clipc/shaders" />
declare module '*.hlsl' {
  export const glsl: string;
  export const discard: string;
  export const table: any;
  export const reflection: any;
  export default glsl;
}
