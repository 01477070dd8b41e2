#pragma once

#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/draw_style.h"
#include "client/scene/page_space.h"

namespace burnish {

/// Returns the camera in the units of PageSpace, so that floats suffice for any file unit. Only its
/// projection has a meaning.
Camera in_units(const PageSpace& space, Camera camera);

/// Sets the uniforms of a page's vertex shader.
void set_place(const ShaderProgram& program, const PageSpace& space, const Camera& camera,
               double aspect, bool original);

/// Sets the uniforms of a page's fragment shader.
void set_style(const ShaderProgram& program, const PageSpace& space, const DrawStyle& style);

}  // namespace burnish
