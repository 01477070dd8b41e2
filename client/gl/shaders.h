#pragma once

namespace burnish {

/// GLSL 3.30 sources. Light and colour are computed in linear light in camera space, so that a
/// turn of the camera never moves the light off the surface.
extern const char* const kMeshVertexShader;
extern const char* const kMeshFragmentShader;
extern const char* const kPickFragmentShader;  ///< with the mesh's vertex shader
extern const char* const kBackgroundVertexShader;
extern const char* const kBackgroundFragmentShader;

}  // namespace burnish
