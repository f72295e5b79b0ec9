// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie_file.h"

#include <OpenEXR/openexr.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>

#include "litfog/input_error.h"
#include "model/require.h"
#include "photometry/text_scanner.h"
#include "text/file_text.h"

namespace litfog {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{400} << 20;  // texels that zip does not shrink are stored as they are
constexpr uint64_t kMaxExpansion = 1032;                       // deflate's, https://zlib.net/zlib_tech.html
constexpr int kPart = 0;
constexpr const char* kComment =
    "litfog cookie: a light's intensity per its peak by direction; the faces +x -x +y -y +z -z of a cube map from the "
    "top, as glTexImage2D takes them; the axis is -z, +y is up";

/// A file by OpenEXR's C interface: unlike C++'s, it lets a size be checked before memory is allocated for it.
struct Finish {
  void operator()(exr_context_t context) const { exr_finish(&context); }
};
using Exr = std::unique_ptr<std::remove_pointer_t<exr_context_t>, Finish>;

exr_context_initializer_t quiet_initializer() {
  exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
  initializer.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};  // else it prints
  return initializer;
}

/// Throws if memory is short, which is the fault of no file.
void expect_memory(exr_result_t result) {
  if (result == EXR_ERR_OUT_OF_MEMORY) throw std::bad_alloc();
}

int64_t read_from_view(exr_const_context_t, void* bytes, void* buffer, uint64_t size, uint64_t offset,
                       exr_stream_error_func_ptr_t) {
  const auto& view = *static_cast<const std::string_view*>(bytes);
  if (offset >= view.size()) return 0;
  return int64_t(view.copy(static_cast<char*>(buffer), size, offset));
}

int64_t size_of_view(exr_const_context_t, void* bytes) {
  return int64_t(static_cast<const std::string_view*>(bytes)->size());
}

int64_t write_to_string(exr_const_context_t, void* bytes, const void* buffer, uint64_t size, uint64_t offset,
                        exr_stream_error_func_ptr_t) try {
  auto& text = *static_cast<std::string*>(bytes);
  text.resize(std::max(text.size(), std::size_t(offset + size)));
  std::memcpy(text.data() + offset, buffer, size);
  return int64_t(size);
} catch (const std::bad_alloc&) {  // GCOV_EXCL_START: no test runs out of memory here
  return -1;                       // no exception may pass through C: EXR_ERR_WRITE_IO
}  // GCOV_EXCL_STOP

// --- writing ---

void require_success(exr_result_t result) {
  expect_memory(result == EXR_ERR_WRITE_IO ? EXR_ERR_OUT_OF_MEMORY : result);
  if (result != EXR_ERR_SUCCESS) throw std::runtime_error(exr_get_default_error_message(result));
}

void write_header(exr_context_t exr, int size) {
  int part;
  require_success(exr_add_part(exr, "cookie", EXR_STORAGE_SCANLINE, &part));
  require_success(exr_initialize_required_attr_simple(exr, part, size, 6 * size, EXR_COMPRESSION_ZIP));
  require_success(exr_add_channel(exr, part, "Y", EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LINEAR, 1, 1));
  require_success(exr_attr_set_string(exr, part, "comments", kComment));
  require_success(exr_write_header(exr));
}

using Compress = exr_result_t (*)(exr_encode_pipeline_t*);

/// Readers take a chunk of the size of its texels as uncompressed. OpenEXR 3.1's own function, the pipeline's user
/// data, leaves a chunk compressed that is neither smaller nor larger.
exr_result_t compress_or_keep(exr_encode_pipeline_t* pipeline) {
  const exr_result_t result = (*static_cast<const Compress*>(pipeline->encoding_user_data))(pipeline);
  if (result == EXR_ERR_SUCCESS && pipeline->compressed_bytes == pipeline->packed_bytes) {
    std::memcpy(pipeline->compressed_buffer, pipeline->packed_buffer, pipeline->packed_bytes);
  }
  return result;
}

/// Writes a chunk of rows, and returns the row after it.
int write_chunk(exr_context_t exr, int row, const Cookie& cookie) {
  exr_chunk_info_t chunk;
  require_success(exr_write_scanline_chunk_info(exr, kPart, row, &chunk));
  exr_encode_pipeline_t pipeline{};
  exr_result_t result = exr_encoding_initialize(exr, kPart, &chunk, &pipeline);
  if (result == EXR_ERR_SUCCESS) {
    const float* const texels = cookie.texels.data() + std::size_t(row) * std::size_t(cookie.size);
    exr_coding_channel_info_t& channel = pipeline.channels[0];
    channel.encode_from_ptr = reinterpret_cast<const uint8_t*>(texels);
    channel.user_pixel_stride = sizeof(float);
    channel.user_line_stride = int(sizeof(float)) * cookie.size;
    result = exr_encoding_choose_default_routines(exr, kPart, &pipeline);
  }
  Compress compress = pipeline.compress_fn;
  pipeline.encoding_user_data = &compress;
  pipeline.compress_fn = compress_or_keep;
  if (result == EXR_ERR_SUCCESS) result = exr_encoding_run(exr, kPart, &pipeline);
  exr_encoding_destroy(exr, &pipeline);
  require_success(result);
  return row + chunk.height;
}

// --- reading ---

class CookieParser {
 public:
  CookieParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {
    exr_context_initializer_t initializer = quiet_initializer();
    initializer.user_data = &bytes_;
    initializer.read_fn = read_from_view;
    initializer.size_fn = size_of_view;
    initializer.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    exr_context_t context = nullptr;
    expect_success(exr_start_read(&context, name.c_str(), &initializer));
    exr_.reset(context);
  }
  CookieParser(const CookieParser&) = delete;
  CookieParser& operator=(const CookieParser&) = delete;

  Cookie parse() const {
    expect_storage();
    expect_channel();
    Cookie cookie{.size = expect_size(), .texels = {}};
    cookie.texels.resize(6 * std::size_t(cookie.size) * std::size_t(cookie.size));
    for (int row = 0; row < 6 * cookie.size;) row = parse_chunk(row, cookie);
    if (const auto error = find_error(cookie)) throw InputError({.file = name_}, *error);
    return cookie;
  }

 private:
  [[noreturn]] void fail(std::string_view what, const std::string& value, std::string_view rule) const {
    throw InputError({.file = name_}, what, value, rule);
  }

  void expect_success(exr_result_t result) const {
    if (result == EXR_ERR_SUCCESS) return;
    expect_memory(result);
    throw InputError({.file = name_},
                     std::string("cannot be read as OpenEXR: ") + exr_get_default_error_message(result));
  }

  void expect_storage() const {
    int parts;
    expect_success(exr_get_count(exr_.get(), &parts));
    if (parts != 1) fail("parts", std::to_string(parts), "must be 1");
    exr_storage_t storage;
    expect_success(exr_get_storage(exr_.get(), kPart, &storage));
    if (storage != EXR_STORAGE_SCANLINE) fail("storage", "", "must be scan lines");
    exr_compression_t compression;
    expect_success(exr_get_compression(exr_.get(), kPart, &compression));
    if (compression != EXR_COMPRESSION_ZIP) fail("compression", "", "must be zip, of 16 rows at a time");
  }

  void expect_channel() const {
    const exr_attr_chlist_t* channels;
    expect_success(exr_get_channels(exr_.get(), kPart, &channels));
    if (channels->num_channels != 1) fail("channels", std::to_string(channels->num_channels), "must be 1");
    const exr_attr_chlist_entry_t& channel = channels->entries[0];
    if (channel.pixel_type != EXR_PIXEL_FLOAT) fail("channel", excerpt(channel.name.str), "must be of 32-bit floats");
    if (channel.x_sampling != 1 || channel.y_sampling != 1) {
      fail("channel", excerpt(channel.name.str), "must have a sample for each texel");
    }
  }

  int expect_size() const {
    exr_attr_box2i_t window;
    expect_success(exr_get_data_window(exr_.get(), kPart, &window));
    const auto& [min, max] = window;
    const auto width = int64_t{max.x} - min.x + 1;
    const auto height = int64_t{max.y} - min.y + 1;
    if (min.x != 0 || min.y != 0 || width < 1 || width > kMaxCookieSize || height != 6 * width) {
      fail("size", std::to_string(width) + "x" + std::to_string(height),
           "must be N x 6 N from (0, 0), six faces in a column, N at most 4096");
    }
    if (uint64_t(width * height) * sizeof(float) > kMaxExpansion * bytes_.size()) {
      fail("size", std::to_string(width) + "x" + std::to_string(height), "must not be more than the file can hold");
    }
    return int(width);
  }

  /// Decodes a chunk of rows, and returns the row after it.
  int parse_chunk(int row, Cookie& cookie) const {
    exr_chunk_info_t chunk;
    expect_success(exr_read_scanline_chunk_info(exr_.get(), kPart, row, &chunk));
    exr_decode_pipeline_t pipeline{};
    exr_result_t result = exr_decoding_initialize(exr_.get(), kPart, &chunk, &pipeline);
    if (result == EXR_ERR_SUCCESS) {
      float* const texels = cookie.texels.data() + std::size_t(row) * std::size_t(cookie.size);
      exr_coding_channel_info_t& channel = pipeline.channels[0];
      channel.decode_to_ptr = reinterpret_cast<uint8_t*>(texels);
      channel.user_pixel_stride = sizeof(float);
      channel.user_line_stride = int(sizeof(float)) * cookie.size;
      channel.user_bytes_per_element = sizeof(float);
      channel.user_data_type = EXR_PIXEL_FLOAT;
      result = exr_decoding_choose_default_routines(exr_.get(), kPart, &pipeline);
    }
    if (result == EXR_ERR_SUCCESS) result = exr_decoding_run(exr_.get(), kPart, &pipeline);
    exr_decoding_destroy(exr_.get(), &pipeline);
    expect_success(result);
    return row + chunk.height;
  }

  std::string_view bytes_;
  const std::string& name_;
  Exr exr_;
};

}  // namespace

std::string format_cookie(const Cookie& cookie) {
  require(find_error(cookie));
  std::string bytes;
  exr_context_initializer_t initializer = quiet_initializer();
  initializer.user_data = &bytes;
  initializer.write_fn = write_to_string;
  exr_context_t context = nullptr;
  require_success(exr_start_write(&context, "cookie.exr", EXR_WRITE_FILE_DIRECTLY, &initializer));
  Exr exr(context);
  write_header(context, cookie.size);
  for (int row = 0; row < 6 * cookie.size;) row = write_chunk(context, row, cookie);
  exr.release();
  require_success(exr_finish(&context));
  return bytes;
}

Cookie parse_cookie(std::string_view bytes, const std::string& name) { return CookieParser(bytes, name).parse(); }

Cookie read_cookie(const std::string& path) { return parse_cookie(read_file_text(path, kMaxFileBytes), path); }

}  // namespace litfog
