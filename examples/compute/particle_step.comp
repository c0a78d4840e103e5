#version 450

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct Particle {
    vec3 position;
    float age;
    vec3 velocity;
    float lifetime;
};

layout(std140, binding = 0) uniform Step {  // b0
    vec3 gravity;
    float seconds;
    float ground;
    float bounce;
} step_;

layout(std430, binding = 0) readonly buffer before_block {  // t0
    Particle before[];
};
layout(std430, binding = 1) buffer after_block {  // u0
    Particle after[];
};
layout(std430, binding = 2) buffer alive_block {  // u1
    uint alive[];
};
layout(std430, binding = 3) buffer counter_var_alive_block {  // the counter of alive
    uint counter_var_alive[];
};

void shader_main(uint id) {
    uint count;
    uint stride;
    count = uint(before.length());
    stride = 32u;
    if (id >= count) {
        return;
    }
    Particle p = before[id];
    p.age += step_.seconds;
    p.velocity += step_.gravity * step_.seconds;
    p.position += p.velocity * step_.seconds;
    if (p.position.y < step_.ground) {
        p.position.y = step_.ground;
        p.velocity.y *= -step_.bounce;
    }
    after[id] = p;
    if (p.age < p.lifetime) {
        alive[atomicAdd(counter_var_alive[0], 1u)] = id;
    }
}

void main() {
    shader_main(gl_GlobalInvocationID.x);
}
