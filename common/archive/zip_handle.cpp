#include "common/archive/zip_handle.h"

namespace burnish {

Status zip_status(zip_error_t* error) {
  const std::string text = zip_error_strerror(error);
  if (zip_error_code_zip(error) == ZIP_ER_MEMORY) return resource_exhausted(text);
  if (zip_error_code_zip(error) == ZIP_ER_CANCELLED) return cancelled("packing was cancelled");
  return invalid_argument("the archive is damaged, or it is not a ZIP archive: " + text);
}

Result<ZipSource> source_of(std::span<const uint8_t> bytes) {
  zip_error_t error;
  zip_error_init(&error);
  ZipSource source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error));
  const Status status = source ? Status::ok() : zip_status(&error);
  zip_error_fini(&error);
  if (!source) return status;
  return source;
}

Result<ZipHandle> open_zip(const ZipSource& source, int flags) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_keep(source.get());  // an archive releases its source
  ZipHandle archive(zip_open_from_source(source.get(), flags, &error));
  const Status status = archive ? Status::ok() : zip_status(&error);
  zip_error_fini(&error);
  if (archive) return archive;
  zip_source_free(source.get());
  return status;
}

}  // namespace burnish
