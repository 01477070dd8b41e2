#include "client/gl/background.h"

#include "client/gl/shaders.h"

namespace burnish {

Result<std::unique_ptr<Background>> Background::create() {
  ASSIGN_OR_RETURN(ShaderProgram program,
                   ShaderProgram::create("background", kBackgroundVertexShader,
                                         background_fragment_shader().c_str()));
  return std::unique_ptr<Background>(new Background(std::move(program)));
}

Background::Background(ShaderProgram program) : program_(std::move(program)) {
  glGenVertexArrays(1, &vertex_array_);
}

Background::~Background() {
  glDeleteVertexArrays(1, &vertex_array_);
}

void Background::draw() const {
  glDisable(GL_DEPTH_TEST);
  program_.use();
  glBindVertexArray(vertex_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace burnish
