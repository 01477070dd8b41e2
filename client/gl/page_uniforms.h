#pragma once

#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/draw_style.h"
#include "client/scene/page_space.h"

namespace burnish {

/// Sets the uniforms of a page's vertex shader.
void set_place(const ShaderProgram& program, const PageSpace& space, const Camera& camera,
               double aspect, bool original);

/// Sets the uniforms of a page's fragment shader.
void set_style(const ShaderProgram& program, const PageSpace& space, const DrawStyle& style);

}  // namespace burnish
