#version 450
out vec4 color;
void main() { color = vec4(1.0, gl_FragCoord.z, 0.0, 1.0); }
