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
  const auto result =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_fragment, pugi::encoding_utf8);
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  const auto fail_at = [this](std::size_t offset, const char* fault) {
    throw InputError(scanner_.location({{}, offset}), "XML", "", std::string("must be well-formed: ") + fault);
  };
  if (!result) fail_at(std::size_t(result.offset), result.description());
  for (const pugi::xml_node& node : document_.children()) {  // pugixml takes any number of elements, and text
    if (node == root()) continue;
    fail_at(text.find_first_not_of(" \t\r\n", offset_of(node)), "Text or an element beside the root");
  }
  if (!root()) fail_at(text.size(), "No document element found");
}

TextScanner::Piece XmlText::text_of(const pugi::xml_node& element) const {
  const pugi::xml_node first = element.first_child();
  const std::size_t offset = offset_of(first ? first : element);
  if (!first.next_sibling()) return {trimmed(first.value()), offset};
  std::string& text = joined_.emplace_back();
  for (const pugi::xml_node& node : element.children()) text += node.type() == pugi::node_element ? " " : node.value();
  return {trimmed(text), offset};
}

void XmlText::fail(const pugi::xml_node& element, std::string_view rule) const {
  scanner_.fail({element.name(), offset_of(element)}, "element", rule);
}

TextScanner::Piece XmlText::value_of(const pugi::xml_node& element, const char* attribute) const {
  const pugi::xml_attribute value = element.attribute(attribute);
  for (pugi::xml_attribute other = value.next_attribute(); other; other = other.next_attribute()) {
    if (std::string_view(other.name()) == attribute) fail(element, std::string("must have one attribute ") + attribute);
  }
  return {trimmed(value.value()), offset_of(element)};
}

}  // namespace litfog
