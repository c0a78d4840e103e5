// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Slang by its API, with clipc before it: the shader, what it includes and what comes out are in
// memory. It is built here with stubs of Slang's interfaces (stubs/), as Slang is not in Debian;
// with Slang's own headers and library it writes SPIR-V.
//   pass_slang [without-clipc]
#include <cstdio>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <string>

#include <slang-com-ptr.h>
#include <slang.h>

#include "examples/pass/clip_pass.h"

namespace {

using Slang::ComPtr;

void Check(SlangResult result, slang::IBlob* messages = nullptr) {
  if (SLANG_SUCCEEDED(result)) return;
  const void* text = messages ? messages->getBufferPointer() : "a function of Slang failed";
  throw std::runtime_error(static_cast<const char*>(text));
}

// Gives Slang the includes that clipc was given. It lives longer than the session that takes it.
class Files final : public ISlangFileSystem {
 public:
  explicit Files(const clip_pass::ReadFile& read) : read_(read) {}

  SLANG_NO_THROW SlangResult SLANG_MCALL loadFile(const char* path, ISlangBlob** blob) override {
    const auto text = read_(path);
    if (!text) return SLANG_FAIL;
    *blob = slang_createBlob(text->data(), text->size());
    return SLANG_OK;
  }
  SLANG_NO_THROW void* SLANG_MCALL castAs(const SlangUUID&) override { return nullptr; }
  SLANG_NO_THROW SlangResult SLANG_MCALL queryInterface(const SlangUUID&, void**) override {
    return SLANG_E_NO_INTERFACE;
  }
  SLANG_NO_THROW std::uint32_t SLANG_MCALL addRef() override { return 1; }
  SLANG_NO_THROW std::uint32_t SLANG_MCALL release() override { return 1; }

 private:
  const clip_pass::ReadFile& read_;
};

std::string CompileBySlang(const clip_pass::Shader& shader, const std::string& text) {
  ComPtr<slang::IGlobalSession> global;
  Check(slang::createGlobalSession(global.writeRef()));
  slang::TargetDesc target;
  target.format = SLANG_SPIRV;
  target.profile = global->findProfile("spirv_1_5");
  Files files(shader.read);
  slang::SessionDesc description;
  description.targets = &target;
  description.targetCount = 1;
  description.fileSystem = &files;
  ComPtr<slang::ISession> session;
  Check(global->createSession(description, session.writeRef()));

  ComPtr<slang::IBlob> messages;
  slang::IModule* module = session->loadModuleFromSourceString("shader", shader.path.c_str(),
                                                               text.c_str(), messages.writeRef());
  if (!module) Check(SLANG_FAIL, messages.get());
  ComPtr<slang::IEntryPoint> entry;
  Check(module->findAndCheckEntryPoint(shader.entry.c_str(), SLANG_STAGE_VERTEX, entry.writeRef(),
                                       messages.writeRef()),
        messages.get());
  slang::IComponentType* const parts[] = {module, entry.get()};
  ComPtr<slang::IComponentType> program, linked;
  Check(session->createCompositeComponentType(parts, std::size(parts), program.writeRef(),
                                              messages.writeRef()),
        messages.get());
  Check(program->link(linked.writeRef(), messages.writeRef()), messages.get());
  ComPtr<slang::IBlob> code;
  Check(linked->getEntryPointCode(0, 0, code.writeRef(), messages.writeRef()), messages.get());
  return {static_cast<const char*>(code->getBufferPointer()), code->getBufferSize()};
}

}  // namespace

int main(int argc, char**) try {
  const clip_pass::Shader shader = clip_pass::Water();
  const std::string text = argc > 1 ? *shader.read(shader.path) : WithClipDistances(shader);
  std::printf("Slang made %zu bytes\n", CompileBySlang(shader, text).size());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "pass_slang: %s\n", error.what());
  return 1;
}
