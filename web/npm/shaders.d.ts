// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The exports of a shader, `import { glsl } from './water.hlsl'`: /// <reference types="clipc/shaders" />
declare module '*.hlsl' {
  export const glsl: string;
  export const hlsl: string;
  export const discard: string;
  export const geometry: string;
  export const pixel: string;
  export const table: any;
  export const reflection: any;
  export default glsl;
}
