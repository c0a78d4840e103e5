#version 100
precision highp float;
void main() { gl_FragColor = vec4(1.0, gl_FragCoord.z, 0.0, 1.0); }
