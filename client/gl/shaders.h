#pragma once

namespace burnish {

/// GLSL 3.30 sources. Shading is computed in linear light and in camera space, so the light moves
/// with the camera.
extern const char* const kPageVertexShader;
extern const char* const kPageFragmentShader;  ///< with kPageVertexShader
extern const char* const kBackgroundVertexShader;
extern const char* const kBackgroundFragmentShader;

}  // namespace burnish
