#version 100
precision mediump float;
varying vec4 vs_COLOR0;

void main() { gl_FragColor = vs_COLOR0; }
