#version 450
#extension GL_ARB_shading_language_packing : enable
// void main() { in a comment }
layout(location = 0) in vec4 color;
layout(location = 0) out vec4 pixel;

float clip_planes = 1.0;

void main()
{
    pixel = color * clip_planes;
}
