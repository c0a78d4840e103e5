// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clipc.h"
#include "clipc_effect.h"

/// clipc.h for C++17: a few inline functions over the C functions, so an application and
/// the library need not be built by the same compiler.
namespace clipc::library {

struct Request {
  /// The name of the shader in messages, and where its includes are looked up.
  std::string path;
  std::optional<std::string> text;   ///< none: the file at `path`
  std::vector<std::string> options;  ///< as on the command line, without inputs and outputs
  /// The text of the pixel shader that the option --pixel-shader names; none: what read_include
  /// gives, or the file.
  std::optional<std::string> pixel_text;
  /// If not empty, includes come from this function, and no file is read for them. The path is a
  /// folder of -I or of the including file, a slash, and the name as the shader has it. Must not
  /// throw.
  std::function<std::optional<std::string>(const std::string& path)> read_include;
  /// If not empty, the compile ends soon after it returns true. Must not throw.
  std::function<bool()> is_cancelled;
  /// If not empty, asked with the key of a cache, clipc_request::is_known; the compile ends with
  /// CLIPC_KNOWN when it returns true. Must not throw.
  std::function<bool(const std::string& key)> is_known;
};

/// The result of a compile. Views of its parts live as long as the result.
class Result {
 public:
  clipc_status status() const { return status_; }
  bool ok() const { return status_ == CLIPC_COMPILED; }
  /// One part of the result; empty where the result does not have the part.
  std::string_view Get(clipc_part part) const {
    if (!result_) return {};
    const clipc_bytes bytes = clipc_result_get(result_.get(), part);
    return {bytes.data, bytes.size};
  }
  /// With --variants: one part of the variant with the first `planes` planes; none past the last.
  std::optional<std::string_view> GetVariant(std::size_t planes, clipc_part part) const {
    const clipc_result* variant = result_ ? clipc_result_variant(result_.get(), planes) : nullptr;
    if (!variant) return std::nullopt;
    const clipc_bytes bytes = clipc_result_get(variant, part);
    return std::string_view(bytes.data, bytes.size);
  }
  /// The reflection as structs; null where there is none.
  const clipc_reflection* reflection() const {
    return result_ ? clipc_result_reflection(result_.get()) : nullptr;
  }
  /// The shader of this number, in the order of the pipeline; null past the last.
  const clipc_shader* shader(std::size_t index) const {
    return result_ ? clipc_result_shader(result_.get(), index) : nullptr;
  }
  /// The message of this number, each before its notes; null past the last.
  const clipc_diagnostic* diagnostic(std::size_t index) const {
    return result_ ? clipc_result_diagnostic(result_.get(), index) : nullptr;
  }
  /// With the option --effect: the techniques, their programs and the parameters; null where the
  /// effect could not be read.
  const clipc_effect* effect() const {
    return result_ ? clipc_result_effect(result_.get()) : nullptr;
  }
  /// One part of a program of an effect; empty where the program has errors.
  static std::string_view GetProgram(const clipc_effect_program& program, clipc_part part) {
    if (!program.result) return {};
    const clipc_bytes bytes = clipc_result_get(program.result, part);
    return {bytes.data, bytes.size};
  }
  std::string_view messages() const { return Get(CLIPC_PART_MESSAGES); }
  std::string_view glsl() const { return Get(CLIPC_PART_GLSL); }
  std::string_view hlsl() const { return Get(CLIPC_PART_HLSL); }

 private:
  friend class Compiler;
  struct Free {
    void operator()(clipc_result* result) const { clipc_result_free(result); }
  };

  clipc_status status_ = CLIPC_NO_MEMORY;
  std::unique_ptr<clipc_result, Free> result_;  ///< null after CLIPC_NO_MEMORY
};

/// A compiler of many shaders that keeps the data that they share. Use one on each thread.
class Compiler {
 public:
  /// Throws std::bad_alloc.
  Compiler() : compiler_(clipc_compiler_create()) {
    if (!compiler_) throw std::bad_alloc();
  }

  Result Compile(const Request& request) {
    std::vector<const char*> options;
    options.reserve(request.options.size());
    for (const std::string& option : request.options) options.push_back(option.c_str());
    Callbacks callbacks{request, {}};
    clipc_request plain{};
    plain.size = sizeof plain;
    plain.path = request.path.c_str();
    if (request.text) {
      plain.text = request.text->data();
      plain.text_size = request.text->size();
    }
    if (request.pixel_text) {
      plain.pixel_text = request.pixel_text->data();
      plain.pixel_text_size = request.pixel_text->size();
    }
    plain.options = options.data();
    plain.option_count = options.size();
    if (request.read_include) {
      plain.read_include = ReadInclude;
      plain.read_include_context = &callbacks;
    }
    if (request.is_cancelled) {
      plain.is_cancelled = IsCancelled;
      plain.is_cancelled_context = &callbacks;
    }
    if (request.is_known) {
      plain.is_known = IsKnown;
      plain.is_known_context = &callbacks;
    }
    Result result;
    clipc_result* made = nullptr;
    result.status_ = clipc_compile(compiler_.get(), &plain, &made);
    result.result_.reset(made);
    return result;
  }

 private:
  struct Callbacks {
    const Request& request;
    std::string text;  ///< of the last include
  };
  static int ReadInclude(void* context, const char* path, clipc_bytes* text) {
    auto& callbacks = *static_cast<Callbacks*>(context);
    auto found = callbacks.request.read_include(path);
    if (!found) return 0;
    callbacks.text = std::move(*found);
    *text = {callbacks.text.data(), callbacks.text.size()};
    return 1;
  }
  static int IsCancelled(void* context) {
    return static_cast<Callbacks*>(context)->request.is_cancelled() ? 1 : 0;
  }
  static int IsKnown(void* context, const char* key) {
    return static_cast<Callbacks*>(context)->request.is_known(key) ? 1 : 0;
  }
  struct Free {
    void operator()(clipc_compiler* compiler) const { clipc_compiler_free(compiler); }
  };

  std::unique_ptr<clipc_compiler, Free> compiler_;
};

}  // namespace clipc::library
