// SPDX-License-Identifier: MIT
#include "render/shader.h"

#include <algorithm>
#include <string_view>

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

/// The file with its includes in place; #line keeps the compiler's line numbers those of the file.
std::string preprocessed(const std::string& file) {
  constexpr std::string_view kInclude = "#include \"";
  std::string result;
  std::string_view rest = shader_text(file);
  for (int line = 1; !rest.empty(); ++line) {
    const size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    const std::string_view text = rest.substr(0, end);
    rest.remove_prefix(end);
    if (text.substr(0, kInclude.size()) == kInclude) {
      const std::string_view name = text.substr(kInclude.size(), text.find('"', kInclude.size()) - kInclude.size());
      result += preprocessed(std::string(name)) + "#line " + std::to_string(line + 1) + "\n";
    } else {
      result += text;
    }
  }
  return result;
}

class ShaderStage {
 public:
  ShaderStage(GLenum type, const std::string& file) : name_(glCreateShader(type)) {
    const std::string text = preprocessed(file);
    const char* source = text.c_str();
    glShaderSource(name_, 1, &source, nullptr);
    glCompileShader(name_);
    GLint compiled = GL_FALSE;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
    if (compiled) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(name_, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<size_t>(length));
    glDeleteShader(name_);
    throw RunError(file, "the shader does not compile: " + log);
  }
  ShaderStage(const ShaderStage&) = delete;
  ShaderStage& operator=(const ShaderStage&) = delete;
  ~ShaderStage() { glDeleteShader(name_); }

  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

}  // namespace

Shader::Shader(const std::string& vertex_file, const std::string& fragment_file)
    : name_(vertex_file + " + " + fragment_file) {
  const ShaderStage vertex(GL_VERTEX_SHADER, vertex_file);
  const ShaderStage fragment(GL_FRAGMENT_SHADER, fragment_file);
  glAttachShader(program_.name(), vertex.name());
  glAttachShader(program_.name(), fragment.name());
  glLinkProgram(program_.name());
  glDetachShader(program_.name(), vertex.name());
  glDetachShader(program_.name(), fragment.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
  if (linked) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program_.name(), static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<size_t>(length));
  throw RunError(name_, "the shaders do not link: " + log);
}

GLint Shader::location(const char* uniform) const {
  const GLint found = glGetUniformLocation(program_.name(), uniform);
  if (found < 0) throw RunError(name_, std::string("the shaders have no uniform ") + uniform);
  return found;
}

void Shader::set(const char* uniform, int value) const {
  glProgramUniform1i(program_.name(), location(uniform), value);
}

void Shader::set(const char* uniform, float value) const {
  glProgramUniform1f(program_.name(), location(uniform), value);
}

void Shader::set(const char* uniform, const Vec3& value) const {
  glProgramUniform3fv(program_.name(), location(uniform), 1, &value[0]);
}

void Shader::set(const char* uniform, const Vec4& value) const {
  glProgramUniform4fv(program_.name(), location(uniform), 1, &value[0]);
}

}  // namespace ballpit
