#pragma once
// The subset of OpenGL that this room uses: functions and constants of 4.1 core that WebGL2 also
// has. Declared here so that newer ones cannot be used by mistake. Internal to view. Source:
// the OpenGL 4.1 and ES 3.0 specifications (Khronos).

#include "scenefile/view/draw.h"

#include <cstddef>
#include <cstdint>
#include <string>

#if defined(_WIN32)
#define SCENEFILE_GL_CALL __stdcall
#else
#define SCENEFILE_GL_CALL
#endif

namespace scenefile::gl {

using Enum = unsigned;
using Name = unsigned;  ///< of an object; 0 means none
using Size = int;
using Pointer = std::ptrdiff_t;

inline constexpr Enum TRIANGLES = 0x0004, LINES = 0x0001, UNSIGNED_INT = 0x1405, FLOAT = 0x1406,
                      UNSIGNED_BYTE = 0x1401, ARRAY_BUFFER = 0x8892, ELEMENT_ARRAY_BUFFER = 0x8893,
                      STATIC_DRAW = 0x88E4, STREAM_DRAW = 0x88E0, DEPTH_TEST = 0x0B71,
                      BLEND = 0x0BE2, CULL_FACE = 0x0B44, FRONT = 0x0404, BACK = 0x0405,
                      LEQUAL = 0x0203, LESS = 0x0201, ZERO = 0, ONE = 1, SRC_COLOR = 0x0300,
                      COLOR_BUFFER_BIT = 0x4000, DEPTH_BUFFER_BIT = 0x0100, VERTEX_SHADER = 0x8B31,
                      FRAGMENT_SHADER = 0x8B30, COMPILE_STATUS = 0x8B81, LINK_STATUS = 0x8B82,
                      TEXTURE_2D = 0x0DE1, TEXTURE_2D_ARRAY = 0x8C1A, TEXTURE0 = 0x84C0,
                      TEXTURE_MIN_FILTER = 0x2801, TEXTURE_MAG_FILTER = 0x2800,
                      TEXTURE_WRAP_S = 0x2802, TEXTURE_WRAP_T = 0x2803, NEAREST = 0x2600,
                      LINEAR = 0x2601, LINEAR_MIPMAP_LINEAR = 0x2703, REPEAT = 0x2901,
                      CLAMP_TO_EDGE = 0x812F, TEXTURE_COMPARE_MODE = 0x884C,
                      TEXTURE_COMPARE_FUNC = 0x884D, COMPARE_REF_TO_TEXTURE = 0x884E,
                      TEXTURE_MAX_LEVEL = 0x813D, RGB = 0x1907, RGBA = 0x1908, RGBA8 = 0x8058,
                      RGB8 = 0x8051, RGBA32F = 0x8814, RGBA16F = 0x881A, DEPTH_COMPONENT = 0x1902,
                      DEPTH_COMPONENT24 = 0x81A6, FRAMEBUFFER = 0x8D40, READ_FRAMEBUFFER = 0x8CA8,
                      DRAW_FRAMEBUFFER = 0x8CA9, RENDERBUFFER = 0x8D41, COLOR_ATTACHMENT0 = 0x8CE0,
                      DEPTH_ATTACHMENT = 0x8D00, FRAMEBUFFER_COMPLETE = 0x8CD5, VERSION = 0x1F02,
                      RENDERER = 0x1F01, MAJOR_VERSION = 0x821B, MINOR_VERSION = 0x821C,
                      MAX_SAMPLES = 0x8D57, MAX_TEXTURE_SIZE = 0x0D33,
                      MAX_RENDERBUFFER_SIZE = 0x84E8, MAX_ARRAY_TEXTURE_LAYERS = 0x88FF,
                      PACK_ALIGNMENT = 0x0D05, UNPACK_ALIGNMENT = 0x0CF5,
                      POLYGON_OFFSET_FILL = 0x8037, NONE = 0;

// ROW(return type, name without gl, parameters)
#define SCENEFILE_GL_FUNCTIONS(ROW)                                                       \
  ROW(void, ActiveTexture, (Enum))                                                        \
  ROW(void, AttachShader, (Name, Name))                                                   \
  ROW(void, BindBuffer, (Enum, Name))                                                     \
  ROW(void, BindFramebuffer, (Enum, Name))                                                \
  ROW(void, BindRenderbuffer, (Enum, Name))                                               \
  ROW(void, BindTexture, (Enum, Name))                                                    \
  ROW(void, BindVertexArray, (Name))                                                      \
  ROW(void, BlendFunc, (Enum, Enum))                                                      \
  ROW(void, BlitFramebuffer, (int, int, int, int, int, int, int, int, unsigned, Enum))    \
  ROW(void, BufferData, (Enum, Pointer, const void*, Enum))                               \
  ROW(Enum, CheckFramebufferStatus, (Enum))                                               \
  ROW(void, Clear, (unsigned))                                                            \
  ROW(void, ClearColor, (float, float, float, float))                                     \
  ROW(void, ColorMask, (unsigned char, unsigned char, unsigned char, unsigned char))      \
  ROW(void, CompileShader, (Name))                                                        \
  ROW(Name, CreateProgram, ())                                                            \
  ROW(Name, CreateShader, (Enum))                                                         \
  ROW(void, CullFace, (Enum))                                                             \
  ROW(void, DeleteBuffers, (Size, const Name*))                                           \
  ROW(void, DeleteFramebuffers, (Size, const Name*))                                      \
  ROW(void, DeleteProgram, (Name))                                                        \
  ROW(void, DeleteRenderbuffers, (Size, const Name*))                                     \
  ROW(void, DeleteShader, (Name))                                                         \
  ROW(void, DeleteTextures, (Size, const Name*))                                          \
  ROW(void, DeleteVertexArrays, (Size, const Name*))                                      \
  ROW(void, DepthFunc, (Enum))                                                            \
  ROW(void, DepthMask, (unsigned char))                                                   \
  ROW(void, Disable, (Enum))                                                              \
  ROW(void, DrawArrays, (Enum, int, Size))                                                \
  ROW(void, DrawElementsInstanced, (Enum, Size, Enum, const void*, Size))                 \
  ROW(void, Enable, (Enum))                                                               \
  ROW(void, EnableVertexAttribArray, (Name))                                              \
  ROW(void, Finish, ())                                                                   \
  ROW(void, FramebufferRenderbuffer, (Enum, Enum, Enum, Name))                            \
  ROW(void, FramebufferTexture2D, (Enum, Enum, Enum, Name, int))                          \
  ROW(void, FramebufferTextureLayer, (Enum, Enum, Name, int, int))                        \
  ROW(void, GenBuffers, (Size, Name*))                                                    \
  ROW(void, GenFramebuffers, (Size, Name*))                                               \
  ROW(void, GenRenderbuffers, (Size, Name*))                                              \
  ROW(void, GenTextures, (Size, Name*))                                                   \
  ROW(void, GenVertexArrays, (Size, Name*))                                               \
  ROW(void, GenerateMipmap, (Enum))                                                       \
  ROW(void, GetIntegerv, (Enum, int*))                                                    \
  ROW(void, GetProgramInfoLog, (Name, Size, Size*, char*))                                \
  ROW(void, GetProgramiv, (Name, Enum, int*))                                             \
  ROW(void, GetShaderInfoLog, (Name, Size, Size*, char*))                                 \
  ROW(void, GetShaderiv, (Name, Enum, int*))                                              \
  ROW(const unsigned char*, GetString, (Enum))                                            \
  ROW(int, GetUniformLocation, (Name, const char*))                                       \
  ROW(void, LinkProgram, (Name))                                                          \
  ROW(void, PixelStorei, (Enum, int))                                                     \
  ROW(void, PolygonOffset, (float, float))                                                \
  ROW(void, ReadBuffer, (Enum))                                                           \
  ROW(void, ReadPixels, (int, int, Size, Size, Enum, Enum, void*))                        \
  ROW(void, RenderbufferStorageMultisample, (Enum, Size, Enum, Size, Size))               \
  ROW(void, ShaderSource, (Name, Size, const char* const*, const int*))                   \
  ROW(void, TexImage2D, (Enum, int, int, Size, Size, int, Enum, Enum, const void*))       \
  ROW(void, TexImage3D, (Enum, int, int, Size, Size, Size, int, Enum, Enum, const void*)) \
  ROW(void, TexParameteri, (Enum, Enum, int))                                             \
  ROW(void, Uniform1f, (int, float))                                                      \
  ROW(void, Uniform1i, (int, int))                                                        \
  ROW(void, Uniform3f, (int, float, float, float))                                        \
  ROW(void, Uniform4fv, (int, Size, const float*))                                        \
  ROW(void, UniformMatrix4fv, (int, Size, unsigned char, const float*))                   \
  ROW(void, UseProgram, (Name))                                                           \
  ROW(void, VertexAttribDivisor, (Name, Name))                                            \
  ROW(void, VertexAttribPointer, (Name, int, Enum, unsigned char, Size, const void*))     \
  ROW(void, Viewport, (int, int, Size, Size))

/// The functions by name.
struct Functions {
  bool es = false;  ///< of OpenGL ES, such as WebGL2
#define ROW(result, name, parameters) result(SCENEFILE_GL_CALL* name) parameters = nullptr;
  SCENEFILE_GL_FUNCTIONS(ROW)
#undef ROW
};

/// Returns the name of the first missing function; empty if all were found.
std::string load(GetProcAddress find, Functions& functions);

}  // namespace scenefile::gl
