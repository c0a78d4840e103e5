// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "compiler/effect/effect_facts.h"
#include "compiler/effect/gl_sampling.h"
#include "compiler/effect/gl_states.h"
#include "compiler/effect/vulkan_states.h"

// An effect for OpenGL: the clipc_gl_effect_table of effect-runtime/effect.h as a value. Numbers
// count in the lists of GlEffect.
namespace clipc {

struct GlRange {
  std::size_t first = 0, count = 0;
};

struct GlEffect {
  struct Technique {
    std::string name;
    GlRange passes, annotations;
  };
  struct Pass {
    std::string name;
    std::size_t program = 0;
    GlRange states, annotations, vulkan;
  };
  struct Program {
    std::shared_ptr<const EffectCode> code;
    GlRange uses, samplers, planes;
  };
  struct Use {
    std::string name;  // of the block in the GLSL
    std::size_t block = 0;
  };
  struct Sampler {
    std::string name;  // of the uniform in the GLSL
    std::size_t texture = 0, sampling = 0;
  };
  struct Plane {
    std::uint32_t index = 0;
    std::string text;
  };
  struct Texture {
    std::string name;
    std::uint32_t target = 0;
    GlRange annotations = {};  // set at the end
    friend bool operator==(const Texture& a, const Texture& b) {
      return a.name == b.name && a.target == b.target;
    }
  };
  struct Place {
    std::size_t block = 0;
    std::uint32_t offset = 0;
    bool row_major = false;
  };
  struct Parameter {
    std::string name, semantic;
    std::uint32_t rows = 0, columns = 0, elements = 0;  // of a struct: 0, the bytes, 0
    std::vector<Place> places;
    GlRange annotations;
    std::vector<std::uint32_t> value;  // the words of its default; empty: it has none
  };

  std::vector<Technique> techniques;
  std::vector<Pass> passes;
  std::vector<GlState> states;
  std::vector<VulkanState> vulkan_states;
  std::vector<Program> programs;
  std::vector<Use> uses;
  std::vector<Sampler> samplers;
  std::vector<Plane> planes;
  std::vector<Texture> textures;
  std::vector<GlSampling> samplings;
  std::vector<Parameter> parameters;
  std::vector<std::uint32_t> block_sizes;
  std::vector<ast::Annotation> annotations;
};

// Makes the table of the programs that are compiled. `flips` says that the image is upside down.
// Reports what the table cannot have.
GlEffect MakeGlEffect(const EffectFacts& effect, bool flips, Diagnostics& diagnostics);

}  // namespace clipc
