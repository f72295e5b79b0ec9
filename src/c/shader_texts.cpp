// SPDX-License-Identifier: Apache-2.0
#include "c/shader_texts.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "c/call.h"
#include "tables/shader_assembly.h"

using namespace litfog;

namespace {

std::string_view text_of(std::string_view name) {
  const auto texts = c::shader_texts();
  const auto found = std::ranges::find(texts, name, &litfog_shader_text::name);
  if (found != texts.end()) return found->text;
  throw std::invalid_argument("#include \"" + std::string(name) + "\": must be a file of litfog_shader_texts()");
}

}  // namespace

litfog_status litfog_shader_texts(const litfog_shader_text** texts, size_t* count) {
  return c::call([&] {
    c::at(texts, "texts");
    c::at(count, "count") = c::shader_texts().size();
    *texts = c::shader_texts().data();
  });
}

litfog_status litfog_expand_shader(const char* source, char* expanded, size_t size, size_t* length) {
  return c::call([&] {
    c::at(length, "length");
    const std::span<char> to = c::array(expanded, size, "expanded");
    ShaderAssembly assembly(text_of);
    assembly.add_source("", &c::at(source, "source"));
    const std::string& text = assembly.text();
    if (text.size() < to.size()) std::copy_n(text.c_str(), text.size() + 1, to.data());
    *length = text.size();
  });
}
