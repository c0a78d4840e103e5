// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// NOT DXC: stubs of the interfaces of DXC that examples/pass/dxc.cpp calls, with their names and
// signatures and no more of their functions. Its compiler returns the HLSL that it is given, after
// stub::ProblemOf has found nothing against it.
#pragma once

#include <cstdint>
#include <cwchar>
#include <string>
#include <utility>

#include "examples/pass/stubs/accept.h"

// NOLINTBEGIN: names of DXC and of Windows.
#define STDMETHODCALLTYPE
#define IID_PPV_ARGS(pointer) stub::IdOf(*(pointer)), reinterpret_cast<void**>(pointer)
#define FAILED(result) ((result) < 0)
#define DXC_CP_UTF8 65001

using HRESULT = std::int32_t;
using ULONG = std::uint32_t;
using UINT32 = std::uint32_t;
using LPCWSTR = const wchar_t*;
inline constexpr HRESULT S_OK = 0, E_FAIL = -1, E_NOINTERFACE = -2;

struct GUID {
  int number;
};
using REFIID = const GUID&;
using REFCLSID = const GUID&;
inline constexpr GUID CLSID_DxcUtils = {1}, CLSID_DxcCompiler = {2};

struct IUnknown {
  virtual HRESULT QueryInterface(REFIID id, void** object) = 0;
  virtual ULONG AddRef() = 0;
  virtual ULONG Release() = 0;

 protected:
  ~IUnknown() = default;
};
struct IDxcBlob : IUnknown {
  virtual void* GetBufferPointer() = 0;
  virtual std::size_t GetBufferSize() = 0;
};
struct IDxcBlobEncoding : IDxcBlob {};
struct IDxcIncludeHandler : IUnknown {
  virtual HRESULT LoadSource(LPCWSTR name, IDxcBlob** source) = 0;
};
struct IDxcUtils : IUnknown {
  virtual HRESULT CreateBlob(const void* data, UINT32 size, UINT32 code_page,
                             IDxcBlobEncoding** blob) = 0;
};
struct IDxcResult : IUnknown {
  virtual HRESULT GetStatus(HRESULT* status) = 0;
  virtual HRESULT GetResult(IDxcBlob** result) = 0;
  virtual HRESULT GetErrorBuffer(IDxcBlobEncoding** errors) = 0;
};
struct DxcBuffer {
  const void* Ptr;
  std::size_t Size;
  UINT32 Encoding;
};
struct IDxcCompiler3 : IUnknown {
  virtual HRESULT Compile(const DxcBuffer* source, LPCWSTR* arguments, UINT32 count,
                          IDxcIncludeHandler* includes, REFIID id, void** result) = 0;
};

namespace stub {

constexpr GUID IdOf(const IUnknown*) { return {0}; }

template <typename Interface>
class Object : public Interface {
 public:
  HRESULT QueryInterface(REFIID, void**) final { return E_NOINTERFACE; }
  ULONG AddRef() final { return ++count_; }
  ULONG Release() final {
    const ULONG left = --count_;
    if (left == 0) delete this;
    return left;
  }

 protected:
  virtual ~Object() = default;

 private:
  ULONG count_ = 1;
};

class Blob final : public Object<IDxcBlobEncoding> {
 public:
  explicit Blob(std::string text) : text_(std::move(text)) {}
  void* GetBufferPointer() override { return text_.data(); }
  std::size_t GetBufferSize() override { return text_.size(); }

 private:
  std::string text_;
};

class Utils final : public Object<IDxcUtils> {
 public:
  HRESULT CreateBlob(const void* data, UINT32 size, UINT32, IDxcBlobEncoding** blob) override {
    *blob = new Blob({static_cast<const char*>(data), size});
    return S_OK;
  }
};

class Result final : public Object<IDxcResult> {
 public:
  Result(std::string text, std::string problem)
      : text_(std::move(text)), problem_(std::move(problem)) {}
  HRESULT GetStatus(HRESULT* status) override {
    *status = problem_.empty() ? S_OK : E_FAIL;
    return S_OK;
  }
  HRESULT GetResult(IDxcBlob** result) override {
    *result = new Blob(text_);
    return S_OK;
  }
  HRESULT GetErrorBuffer(IDxcBlobEncoding** errors) override {
    *errors = new Blob(problem_);
    return S_OK;
  }

 private:
  std::string text_, problem_;
};

class Compiler final : public Object<IDxcCompiler3> {
 public:
  HRESULT Compile(const DxcBuffer* source, LPCWSTR*, UINT32, IDxcIncludeHandler* includes, REFIID,
                  void** result) override {
    const std::string text(static_cast<const char*>(source->Ptr), source->Size);
    const auto can_read = [&](const std::string& name) {
      IDxcBlob* blob = nullptr;
      const std::wstring path = L"./" + std::wstring(name.begin(), name.end());
      includes->LoadSource(path.c_str(), &blob);
      if (blob) blob->Release();
      return blob != nullptr;
    };
    *result = static_cast<IDxcResult*>(new Result(text, ProblemOf(text, can_read)));
    return S_OK;
  }
};

}  // namespace stub

inline HRESULT DxcCreateInstance(REFCLSID class_id, REFIID, void** object) {
  if (class_id.number == CLSID_DxcUtils.number) {
    *object = static_cast<IDxcUtils*>(new stub::Utils);
  } else {
    *object = static_cast<IDxcCompiler3*>(new stub::Compiler);
  }
  return S_OK;
}
// NOLINTEND
