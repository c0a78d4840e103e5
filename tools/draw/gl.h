// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include <GL/glcorearb.h>

// OpenGL without a display: Mesa's software driver through EGL's surfaceless platform. Needs
// neither an environment variable nor a device file.
namespace clipc::draw {

// What the machine or the shader cannot do, in words. A test tool gives up here; it never skips.
class DrawError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Of the compatibility profile, which glcorearb.h leaves out.
using ClipPlaneProc = void(APIENTRYP)(GLenum plane, const double* equation);

#define CLIPC_GL_FUNCTIONS(F)                                                \
  F(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                   \
  F(PFNGLATTACHSHADERPROC, AttachShader)                                     \
  F(PFNGLBEGINTRANSFORMFEEDBACKPROC, BeginTransformFeedback)                 \
  F(PFNGLBINDBUFFERPROC, BindBuffer)                                         \
  F(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                 \
  F(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                               \
  F(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                             \
  F(PFNGLBINDTEXTUREPROC, BindTexture)                                       \
  F(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                               \
  F(PFNGLBLENDFUNCPROC, BlendFunc)                                           \
  F(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                               \
  F(PFNGLBUFFERDATAPROC, BufferData)                                         \
  F(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                 \
  F(PFNGLCLEARPROC, Clear)                                                   \
  F(PFNGLCLEARCOLORPROC, ClearColor)                                         \
  F(PFNGLCOMPILESHADERPROC, CompileShader)                                   \
  F(PFNGLCREATEPROGRAMPROC, CreateProgram)                                   \
  F(PFNGLCREATESHADERPROC, CreateShader)                                     \
  F(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                   \
  F(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                         \
  F(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                   \
  F(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                       \
  F(PFNGLDELETESHADERPROC, DeleteShader)                                     \
  F(PFNGLDELETETEXTURESPROC, DeleteTextures)                                 \
  F(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                         \
  F(PFNGLDEPTHFUNCPROC, DepthFunc)                                           \
  F(PFNGLDISABLEPROC, Disable)                                               \
  F(PFNGLDRAWARRAYSPROC, DrawArrays)                                         \
  F(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)                       \
  F(PFNGLENABLEPROC, Enable)                                                 \
  F(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)               \
  F(PFNGLENDTRANSFORMFEEDBACKPROC, EndTransformFeedback)                     \
  F(PFNGLFINISHPROC, Finish)                                                 \
  F(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)               \
  F(PFNGLGENBUFFERSPROC, GenBuffers)                                         \
  F(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                               \
  F(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                             \
  F(PFNGLGENTEXTURESPROC, GenTextures)                                       \
  F(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                               \
  F(PFNGLGETACTIVEATTRIBPROC, GetActiveAttrib)                               \
  F(PFNGLGETACTIVEUNIFORMPROC, GetActiveUniform)                             \
  F(PFNGLGETACTIVEUNIFORMBLOCKIVPROC, GetActiveUniformBlockiv)               \
  F(PFNGLGETACTIVEUNIFORMBLOCKNAMEPROC, GetActiveUniformBlockName)           \
  F(PFNGLGETATTRIBLOCATIONPROC, GetAttribLocation)                           \
  F(PFNGLGETERRORPROC, GetError)                                             \
  F(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                           \
  F(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                     \
  F(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                             \
  F(PFNGLGETSHADERIVPROC, GetShaderiv)                                       \
  F(PFNGLGETSTRINGPROC, GetString)                                           \
  F(PFNGLGETTRANSFORMFEEDBACKVARYINGPROC, GetTransformFeedbackVarying)       \
  F(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                         \
  F(PFNGLLINKPROGRAMPROC, LinkProgram)                                       \
  F(PFNGLMAPBUFFERRANGEPROC, MapBufferRange)                                 \
  F(PFNGLPIXELSTOREIPROC, PixelStorei)                                       \
  F(PFNGLREADPIXELSPROC, ReadPixels)                                         \
  F(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)                       \
  F(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample) \
  F(PFNGLSHADERSOURCEPROC, ShaderSource)                                     \
  F(PFNGLTEXBUFFERPROC, TexBuffer)                                           \
  F(PFNGLTEXIMAGE1DPROC, TexImage1D)                                         \
  F(PFNGLTEXIMAGE2DPROC, TexImage2D)                                         \
  F(PFNGLTEXIMAGE3DPROC, TexImage3D)                                         \
  F(PFNGLTEXPARAMETERIPROC, TexParameteri)                                   \
  F(PFNGLTRANSFORMFEEDBACKVARYINGSPROC, TransformFeedbackVaryings)           \
  F(PFNGLUNIFORM1FVPROC, Uniform1fv)                                         \
  F(PFNGLUNIFORM2FVPROC, Uniform2fv)                                         \
  F(PFNGLUNIFORM3FVPROC, Uniform3fv)                                         \
  F(PFNGLUNIFORM4FVPROC, Uniform4fv)                                         \
  F(PFNGLUNIFORM1IVPROC, Uniform1iv)                                         \
  F(PFNGLUNIFORM2IVPROC, Uniform2iv)                                         \
  F(PFNGLUNIFORM3IVPROC, Uniform3iv)                                         \
  F(PFNGLUNIFORM4IVPROC, Uniform4iv)                                         \
  F(PFNGLUNIFORM1UIVPROC, Uniform1uiv)                                       \
  F(PFNGLUNIFORM2UIVPROC, Uniform2uiv)                                       \
  F(PFNGLUNIFORM3UIVPROC, Uniform3uiv)                                       \
  F(PFNGLUNIFORM4UIVPROC, Uniform4uiv)                                       \
  F(PFNGLUNIFORMBLOCKBINDINGPROC, UniformBlockBinding)                       \
  F(PFNGLUNIFORMMATRIX2FVPROC, UniformMatrix2fv)                             \
  F(PFNGLUNIFORMMATRIX2X3FVPROC, UniformMatrix2x3fv)                         \
  F(PFNGLUNIFORMMATRIX2X4FVPROC, UniformMatrix2x4fv)                         \
  F(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)                             \
  F(PFNGLUNIFORMMATRIX3X2FVPROC, UniformMatrix3x2fv)                         \
  F(PFNGLUNIFORMMATRIX3X4FVPROC, UniformMatrix3x4fv)                         \
  F(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                             \
  F(PFNGLUNIFORMMATRIX4X2FVPROC, UniformMatrix4x2fv)                         \
  F(PFNGLUNIFORMMATRIX4X3FVPROC, UniformMatrix4x3fv)                         \
  F(PFNGLUNMAPBUFFERPROC, UnmapBuffer)                                       \
  F(PFNGLUSEPROGRAMPROC, UseProgram)                                         \
  F(PFNGLVERTEXATTRIBIPOINTERPROC, VertexAttribIPointer)                     \
  F(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                       \
  F(PFNGLVIEWPORTPROC, Viewport)

struct Gl {
#define CLIPC_GL_MEMBER(Type, Name) Type Name;
  CLIPC_GL_FUNCTIONS(CLIPC_GL_MEMBER)
#undef CLIPC_GL_MEMBER
  // Absent in some contexts.
  PFNGLCLIPCONTROLPROC ClipControl;
  PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXBASEINSTANCEPROC DrawElementsInstancedBaseVertexBaseInstance;
  ClipPlaneProc ClipPlane;
};

enum class Api { kCore, kCompatibility, kEs };

// A shader's first line.
struct Version {
  int number = 110;
  bool es = false;
  Api api = Api::kCompatibility;  // of a context that compiles it

  std::string Line() const;
};
Version VersionOf(const std::string& glsl);

// The machine's OpenGL: one context for each Api, made when first asked for. One Device for each
// process.
class Device {
 public:
  Device();
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  // Makes that context current. Throws DrawError when there is none.
  const Gl& Use(Api api);

 private:
  struct Context {
    void* handle = nullptr;
    Gl gl{};
  };
  Context Create(Api api) const;

  void* display_ = nullptr;
  std::map<Api, Context> contexts_;
};

// Throws DrawError with `where` when OpenGL has noted an error.
void CheckErrors(const Gl& gl, const std::string& where);

}  // namespace clipc::draw
