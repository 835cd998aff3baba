// SPDX-License-Identifier: MIT
#include "render/shader.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"
#include "shader_files.h"

namespace ballpit {

namespace {

std::string_view shader_text(const std::string& file) {
  const auto& files = shader_files();
  const auto found = std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& f) { return f.name == file; });
  if (found == files.end()) throw RunError(file, "no shader of this program");
  return found->text;
}

/// The file with its includes replaced; #line keeps the line numbers in the driver's messages those of the file.
std::string preprocessed(const std::string& file) {
  constexpr std::string_view kInclude = "#include \"";
  std::string result;
  std::string_view rest = shader_text(file);
  for (int line = 1; !rest.empty(); ++line) {
    const size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    const std::string_view text = rest.substr(0, end);
    rest.remove_prefix(end);
    if (text.starts_with(kInclude)) {
      const std::string_view name = text.substr(kInclude.size(), text.find('"', kInclude.size()) - kInclude.size());
      result += fmt::format("{}#line {}\n", preprocessed(std::string(name)), line + 1);
    } else {
      result += text;
    }
  }
  return result;
}

/// What the driver says of a shader or program.
std::string log_of(GLuint name, PFNGLGETSHADERINFOLOGPROC get_log) {
  std::string log(4096, '\0');
  GLsizei length = 0;
  get_log(name, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<size_t>(length));
  return log;
}

class ShaderStage {
 public:
  ShaderStage(GLuint program, GLenum type, const std::string& file) : program_(program), name_(glCreateShader(type)) {
    const std::string text = preprocessed(file);
    const char* source = text.c_str();
    glShaderSource(name_, 1, &source, nullptr);
    glCompileShader(name_);
    GLint compiled = GL_FALSE;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
    glAttachShader(program_, name_);
    if (compiled) return;
    const std::string log = log_of(name_, glGetShaderInfoLog);
    glDeleteShader(name_);
    throw RunError(file, "the shader does not compile: " + log);
  }
  ShaderStage(const ShaderStage&) = delete;
  ShaderStage& operator=(const ShaderStage&) = delete;
  ~ShaderStage() {
    glDetachShader(program_, name_);
    glDeleteShader(name_);
  }

 private:
  GLuint program_, name_;
};

}  // namespace

Shader::Shader(const std::string& vertex_file, const std::string& fragment_file)
    : name_(vertex_file + " + " + fragment_file) {
  const ShaderStage vertex(program_.name(), GL_VERTEX_SHADER, vertex_file);
  const ShaderStage fragment(program_.name(), GL_FRAGMENT_SHADER, fragment_file);
  glLinkProgram(program_.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
  if (!linked) throw RunError(name_, "the shaders do not link: " + log_of(program_.name(), glGetProgramInfoLog));
}

GLint Shader::location(const char* uniform) const {
  const GLint found = glGetUniformLocation(program_.name(), uniform);
  if (found < 0) throw RunError(name_, std::string("the shaders have no uniform ") + uniform);
  return found;
}

}  // namespace ballpit
