// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "photometry/text_scanner.h"

namespace litfog {

/// An element's name without the prefix of its namespace, which a file may choose.
std::string_view local_name(const pugi::xml_node& element);

/// An element's first child of a local name, or an empty node.
pugi::xml_node child_of(const pugi::xml_node& element, std::string_view name);

/// An XML document that knows the position of each node in its text.
class XmlText {
 public:
  /// Throws InputError if it is not well-formed, or larger than 16 MiB, because a document takes up to 20 times its
  /// text.
  XmlText(std::string bytes, std::string name);

  /// The document's element.
  pugi::xml_node root() const { return document_.document_element(); }
  /// The text within an element, without comments and white space around it, for the scanner's numbers and errors. An
  /// element within it counts as a space.
  TextScanner::Piece text_of(const pugi::xml_node& element) const;
  /// An attribute's value; its location is the element's.
  TextScanner::Piece value_of(const pugi::xml_node& element, const char* attribute) const;
  /// Fails at an element, "element = NAME: rule".
  [[noreturn]] void fail(const pugi::xml_node& element, std::string_view rule) const;
  const TextScanner& scanner() const { return scanner_; }

 private:
  TextScanner scanner_;
  pugi::xml_document document_;
  mutable std::deque<std::string> joined_;  ///< texts that comments or elements divide
};

}  // namespace litfog
