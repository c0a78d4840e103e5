// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Against an OpenGL that only keeps state, so that every call and its order can be seen.
// tools/scenes/ draws with a real one.
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/gl/clip_plane_device.h"
#include "runtime/gl/clip_switches.h"
#include "runtime/gl/clipc_runtime_gl.h"
#include "runtime/level9_binder.h"

extern "C" clipc_error SwitchFromC(clipc_gl_loader loader, const void* bytes, std::size_t size,
                                   char* message);
extern "C" clipc_error ClipFromC(clipc_gl_loader loader, const void* bytes, std::size_t size,
                                 const float* constants, std::size_t constants_size, char* message);

namespace clipc::runtime::gl {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct FakeGl {
  std::set<unsigned> enabled;
  std::map<unsigned, std::vector<double>> planes;
  std::vector<bool> identity = {false};  // the modelview stack
  unsigned mode = 0x1702;                // GL_TEXTURE
  int max = 8;
  bool compatibility = true;
  std::vector<std::string> calls;
};
FakeGl fake;

void Note(const char* what, unsigned capability) {
  fake.calls.push_back(what + std::to_string(capability - kClipDistance0));
}
void CLIPC_GL_API Enable(unsigned capability) {
  fake.enabled.insert(capability);
  Note("+", capability);
}
void CLIPC_GL_API Disable(unsigned capability) {
  fake.enabled.erase(capability);
  Note("-", capability);
}
unsigned char CLIPC_GL_API IsEnabled(unsigned capability) {
  return fake.enabled.count(capability) != 0;
}
void CLIPC_GL_API GetIntegerv(unsigned name, int* value) {
  if (name == kMaxClipDistances) *value = fake.max;
  if (name == kMatrixMode) *value = static_cast<int>(fake.mode);
}
void CLIPC_GL_API ClipPlane(unsigned plane, const double* equation) {
  EXPECT_TRUE(fake.identity.back()) << "glClipPlane under an application's modelview matrix";
  fake.planes[plane].assign(equation, equation + 4);
  Note("=", plane);
}
void CLIPC_GL_API GetClipPlane(unsigned plane, double* equation) {
  for (int i = 0; i < 4; ++i)
    equation[i] = fake.planes.count(plane) != 0 ? fake.planes[plane][i] : 0;
}
void CLIPC_GL_API MatrixMode(unsigned mode) { fake.mode = mode; }
void CLIPC_GL_API PushMatrix() {
  EXPECT_EQ(fake.mode, kModelView);
  fake.identity.push_back(fake.identity.back());
}
void CLIPC_GL_API PopMatrix() {
  EXPECT_EQ(fake.mode, kModelView);
  fake.identity.pop_back();
}
void CLIPC_GL_API LoadIdentity() {
  EXPECT_EQ(fake.mode, kModelView);
  fake.identity.back() = true;
}

Procedure Load(const char* name) {
  static const std::map<std::string, Procedure> kAll = {
      {"glEnable", reinterpret_cast<Procedure>(Enable)},
      {"glDisable", reinterpret_cast<Procedure>(Disable)},
      {"glIsEnabled", reinterpret_cast<Procedure>(IsEnabled)},
      {"glGetIntegerv", reinterpret_cast<Procedure>(GetIntegerv)},
  };
  static const std::map<std::string, Procedure> kCompatibility = {
      {"glClipPlane", reinterpret_cast<Procedure>(ClipPlane)},
      {"glGetClipPlane", reinterpret_cast<Procedure>(GetClipPlane)},
      {"glMatrixMode", reinterpret_cast<Procedure>(MatrixMode)},
      {"glPushMatrix", reinterpret_cast<Procedure>(PushMatrix)},
      {"glPopMatrix", reinterpret_cast<Procedure>(PopMatrix)},
      {"glLoadIdentity", reinterpret_cast<Procedure>(LoadIdentity)},
  };
  if (const auto found = kAll.find(name); found != kAll.end()) return found->second;
  if (!fake.compatibility) return nullptr;
  const auto found = kCompatibility.find(name);
  return found == kCompatibility.end() ? nullptr : found->second;
}

Functions Fresh() {
  fake = {};
  return LoadFunctions(Load).value;
}

std::vector<std::string> TakeCalls() { return std::exchange(fake.calls, {}); }

Table TableOf(Lowering lowering, std::uint32_t mask) {
  Table table;
  table.lowering = lowering;
  table.enable_mask = mask;
  for (std::uint32_t i = 0; mask >> i != 0; ++i) {
    TablePlane plane;
    plane.byte_offset = 16 * i;
    table.planes.push_back(plane);
  }
  return table;
}

TEST(LoadFunctions, NeedsWhatEveryProfileHas) {
  EXPECT_EQ(LoadFunctions(nullptr).status.error(), Error::kInvalidArgument);
  EXPECT_EQ(LoadFunctions([](const char*) -> Procedure { return nullptr; }).status.error(),
            Error::kDeviceFailed);
  fake = {};
  EXPECT_TRUE(LoadFunctions(Load).value.has_clip_planes());
  fake.compatibility = false;
  const auto core = LoadFunctions(Load);
  EXPECT_TRUE(core.ok());
  EXPECT_FALSE(core.value.has_clip_planes());
}

TEST(ClipSwitches, EnablesExactlyWhatIsWritten) {
  const Functions gl = Fresh();
  ClipSwitches switches(gl);
  EXPECT_EQ(switches.max_planes(), 8u);
  ASSERT_TRUE(switches.Bind(TableOf(Lowering::kClipDistance, 7)).ok());
  EXPECT_THAT(TakeCalls(), ElementsAre("+0", "+1", "+2"));
  ASSERT_TRUE(switches.Bind(TableOf(Lowering::kClipDistance, 7)).ok());
  EXPECT_THAT(TakeCalls(), IsEmpty());
  ASSERT_TRUE(switches.Bind(VariantOf(0b100100)).ok());  // planes 2 and 5, in distances 0 and 1
  EXPECT_THAT(TakeCalls(), ElementsAre("-2"));
  for (const Lowering lowering : {Lowering::kNone, Lowering::kNearPlane, Lowering::kDiscard}) {
    ASSERT_TRUE(switches.Bind(TableOf(lowering, 0)).ok());
    EXPECT_THAT(fake.enabled, IsEmpty());
  }
}

TEST(ClipSwitches, RefusesWhatOpenGlHasNot) {
  const Functions gl = Fresh();
  fake.max = 4;
  ClipSwitches switches(gl);
  EXPECT_EQ(switches.Enable(0x10).error(), Error::kInvalidCall);
  EXPECT_EQ(switches.Bind(TableOf(Lowering::kClipDistance, 0x1F)).error(), Error::kInvalidCall);
  EXPECT_EQ(switches.Bind(TableOf(Lowering::kLevel9, 1)).error(), Error::kWrongLowering);
  EXPECT_THAT(fake.calls, IsEmpty());
}

// While a distance is written, some distance is enabled at any moment.
TEST(ClipSwitches, EnablesBeforeItDisables) {
  const Functions gl = Fresh();
  ClipSwitches switches(gl);
  ASSERT_TRUE(switches.Enable(1).ok());
  ASSERT_TRUE(switches.Enable(2).ok());
  EXPECT_THAT(fake.calls, ElementsAre("+0", "+1", "-0"));
}

TEST(ClipSwitches, RestoresWhatWasEnabled) {
  const Functions gl = Fresh();
  fake.enabled = {kClipDistance0 + 1, kClipDistance0 + 5};
  {
    ClipSwitches switches(gl);
    ASSERT_TRUE(switches.Enable(3).ok());
    EXPECT_THAT(TakeCalls(), ElementsAre("+0", "-5"));
  }
  EXPECT_THAT(TakeCalls(), ElementsAre("+5", "-0"));
}

TEST(ClipPlaneDevice, SetsPlanesUnderTheIdentity) {
  const Functions gl = Fresh();
  ClipPlaneDevice device(gl);
  Level9Binder binder(device, device.max_planes());
  const float planes[3][4] = {{1, 2, 3, 4}, {5, 6, 7, 8}, {-1, 0.5F, 0, 0}};
  const BoundBuffer buffer{0, 0, planes, sizeof planes};
  ASSERT_TRUE(binder.Bind(TableOf(Lowering::kLevel9, 7), &buffer, 1).ok());
  EXPECT_THAT(TakeCalls(), ElementsAre("=0", "=1", "=2", "+0", "+1", "+2"));
  EXPECT_THAT(fake.planes[kClipDistance0 + 2], ElementsAre(-1, 0.5, 0, 0));
  EXPECT_EQ(fake.mode, 0x1702u) << "the application's matrix mode";
  EXPECT_EQ(fake.identity, std::vector<bool>{false}) << "the application's matrix";
  ASSERT_TRUE(binder.Bind(TableOf(Lowering::kLevel9, 7), &buffer, 1).ok());
  EXPECT_THAT(TakeCalls(), IsEmpty());
  ASSERT_TRUE(binder.Bind(TableOf(Lowering::kLevel9, 7), &buffer, 1, 0b010).ok());
  EXPECT_THAT(TakeCalls(), ElementsAre("-0", "-2"));
}

TEST(ClipPlaneDevice, RestoresPlanesAndSwitches) {
  const Functions gl = Fresh();
  fake.enabled = {kClipDistance0 + 3};
  fake.planes[kClipDistance0] = {9, 8, 7, 6};
  {
    ClipPlaneDevice device(gl);
    const float plane[4] = {1, 2, 3, 4};
    ASSERT_TRUE(device.SetClipPlane(0, plane));
    ASSERT_TRUE(device.SetClipPlane(0, plane));
    ASSERT_TRUE(device.SetClipPlaneEnable(1));
  }
  EXPECT_THAT(fake.planes[kClipDistance0], ElementsAre(9, 8, 7, 6));
  EXPECT_THAT(fake.enabled, ElementsAre(kClipDistance0 + 3));
}

TEST(CInterface, SwitchesAndRestores) {
  fake = {};
  constexpr char kTable[] = R"({"schema": "clipc.clip-table", "version": 1, "entry": "main",
  "profile": "vs_5_0", "lowering": "clip-distance", "position_space": "direct3d-clip",
  "plane_scale": "any", "enable_mask": 3, "planes": [
    {"index": 0, "text": "a", "constant": {"cbuffer": "C", "cbuffer_element": 0,
      "register": 1, "space": 0, "float4_register": 0, "byte_offset": 0,
      "glsl_block": "C", "glsl_member": "C.a"}},
    {"index": 1, "text": "b", "constant": {"cbuffer": "C", "cbuffer_element": 0,
      "register": 1, "space": 0, "float4_register": 1, "byte_offset": 16,
      "glsl_block": "C", "glsl_member": "C.b"}}]})";
  char message[CLIPC_MESSAGE_SIZE];
  ASSERT_EQ(SwitchFromC(Load, kTable, sizeof kTable - 1, message), CLIPC_OK) << message;
  EXPECT_THAT(TakeCalls(), ElementsAre("+0", "+1", "-1", "-0"));
  EXPECT_EQ(SwitchFromC(nullptr, kTable, sizeof kTable - 1, message), CLIPC_INVALID_ARGUMENT);
  const clipc_shader_variant many = {99, {}};
  clipc_gl_switches* switches = nullptr;
  ASSERT_EQ(clipc_gl_switches_create(Load, &switches, message), CLIPC_OK);
  EXPECT_EQ(clipc_gl_switches_bind_variant(switches, &many, message), CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_gl_switches_max_planes(switches), 8u);
  EXPECT_EQ(clipc_gl_switches_enable(switches, 1U << 7, message), CLIPC_INVALID_CALL);
  clipc_gl_switches_free(switches);
}

TEST(CInterface, GivesPlanesToOpenGl) {
  fake = {};
  // One plane in b1, register 2.
  constexpr unsigned char kTable[] = {0x35, 0x28, 0, 0, 5, 0, 0, 0, 1, 0,
                                      0,    0,    1, 0, 2, 0, 1, 0, 0, 0};
  const float constants[12] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4};
  char message[CLIPC_MESSAGE_SIZE];
  ASSERT_EQ(ClipFromC(Load, kTable, sizeof kTable, constants, sizeof constants, message), CLIPC_OK)
      << message;
  EXPECT_THAT(TakeCalls(), ElementsAre("=0", "+0", "=0", "-0"));
  fake.compatibility = false;
  EXPECT_EQ(ClipFromC(Load, kTable, sizeof kTable, constants, sizeof constants, message),
            CLIPC_DEVICE_FAILED);
  EXPECT_THAT(message, ::testing::HasSubstr("glClipPlane"));
}

TEST(ClipPlaneDevice, RefusesWithoutClipPlanes) {
  Functions gl = Fresh();
  const float plane[4] = {1, 2, 3, 4};
  {
    ClipPlaneDevice device(gl);
    EXPECT_FALSE(device.SetClipPlane(6, plane));
    EXPECT_FALSE(device.SetClipPlaneEnable(1U << 8));
  }
  gl.ClipPlane = nullptr;
  ClipPlaneDevice device(gl);
  Level9Binder binder(device, device.max_planes());
  const BoundBuffer buffer{0, 0, plane, sizeof plane};
  EXPECT_EQ(binder.Bind(TableOf(Lowering::kLevel9, 1), &buffer, 1).error(), Error::kDeviceFailed);
}

}  // namespace
}  // namespace clipc::runtime::gl
