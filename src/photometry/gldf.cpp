// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/gldf.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

#include "litfog/input_error.h"
#include "photometry/gldf_archive.h"
#include "photometry/luminaire_text.h"
#include "photometry/text_encoding.h"
#include "photometry/xml_text.h"

namespace litfog {
namespace {

constexpr const char* kProduct = "product.xml";
constexpr std::string_view kFolder = "ldc/";  // holds photometric files; their content types begin with it
constexpr std::size_t kMaxNameBytes = 4096;   // longest name of an entry that is kept

using OpenArchive = std::unique_ptr<std::remove_pointer_t<unzFile>, decltype(&unzClose)>;

OpenArchive open_archive(const std::string& path) {
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(path, error);  // a pipe would be waited for
  OpenArchive archive(is_file ? unzOpen64(path.c_str()) : nullptr, unzClose);
  if (!archive) throw InputError({.file = path}, "zip archive", "", "must be whole");
  return archive;
}

/// Replaces the backslashes that Windows programs write into names.
std::string with_slashes(std::string_view name) {
  std::string result(name);
  std::ranges::replace(result, '\\', '/');
  return result;
}

/// The entries that product.xml defines as photometric files in the archive.
std::vector<std::string> entries_of(const XmlText& product) {
  const pugi::xml_node files = product.root().child("GeneralDefinitions").child("Files");
  std::vector<std::string> entries;
  std::set<std::string> known;
  for (const pugi::xml_node& file : files.children("File")) {
    const bool is_photometric = product.value_of(file, "contentType").text.starts_with(kFolder);
    if (!is_photometric || product.value_of(file, "type").text == "url") continue;
    const std::string entry = std::string(kFolder) + with_slashes(product.text_of(file).text);
    if (!known.insert(entry).second) continue;
    if (entries.size() == kMaxGldfEntries) product.fail(file, "must not be another photometric file after 10000");
    entries.push_back(entry);
  }
  if (entries.empty()) {
    product.fail(product.root(), "must define a File of a contentType ldc/... that is in the archive");
  }
  return entries;
}

}  // namespace

GldfArchive::GldfArchive(std::string path) : path_(std::move(path)) {
  const OpenArchive archive = open_archive(path_);
  std::array<char, kMaxNameBytes> name;
  int count = 0;
  for (int status = unzGoToFirstFile(archive.get()); status == UNZ_OK; status = unzGoToNextFile(archive.get())) {
    if (++count > kMaxGldfEntries) {
      throw InputError({.file = path_}, "zip archive", "", "must not have more than 10000 entries");
    }
    unz_file_info64 info;
    Entry entry{};
    if (unzGetCurrentFileInfo64(archive.get(), &info, name.data(), name.size(), nullptr, 0, nullptr, 0) != UNZ_OK ||
        unzGetFilePos64(archive.get(), &entry.position) != UNZ_OK) {
      break;
    }
    if (info.size_filename > name.size()) continue;
    entry.packed_bytes = info.compressed_size;
    entry.bytes = info.uncompressed_size;
    constexpr unsigned kStored = 0;
    entry.is_known = info.compression_method == kStored || info.compression_method == Z_DEFLATED;
    entries_.emplace(with_slashes({name.data(), info.size_filename}), entry);
  }
}

const GldfArchive::Entry* GldfArchive::find(const std::string& entry) const {
  auto found = entries_.find(entry);
  if (found == entries_.end()) {
    const std::optional<std::string> stored = code_page_850_from_utf8(entry);  // by programs that do not store UTF-8
    if (stored) found = entries_.find(*stored);
  }
  return found == entries_.end() ? nullptr : &found->second;
}

std::string GldfArchive::read(const std::string& entry) const {
  const std::string name = path_ + "/" + entry;
  const OpenArchive archive = open_archive(path_);
  const Entry* const found = find(entry);
  if (found == nullptr) throw InputError({.file = name}, "file", "", "must be in the archive");
  const InputError broken({.file = name}, "file", "",
                          "must be readable: its data are broken, or packed in another way");
  if (unzGoToFilePos64(archive.get(), &found->position) != UNZ_OK) throw broken;
  if (!found->is_known) throw broken;
  if (unzOpenCurrentFile(archive.get()) != UNZ_OK) throw broken;
  std::string bytes;
  std::array<char, 65536> buffer;
  int count;
  // Nothing is allocated for the archive's own count of bytes: the unpacked bytes are counted.
  while ((count = unzReadCurrentFile(archive.get(), buffer.data(), buffer.size())) > 0) {
    bytes.append(buffer.data(), std::size_t(count));
    if (bytes.size() > kMaxPhotometricBytes) {
      throw InputError({.file = name}, "file", "", "must not be larger than 67108864 bytes");
    }
  }
  if (count < 0 || unzCloseCurrentFile(archive.get()) != UNZ_OK) throw broken;
  return bytes;
}

void GldfArchive::expect_sound(const std::vector<std::string>& entries) const {
  const OpenArchive archive = open_archive(path_);
  struct Extent {
    std::uint64_t begin, end;
    const std::string* name;
  };
  std::vector<Extent> extents;
  std::uint64_t bytes = 0;
  for (const std::string& name : entries) {
    const Entry* const entry = find(name);
    if (entry == nullptr) continue;
    // An entry never gives more than the directory says. Each term is limited: the sum cannot overflow.
    bytes += std::min(entry->bytes, kMaxGldfBytes + 1);
    if (bytes > kMaxGldfBytes) {
      throw InputError({.file = path_}, "photometric files", "", "must not unpack to more than 268435456 bytes");
    }
    constexpr int kAsPacked = 1;
    int method, level;
    const bool is_open = unzGoToFilePos64(archive.get(), &entry->position) == UNZ_OK &&
                         unzOpenCurrentFile2(archive.get(), &method, &level, kAsPacked) == UNZ_OK;
    if (!is_open) continue;  // it cannot be read either
    const std::uint64_t begin = unzGetCurrentFileZStreamPos64(archive.get());
    extents.push_back({begin, begin + entry->packed_bytes, &name});
    unzCloseCurrentFile(archive.get());
  }
  std::ranges::sort(extents, {}, &Extent::begin);
  for (std::size_t i = 1; i < extents.size(); ++i) {
    const Extent &before = extents[i - 1], &extent = extents[i];
    if (extent.begin > before.end) continue;  // its header lies between
    throw InputError({.file = path_ + "/" + *extent.name}, "file", "", "must not share its bytes with " + *before.name);
  }
}

GldfContainer::GldfContainer(const std::string& path) : archive_(std::make_shared<const GldfArchive>(path)) {
  const std::vector<std::string> entries =
      entries_of(XmlText(archive_->read(kProduct), path + "/" + std::string(kProduct)));
  archive_->expect_sound(entries);
  for (const std::string& entry : entries) files_.push_back(path + "/" + entry);
}

Luminaire GldfContainer::read(const std::string& file) const {
  const std::string& path = archive_->path();
  const bool is_inside = file.starts_with(path) && file.size() > path.size();
  return parse_luminaire(archive_->read(is_inside ? file.substr(path.size() + 1) : file), file);
}

std::vector<std::string> list_gldf(const std::string& path) { return GldfContainer(path).files(); }

}  // namespace litfog
