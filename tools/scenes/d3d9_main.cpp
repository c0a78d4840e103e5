// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A program for Windows: draws the scenes on a real IDirect3DDevice9, where the planes go from
// clipc's table through Level9Binder to SetClipPlane, and writes the images as raw RGBA, rows
// from top to bottom: FOLDER/<planes>-<mistake>.rgba, FOLDER/skinned.rgba and, drawn without a
// vertex shader, FOLDER/fixed-function.rgba. Prints the time of a draw whose planes do not
// change, for docs/runtime.md.
//   d3d9_scenes FOLDER TABLE.bin
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include <d3d9.h>
#include <windows.h>

#include "runtime/clip_plane.h"
#include "runtime/d3d9/clip_plane_device.h"
#include "runtime/level9_binder.h"
#include "runtime/table.h"
#include "scene_level9_1.clip.h"
#include "scene_level9_3.clip.h"
#include "skinned.clip.h"
#include "tools/harness/transform.h"
#include "tools/scenes/scene.h"

namespace {

using namespace clipc::scenes;
using namespace clipc::runtime;

constexpr D3DCOLOR kClearColor = 0xFF203040;

[[noreturn]] void Fail(const char* what, long code) {
  std::fprintf(stderr, "%s: 0x%lx\n", what, static_cast<unsigned long>(code));
  std::exit(1);
}
void Check(HRESULT result, const char* what) {
  if (FAILED(result)) Fail(what, result);
}
void Check(const Status& status) {
  if (!status.ok()) Fail(status.message(), HresultOf(status.error()));
}

// The code that fxc makes of scene.hlsl, without the pixel offset, which Direct3D 9's rasteriser
// has by itself: position in the order in which OpenGL multiplies matrix and vector.
//   vs_1_1
//   dcl_position v0
//   dcl_color v1
//   mul r0, c0, v0.x
//   mad r0, c1, v0.y, r0
//   mad r0, c2, v0.z, r0
//   add oPos, r0, c3
//   mov oD0, v1
constexpr DWORD kShader[] = {0xFFFE0101,                                                  //
                             0x0000001F, 0x80000000, 0x900F0000,                          //
                             0x0000001F, 0x8000000A, 0x900F0001,                          //
                             0x00000005, 0x800F0000, 0xA0E40000, 0x90000000,              //
                             0x00000004, 0x800F0000, 0xA0E40001, 0x90550000, 0x80E40000,  //
                             0x00000004, 0x800F0000, 0xA0E40002, 0x90AA0000, 0x80E40000,  //
                             0x00000002, 0xC00F0000, 0x80E40000, 0xA0E40003,              //
                             0x00000001, 0xD00F0000, 0x90E40001,                          //
                             0x0000FFFF};

// skinned.hlsl likewise, its loops unrolled. Constants are in the order of the buffer's members, 4
// is a row's distance from bone to bone, and an instruction reads one constant register at most.
//   vs_1_1
//   def c13, 4, 0, 0, 0
//   dcl_position v0
//   dcl_color v1
//   mov r6, c9               the weights
//   mov r1, c8
//   mul r1, r1, c13.x        the bones' first rows
//   mov a0.x, r1.x
//   mul r2, c[a0.x], r6.x
//   mul r3, c[a0.x + 1], r6.x
//   mul r4, c[a0.x + 2], r6.x
//   mul r5, c[a0.x + 3], r6.x
//   mov a0.x, r1.y
//   mad r2, c[a0.x], r6.y, r2
//   mad r3, c[a0.x + 1], r6.y, r3
//   mad r4, c[a0.x + 2], r6.y, r4
//   mad r5, c[a0.x + 3], r6.y, r5
//   mul r0, r2, v0.x
//   mad r0, r3, v0.y, r0
//   mad r0, r4, v0.z, r0
//   mad oPos, r5, v0.w, r0
//   dp3 r7.x, c10, v1
//   dp3 r7.y, c11, v1
//   dp3 r7.z, c12, v1
//   mov r7.w, v1.w
//   mov oD0, r7
constexpr DWORD kSkinnedShader[] = {0xFFFE0101,  //
                                    0x00000051, 0xA00F000D, 0x40800000, 0x00000000, 0x00000000,
                                    0x00000000,                                                  //
                                    0x0000001F, 0x80000000, 0x900F0000,                          //
                                    0x0000001F, 0x8000000A, 0x900F0001,                          //
                                    0x00000001, 0x800F0006, 0xA0E40009,                          //
                                    0x00000001, 0x800F0001, 0xA0E40008,                          //
                                    0x00000005, 0x800F0001, 0x80E40001, 0xA000000D,              //
                                    0x00000001, 0xB0010000, 0x80000001,                          //
                                    0x00000005, 0x800F0002, 0xA0E42000, 0x80000006,              //
                                    0x00000005, 0x800F0003, 0xA0E42001, 0x80000006,              //
                                    0x00000005, 0x800F0004, 0xA0E42002, 0x80000006,              //
                                    0x00000005, 0x800F0005, 0xA0E42003, 0x80000006,              //
                                    0x00000001, 0xB0010000, 0x80550001,                          //
                                    0x00000004, 0x800F0002, 0xA0E42000, 0x80550006, 0x80E40002,  //
                                    0x00000004, 0x800F0003, 0xA0E42001, 0x80550006, 0x80E40003,  //
                                    0x00000004, 0x800F0004, 0xA0E42002, 0x80550006, 0x80E40004,  //
                                    0x00000004, 0x800F0005, 0xA0E42003, 0x80550006, 0x80E40005,  //
                                    0x00000005, 0x800F0000, 0x80E40002, 0x90000000,              //
                                    0x00000004, 0x800F0000, 0x80E40003, 0x90550000, 0x80E40000,  //
                                    0x00000004, 0x800F0000, 0x80E40004, 0x90AA0000, 0x80E40000,  //
                                    0x00000004, 0xC00F0000, 0x80E40005, 0x90FF0000, 0x80E40000,  //
                                    0x00000008, 0x80010007, 0xA0E4000A, 0x90E40001,              //
                                    0x00000008, 0x80020007, 0xA0E4000B, 0x90E40001,              //
                                    0x00000008, 0x80040007, 0xA0E4000C, 0x90E40001,              //
                                    0x00000001, 0x80080007, 0x90FF0001,                          //
                                    0x00000001, 0xD00F0000, 0x80E40007,                          //
                                    0x0000FFFF};

void SetShader(IDirect3DDevice9& device, const DWORD* bytecode) {
  IDirect3DVertexShader9* shader = nullptr;
  Check(device.CreateVertexShader(bytecode, &shader), "CreateVertexShader");
  Check(device.SetVertexShader(shader), "SetVertexShader");
}

IDirect3DDevice9* MakeDevice() {
  IDirect3D9* direct3d = Direct3DCreate9(D3D_SDK_VERSION);
  if (direct3d == nullptr) Fail("Direct3DCreate9", 0);
  const HWND window = CreateWindowA("static", "scenes", WS_POPUP, 0, 0, kSize, kSize, nullptr,
                                    nullptr, nullptr, nullptr);
  D3DPRESENT_PARAMETERS parameters = {};
  parameters.Windowed = TRUE;
  parameters.SwapEffect = D3DSWAPEFFECT_DISCARD;
  parameters.BackBufferFormat = D3DFMT_X8R8G8B8;
  parameters.BackBufferWidth = kSize;
  parameters.BackBufferHeight = kSize;
  parameters.EnableAutoDepthStencil = TRUE;
  parameters.AutoDepthStencilFormat = D3DFMT_D24S8;
  parameters.hDeviceWindow = window;
  IDirect3DDevice9* device = nullptr;
  Check(direct3d->CreateDevice(0, D3DDEVTYPE_HAL, window, D3DCREATE_HARDWARE_VERTEXPROCESSING,
                               &parameters, &device),
        "CreateDevice");
  Check(device->SetFVF(D3DFVF_XYZ | D3DFVF_DIFFUSE), "SetFVF");
  SetShader(*device, kShader);
  Check(device->SetRenderState(D3DRS_CULLMODE, D3DCULL_NONE), "CULLMODE");
  Check(device->SetRenderState(D3DRS_LIGHTING, FALSE), "LIGHTING");
  return device;
}

void SetConstants(IDirect3DDevice9& device, UINT first, const float* values, UINT registers) {
  Check(device.SetVertexShaderConstantF(first, values, registers), "SetVertexShaderConstantF");
}

using SetMatrix = void(IDirect3DDevice9& device, const Matrix& world_view_projection);

// Sets the constant registers c0 to c3 to the rows of the matrix.
void SetOneMatrix(IDirect3DDevice9& device, const Matrix& world_view_projection) {
  SetConstants(device, 0, clipc::harness::Floats(world_view_projection).data(), 4);
}

void SetSkin(IDirect3DDevice9& device, const Matrix& world_view_projection) {
  const Skin skin = SkinOf(world_view_projection);
  for (UINT i = 0; i < skin.bones.size(); ++i)
    SetConstants(device, 4 * i, clipc::harness::Floats(skin.bones[i]).data(), 4);
  SetConstants(device, 8, &skin.indices.x, 1);
  SetConstants(device, 9, &skin.weights.x, 1);
  SetConstants(device, 10, &skin.lights[0].x, 3);
}

void DrawObjects(IDirect3DDevice9& device, const Scene& scene, SetMatrix& set_matrix) {
  for (const Object& object : scene.objects) {
    set_matrix(device, Multiply(Multiply(object.world, scene.view), scene.projection));
    Check(device.DrawPrimitiveUP(D3DPT_TRIANGLELIST, static_cast<UINT>(object.vertices.size() / 3),
                                 object.vertices.data(), sizeof(SceneVertex)),
          "DrawPrimitiveUP");
  }
}

void WriteImage(IDirect3DDevice9& device, const std::string& path) {
  IDirect3DSurface9 *target = nullptr, *copy = nullptr;
  Check(device.GetRenderTarget(0, &target), "GetRenderTarget");
  Check(device.CreateOffscreenPlainSurface(kSize, kSize, D3DFMT_X8R8G8B8, D3DPOOL_SYSTEMMEM, &copy,
                                           nullptr),
        "surface");
  Check(device.GetRenderTargetData(target, copy), "GetRenderTargetData");
  D3DLOCKED_RECT locked;
  Check(copy->LockRect(&locked, nullptr, D3DLOCK_READONLY), "LockRect");
  std::ofstream file(path, std::ios::binary);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      std::uint32_t color;
      std::memcpy(&color, static_cast<const char*>(locked.pBits) + y * locked.Pitch + 4 * x, 4);
      const char rgba[4] = {static_cast<char>(color >> 16), static_cast<char>(color >> 8),
                            static_cast<char>(color), '\xFF'};
      file.write(rgba, 4);
    }
  }
  copy->UnlockRect();
  copy->Release();
  target->Release();
  if (!file.flush()) Fail(path.c_str(), 0);
}

void DrawScene(IDirect3DDevice9& device, Level9Binder& binder, const Table& table,
               const Scene& scene, Mistake mistake, SetMatrix& set_matrix) {
  const auto planes = PlaneConstants(scene, scene.projection, 1, mistake);
  Check(device.Clear(0, nullptr, D3DCLEAR_TARGET | D3DCLEAR_ZBUFFER, kClearColor, 1, 0), "Clear");
  Check(device.BeginScene(), "BeginScene");
  const BoundBuffer buffer{1, 0, planes.data(), sizeof planes};
  Check(binder.Bind(MistakenTable(table, mistake), &buffer, 1));
  DrawObjects(device, scene, set_matrix);
  Check(device.EndScene(), "EndScene");
}

void Draw(IDirect3DDevice9& device, Level9Binder& binder, const Table& table, int plane_count,
          Mistake mistake, const std::string& folder) {
  DrawScene(device, binder, table, MakeScene(plane_count), mistake, SetOneMatrix);
  WriteImage(device, folder + "/" + std::to_string(plane_count) + "-" + NameOf(mistake) + ".rgba");
}

void DrawSkinned(IDirect3DDevice9& device, Level9Binder& binder, const std::string& path) {
  const auto table = ReadTable(skinned_clip_table);
  Check(table.status);
  SetShader(device, kSkinnedShader);
  DrawScene(device, binder, table.value, MakeScene(3), Mistake::kNone, SetSkin);
  WriteImage(device, path);
}

// Draws without a vertex shader, where planes are in world space ("SetClipPlane", Remarks).
void DrawFixedFunction(IDirect3DDevice9& device, const std::string& path) {
  const Scene scene = MakeScene(3);
  const auto set = [&](D3DTRANSFORMSTATETYPE state, const Matrix& matrix) {
    const auto floats = clipc::harness::Floats(matrix);
    D3DMATRIX elements;
    std::memcpy(&elements, floats.data(), sizeof elements);
    Check(device.SetTransform(state, &elements), "SetTransform");
  };
  Check(device.SetVertexShader(nullptr), "SetVertexShader");
  set(D3DTS_VIEW, scene.view);
  set(D3DTS_PROJECTION, scene.projection);
  Check(device.Clear(0, nullptr, D3DCLEAR_TARGET | D3DCLEAR_ZBUFFER, kClearColor, 1, 0), "Clear");
  Check(device.BeginScene(), "BeginScene");
  for (DWORD i = 0; i < 3; ++i) {
    const Float4 plane = RoundPlane(scene.planes[i]).value;
    Check(device.SetClipPlane(i, &plane.x), "SetClipPlane");
  }
  Check(device.SetRenderState(D3DRS_CLIPPLANEENABLE, 7), "CLIPPLANEENABLE");
  for (const Object& object : scene.objects) {
    set(D3DTS_WORLD, object.world);
    Check(device.DrawPrimitiveUP(D3DPT_TRIANGLELIST, static_cast<UINT>(object.vertices.size() / 3),
                                 object.vertices.data(), sizeof(SceneVertex)),
          "DrawPrimitiveUP");
  }
  Check(device.EndScene(), "EndScene");
  WriteImage(device, path);
}

double Nanoseconds() {
  LARGE_INTEGER count, frequency;
  QueryPerformanceCounter(&count);
  QueryPerformanceFrequency(&frequency);
  return 1e9 * static_cast<double>(count.QuadPart) / static_cast<double>(frequency.QuadPart);
}

// Prints the time of draws whose planes do not change, beside that of a loop that sets them
// blindly.
void TimeUnchangedDraws(IDirect3DDevice9& device, Level9Binder& binder, const Table& table) {
  constexpr int kDraws = 20'000;
  const auto planes = PlaneConstants(MakeScene(3), MakeScene(3).projection, 1, Mistake::kNone);
  const BoundBuffer buffer{1, 0, planes.data(), sizeof planes};
  Check(binder.Bind(table, &buffer, 1));
  double bound = 1e30, blind = 1e30;
  for (int round = 0; round < 9; ++round) {
    const double start = Nanoseconds();
    for (int draw = 0; draw < kDraws; ++draw) Check(binder.Bind(table, &buffer, 1));
    const double middle = Nanoseconds();
    for (int draw = 0; draw < kDraws; ++draw) {
      for (DWORD i = 0; i < 3; ++i) device.SetClipPlane(i, &planes[(i + 2) % 3].x);
      device.SetRenderState(D3DRS_CLIPPLANEENABLE, table.enable_mask);
    }
    bound = std::min(bound, (middle - start) / kDraws),
    blind = std::min(blind, (Nanoseconds() - middle) / kDraws);
  }
  std::printf("3 planes unchanged: Level9Binder %.1f ns a draw, SetClipPlane blindly %.1f ns\n",
              bound, blind);
}

// Reads a table from Direct3D's own record, as `clipc --table x.bin` wrote it.
Table ReadBinaryTable(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto table = ReadTable(bytes.data(), bytes.size());
  Check(table.status);
  return table.value;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) Fail("usage: d3d9_scenes FOLDER TABLE.bin", argc);
  IDirect3DDevice9& device = *MakeDevice();
  d3d9::ClipPlaneDevice clip_device(device);
  std::printf("MaxUserClipPlanes %u\n", static_cast<unsigned>(clip_device.max_planes()));
  const float plane[4] = {1, 0, 0, 0};
  if (clip_device.SetClipPlane(clip_device.max_planes(), plane))
    Fail("a plane too many was taken", 0);
  Level9Binder binder(clip_device, clip_device.max_planes());
  const auto one = ReadTable(scene_level9_1_clip_table);
  Check(one.status);
  Draw(device, binder, one.value, 1, Mistake::kNone, argv[1]);
  Draw(device, binder, ReadBinaryTable(argv[2]), 3, Mistake::kNone, argv[1]);
  const auto three = ReadTable(scene_level9_3_clip_table);
  Check(three.status);
  for (const Mistake mistake : kMistakes) Draw(device, binder, three.value, 3, mistake, argv[1]);
  TimeUnchangedDraws(device, binder, three.value);
  DrawSkinned(device, binder, std::string(argv[1]) + "/skinned.rgba");
  DrawFixedFunction(device, std::string(argv[1]) + "/fixed-function.rgba");
  return 0;
}
