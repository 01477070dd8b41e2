#pragma once

#include <string>

namespace burnish {

/// GLSL sources for ShaderProgram, without a version and without shade_constants(). Shading is
/// computed in linear light and in camera space, so the light moves with the camera.
extern const char* const kPageVertexShader;
extern const char* const kPageLights;       ///< part of page_fragment_shader(): every LightKind
extern const char* const kPagePixels;       ///< part of page_fragment_shader(): the rest
extern const char* const kPageTexels;       ///< part of page_fragment_shader(): the scan's colours
extern const char* const kGBufferParts;     ///< reads what GBufferTarget holds
extern const char* const kOcclusionPixels;  ///< part of occlusion_shader()
extern const char* const kGBufferPixels;    ///< part of g_buffer_shader()
extern const char* const kBackgroundVertexShader;
extern const char* const kBackgroundFragmentPixels;  ///< part of background_fragment_shader()

/// Returns client/scene/shade_constants.h in GLSL, which client/raster has too.
std::string shade_constants();

/// With kBackgroundVertexShader.
std::string background_fragment_shader();

/// With kPageVertexShader. Writes the lit colour, and for GBufferTarget the normal.
std::string page_fragment_shader();

/// With kBackgroundVertexShader. Writes ambient occlusion from 0 to 1.
std::string occlusion_shader();

/// With kBackgroundVertexShader. Averages the samples, each with the light of its surroundings.
std::string g_buffer_shader();

}  // namespace burnish
