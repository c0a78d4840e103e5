// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// DXC by its API, with clipc before it: the shader, what it includes and what comes out are in
// memory. It is built here with stubs of DXC's interfaces (stubs/), as DXC is not in Debian; with
// DXC's own headers and library it writes SPIR-V.
//   pass_dxc [without-clipc]
#include <cstdio>
#include <exception>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include <dxc/dxcapi.h>

#include "examples/pass/clip_pass.h"

namespace {

struct Release {
  void operator()(IUnknown* object) const { object->Release(); }
};
template <typename T>
using Owned = std::unique_ptr<T, Release>;

void Check(HRESULT result) {
  if (FAILED(result)) throw std::runtime_error("a function of DXC failed");
}

template <typename T>
Owned<T> Create(REFCLSID id) {
  T* object = nullptr;
  Check(DxcCreateInstance(id, IID_PPV_ARGS(&object)));
  return Owned<T>(object);
}

std::string TextOf(IDxcBlob& blob) {
  return {static_cast<const char*>(blob.GetBufferPointer()), blob.GetBufferSize()};
}

// Gives DXC the includes that clipc was given. It lives longer than the call that takes it.
class Includes final : public IDxcIncludeHandler {
 public:
  Includes(IDxcUtils& utils, const clip_pass::ReadFile& read) : utils_(utils), read_(read) {}

  HRESULT STDMETHODCALLTYPE LoadSource(LPCWSTR name, IDxcBlob** source) override {
    *source = nullptr;
    std::string path;
    for (const wchar_t c : std::wstring_view(name)) path += static_cast<char>(c);  // of ASCII here
    const auto text = read_(path);
    if (!text) return E_FAIL;
    IDxcBlobEncoding* blob = nullptr;
    const HRESULT result =
        utils_.CreateBlob(text->data(), static_cast<UINT32>(text->size()), DXC_CP_UTF8, &blob);
    *source = blob;
    return result;
  }
  HRESULT STDMETHODCALLTYPE QueryInterface(REFIID, void**) override { return E_NOINTERFACE; }
  ULONG STDMETHODCALLTYPE AddRef() override { return 1; }
  ULONG STDMETHODCALLTYPE Release() override { return 1; }

 private:
  IDxcUtils& utils_;
  const clip_pass::ReadFile& read_;
};

std::string CompileByDxc(const clip_pass::Shader& shader, const std::string& text) {
  const auto utils = Create<IDxcUtils>(CLSID_DxcUtils);
  const auto compiler = Create<IDxcCompiler3>(CLSID_DxcCompiler);
  const DxcBuffer source = {text.data(), text.size(), DXC_CP_UTF8};
  const std::wstring path(shader.path.begin(), shader.path.end());
  const std::wstring entry(shader.entry.begin(), shader.entry.end());
  LPCWSTR arguments[] = {path.c_str(), L"-spirv", L"-T", L"vs_6_0", L"-E", entry.c_str()};
  Includes includes(*utils, shader.read);
  IDxcResult* made = nullptr;
  Check(compiler->Compile(&source, arguments, static_cast<UINT32>(std::size(arguments)), &includes,
                          IID_PPV_ARGS(&made)));
  const Owned<IDxcResult> result(made);
  HRESULT status = E_FAIL;
  Check(result->GetStatus(&status));
  if (FAILED(status)) {
    IDxcBlobEncoding* errors = nullptr;
    Check(result->GetErrorBuffer(&errors));
    throw std::runtime_error(TextOf(*Owned<IDxcBlobEncoding>(errors)));
  }
  IDxcBlob* object = nullptr;
  Check(result->GetResult(&object));
  return TextOf(*Owned<IDxcBlob>(object));
}

}  // namespace

int main(int argc, char**) try {
  const clip_pass::Shader shader = clip_pass::Water();
  const std::string text = argc > 1 ? *shader.read(shader.path) : WithClipDistances(shader);
  std::printf("DXC made %zu bytes\n", CompileByDxc(shader, text).size());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "pass_dxc: %s\n", error.what());
  return 1;
}
