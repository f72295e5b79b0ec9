// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/gldf.h"

#include <unzip.h>

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <type_traits>

#include "gldf_archive.h"
#include "litfog/input_error.h"
#include "text_encoding.h"
#include "xml_text.h"

namespace litfog {
namespace {

constexpr const char* kProduct = "product.xml";
constexpr std::string_view kFolder = "ldc/";  // of photometric files, and the beginning of their content types

using Archive = std::unique_ptr<std::remove_pointer_t<unzFile>, decltype(&unzClose)>;

bool go_to(unzFile archive, const std::string& entry) {
  if (unzLocateFile(archive, entry.c_str(), 1) == UNZ_OK) return true;
  const std::optional<std::string> stored = code_page_850_from_utf8(entry);  // by programs that do not store UTF-8
  return stored && unzLocateFile(archive, stored->c_str(), 1) == UNZ_OK;
}

}  // namespace

std::string read_gldf_entry(const std::string& path, const std::string& entry) {
  const std::string name = path + "/" + entry;
  const Archive archive(unzOpen64(path.c_str()), unzClose);
  if (!archive) throw InputError({.file = path}, "zip archive", "", "must be whole");
  if (!go_to(archive.get(), entry)) throw InputError({.file = name}, "file", "", "must be in the archive");
  const InputError broken({.file = name}, "file", "",
                          "must be readable: its data are broken, or packed in another way");
  if (unzOpenCurrentFile(archive.get()) != UNZ_OK) throw broken;
  std::string bytes;
  std::array<char, 65536> buffer;
  int count;
  // The archive's own count of bytes says nothing: what comes out of it is counted.
  while ((count = unzReadCurrentFile(archive.get(), buffer.data(), buffer.size())) > 0) {
    bytes.append(buffer.data(), std::size_t(count));
    if (bytes.size() > kMaxPhotometricBytes) {
      throw InputError({.file = name}, "file", "", "must not be larger than 67108864 bytes");
    }
  }
  if (count < 0 || unzCloseCurrentFile(archive.get()) != UNZ_OK) throw broken;
  return bytes;
}

std::vector<std::string> list_gldf(const std::string& path) {
  const XmlText product(read_gldf_entry(path, kProduct), path + "/" + kProduct);
  const pugi::xml_node files = product.root().child("GeneralDefinitions").child("Files");
  std::vector<std::string> paths;
  std::set<std::string_view> known;
  for (const pugi::xml_node& file : files.children("File")) {
    const bool is_photometric = product.value_of(file, "contentType").text.starts_with(kFolder);
    if (!is_photometric || product.value_of(file, "type").text == "url") continue;
    const std::string_view name = product.text_of(file).text;
    if (known.insert(name).second) paths.push_back(path + "/" + std::string(kFolder) + std::string(name));
  }
  if (paths.empty()) product.fail(product.root(), "must define a File of a contentType ldc/... that is in the archive");
  return paths;
}

}  // namespace litfog
