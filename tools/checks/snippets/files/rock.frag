#version 330
in vec3 fragNormal;
flat in int material;
out vec4 colour;
void main() { colour = vec4(fragNormal, float(material)); }
