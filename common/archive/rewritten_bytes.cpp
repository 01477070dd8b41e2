#include "common/archive/rewritten_bytes.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace burnish {

Result<ZipSource> RewrittenBytes::source() {
  zip_error_t error;
  zip_error_init(&error);
  ZipSource source(zip_source_function_create(serve, this, &error));
  const Status status = source ? Status::ok() : zip_status(&error);
  zip_error_fini(&error);
  if (!source) return status;
  return source;
}

zip_int64_t RewrittenBytes::serve(void* self, void* data, zip_uint64_t bytes,
                                  zip_source_cmd_t command) {
  return static_cast<RewrittenBytes*>(self)->answer(data, bytes, command);
}

zip_int64_t RewrittenBytes::answer(void* data, zip_uint64_t bytes, zip_source_cmd_t command) {
  switch (command) {
    case ZIP_SOURCE_OPEN:
      read_place_ = 0;
      return 0;
    case ZIP_SOURCE_READ:
      return read(data, bytes);
    case ZIP_SOURCE_SEEK:
      return seek(read_place_, before_.size(), data, bytes);
    case ZIP_SOURCE_TELL:
      return static_cast<zip_int64_t>(read_place_);
    case ZIP_SOURCE_STAT:
      return tell_size(data, bytes);
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(&error_, data, bytes);
    case ZIP_SOURCE_BEGIN_WRITE:
      return start_writing();
    case ZIP_SOURCE_WRITE:
      return write(data, bytes);
    case ZIP_SOURCE_SEEK_WRITE:
      return seek(write_place_, after_.size(), data, bytes);
    case ZIP_SOURCE_TELL_WRITE:
      return static_cast<zip_int64_t>(write_place_);
    case ZIP_SOURCE_COMMIT_WRITE:
    case ZIP_SOURCE_CLOSE:
    case ZIP_SOURCE_FREE:
      return 0;
    case ZIP_SOURCE_ROLLBACK_WRITE:
    case ZIP_SOURCE_REMOVE:
      after_.clear();
      return 0;
    case ZIP_SOURCE_SUPPORTS:
      return zip_source_make_command_bitmap(
          ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR,
          ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_SUPPORTS,
          ZIP_SOURCE_BEGIN_WRITE, ZIP_SOURCE_COMMIT_WRITE, ZIP_SOURCE_ROLLBACK_WRITE,
          ZIP_SOURCE_WRITE, ZIP_SOURCE_SEEK_WRITE, ZIP_SOURCE_TELL_WRITE, ZIP_SOURCE_REMOVE, -1);
    default:
      zip_error_set(&error_, ZIP_ER_OPNOTSUPP, 0);
      return -1;
  }
}

zip_int64_t RewrittenBytes::tell_size(void* data, zip_uint64_t bytes) {
  if (bytes < sizeof(zip_stat_t)) {
    zip_error_set(&error_, ZIP_ER_INVAL, 0);
    return -1;
  }
  auto* found = static_cast<zip_stat_t*>(data);
  zip_stat_init(found);
  found->size = before_.size();
  found->valid |= ZIP_STAT_SIZE;
  return sizeof(zip_stat_t);
}

zip_int64_t RewrittenBytes::read(void* data, zip_uint64_t bytes) {
  const uint64_t count = std::min<uint64_t>(bytes, before_.size() - read_place_);
  if (count > 0) std::memcpy(data, before_.data() + read_place_, count);
  read_place_ += count;
  return static_cast<zip_int64_t>(count);
}

zip_int64_t RewrittenBytes::seek(uint64_t& place, uint64_t size, void* data, zip_uint64_t bytes) {
  const zip_int64_t sought = zip_source_seek_compute_offset(place, size, data, bytes, &error_);
  if (sought < 0) return -1;
  place = static_cast<uint64_t>(sought);
  return 0;
}

// No exception may pass through libzip.
zip_int64_t RewrittenBytes::start_writing() {
  try {
    after_.clear();
    after_.reserve(before_.size());
  } catch (const std::bad_alloc&) {
    zip_error_set(&error_, ZIP_ER_MEMORY, 0);
    return -1;
  }
  write_place_ = 0;
  return 0;
}

zip_int64_t RewrittenBytes::write(const void* data, zip_uint64_t bytes) {
  try {
    if (bytes > after_.size() - write_place_) after_.resize(write_place_ + bytes);
  } catch (const std::bad_alloc&) {
    zip_error_set(&error_, ZIP_ER_MEMORY, 0);
    return -1;
  }
  if (bytes > 0) std::memcpy(after_.data() + write_place_, data, bytes);
  write_place_ += bytes;
  return static_cast<zip_int64_t>(bytes);
}

}  // namespace burnish
