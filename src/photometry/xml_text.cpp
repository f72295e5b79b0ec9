// SPDX-License-Identifier: Apache-2.0
#include "photometry/xml_text.h"

#include <new>

#include "text/ascii_text.h"

namespace litfog {
namespace {

constexpr std::size_t kMaxXmlBytes = std::size_t{16} << 20;

/// A node's offset; an element's is that of its '<', one before its name.
std::size_t offset_of(const pugi::xml_node& node) {
  return std::size_t(node.offset_debug()) - (node.type() == pugi::node_element ? 1 : 0);
}

}  // namespace

std::string_view local_name(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

pugi::xml_node child_of(const pugi::xml_node& element, std::string_view name) {
  return element.find_child([name](const pugi::xml_node& child) { return local_name(child) == name; });
}

XmlText::XmlText(std::string bytes, std::string name) : scanner_(std::move(bytes), std::move(name)) {
  const std::string& text = scanner_.text();
  if (text.size() > kMaxXmlBytes) {
    throw InputError({.file = scanner_.name()}, "XML", "", "must not be larger than 16777216 bytes");
  }
  const auto result = document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!result) {
    throw InputError(scanner_.location({{}, std::size_t(result.offset)}), "XML", "",
                     std::string("must be well-formed: ") + result.description());
  }
}

TextScanner::Piece XmlText::text_of(const pugi::xml_node& element) const {
  const pugi::xml_node text = element.first_child();
  return {trimmed(text.value()), offset_of(text ? text : element)};
}

void XmlText::fail(const pugi::xml_node& element, std::string_view rule) const {
  scanner_.fail({element.name(), offset_of(element)}, "element", rule);
}

TextScanner::Piece XmlText::value_of(const pugi::xml_node& element, const char* attribute) const {
  return {trimmed(element.attribute(attribute).value()), offset_of(element)};
}

}  // namespace litfog
