// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// NOT Slang: stubs of the interfaces of Slang that examples/pass/slang.cpp calls, with their names
// and signatures and no more of their functions. Its compiler returns the HLSL that it is given,
// after stub::ProblemOf has found nothing against it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "examples/pass/stubs/accept.h"

// NOLINTBEGIN: names of Slang.
#define SLANG_NO_THROW
#define SLANG_MCALL
#define SLANG_SUCCEEDED(result) ((result) >= 0)

using SlangResult = std::int32_t;
using SlangInt = std::int64_t;
inline constexpr SlangResult SLANG_OK = 0, SLANG_FAIL = -1, SLANG_E_NO_INTERFACE = -2;
enum SlangCompileTarget { SLANG_SPIRV = 6 };
enum SlangProfileID : unsigned { SLANG_PROFILE_UNKNOWN };
enum SlangStage { SLANG_STAGE_VERTEX = 1 };
struct SlangUUID {
  int number;
};

struct ISlangUnknown {
  virtual SlangResult queryInterface(const SlangUUID& id, void** object) = 0;
  virtual std::uint32_t addRef() = 0;
  virtual std::uint32_t release() = 0;

 protected:
  ~ISlangUnknown() = default;
};
struct ISlangBlob : ISlangUnknown {
  virtual const void* getBufferPointer() = 0;
  virtual std::size_t getBufferSize() = 0;
};
struct ISlangFileSystem : ISlangUnknown {
  virtual void* castAs(const SlangUUID& id) = 0;
  virtual SlangResult loadFile(const char* path, ISlangBlob** blob) = 0;
};

namespace slang {

using IBlob = ISlangBlob;
struct TargetDesc {
  SlangCompileTarget format = SLANG_SPIRV;
  SlangProfileID profile = SLANG_PROFILE_UNKNOWN;
};
struct SessionDesc {
  const TargetDesc* targets = nullptr;
  SlangInt targetCount = 0;
  ISlangFileSystem* fileSystem = nullptr;
};
struct IComponentType : ISlangUnknown {
  virtual SlangResult link(IComponentType** linked, IBlob** messages) = 0;
  virtual SlangResult getEntryPointCode(SlangInt entry, SlangInt target, IBlob** code,
                                        IBlob** messages) = 0;
};
using IEntryPoint = IComponentType;
struct IModule : IComponentType {
  virtual SlangResult findAndCheckEntryPoint(const char* name, SlangStage stage,
                                             IEntryPoint** entry, IBlob** messages) = 0;
};
struct ISession : ISlangUnknown {
  virtual IModule* loadModuleFromSourceString(const char* name, const char* path, const char* text,
                                              IBlob** messages) = 0;
  virtual SlangResult createCompositeComponentType(IComponentType* const* parts, SlangInt count,
                                                   IComponentType** program, IBlob** messages) = 0;
};
struct IGlobalSession : ISlangUnknown {
  virtual SlangResult createSession(const SessionDesc& description, ISession** session) = 0;
  virtual SlangProfileID findProfile(const char* name) = 0;
};

}  // namespace slang

namespace stub {

template <typename Interface>
class Object : public Interface {
 public:
  SlangResult queryInterface(const SlangUUID&, void**) final { return SLANG_E_NO_INTERFACE; }
  std::uint32_t addRef() final { return ++count_; }
  std::uint32_t release() final {
    const std::uint32_t left = --count_;
    if (left == 0) delete this;
    return left;
  }

 protected:
  virtual ~Object() = default;

 private:
  std::uint32_t count_ = 1;
};

class Blob final : public Object<ISlangBlob> {
 public:
  explicit Blob(std::string text) : text_(std::move(text)) {}
  const void* getBufferPointer() override { return text_.c_str(); }
  std::size_t getBufferSize() override { return text_.size(); }

 private:
  std::string text_;
};

// The module, which is its own entry point, composition and linked program.
class Module final : public Object<slang::IModule> {
 public:
  explicit Module(std::string text) : text_(std::move(text)) {}
  SlangResult Share(slang::IComponentType** other) {
    addRef();
    *other = this;
    return SLANG_OK;
  }
  SlangResult link(slang::IComponentType** linked, ISlangBlob**) override { return Share(linked); }
  SlangResult findAndCheckEntryPoint(const char*, SlangStage, slang::IEntryPoint** entry,
                                     ISlangBlob**) override {
    return Share(entry);
  }
  SlangResult getEntryPointCode(SlangInt, SlangInt, ISlangBlob** code, ISlangBlob**) override {
    *code = new Blob(text_);
    return SLANG_OK;
  }

 private:
  std::string text_;
};

class Session final : public Object<slang::ISession> {
 public:
  explicit Session(ISlangFileSystem* files) : files_(files) {}
  slang::IModule* loadModuleFromSourceString(const char*, const char*, const char* text,
                                             ISlangBlob** messages) override {
    const auto can_read = [&](const std::string& name) {
      ISlangBlob* blob = nullptr;
      files_->loadFile(name.c_str(), &blob);
      if (blob) blob->release();
      return blob != nullptr;
    };
    const std::string problem = ProblemOf(text, can_read);
    if (!problem.empty()) {
      *messages = new Blob(problem);
      return nullptr;
    }
    return module_ = new Module(text);
  }
  SlangResult createCompositeComponentType(slang::IComponentType* const*, SlangInt,
                                           slang::IComponentType** program, ISlangBlob**) override {
    return module_->Share(program);
  }

 private:
  ~Session() override {
    if (module_) module_->release();
  }

  ISlangFileSystem* files_;
  Module* module_ = nullptr;
};

class GlobalSession final : public Object<slang::IGlobalSession> {
 public:
  SlangResult createSession(const slang::SessionDesc& description,
                            slang::ISession** session) override {
    *session = new Session(description.fileSystem);
    return SLANG_OK;
  }
  SlangProfileID findProfile(const char*) override { return SLANG_PROFILE_UNKNOWN; }
};

}  // namespace stub

inline ISlangBlob* slang_createBlob(const void* data, std::size_t size) {
  return new stub::Blob({static_cast<const char*>(data), size});
}

namespace slang {

inline SlangResult createGlobalSession(IGlobalSession** session) {
  *session = new stub::GlobalSession;
  return SLANG_OK;
}

}  // namespace slang
// NOLINTEND
