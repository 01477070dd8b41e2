// Imports of files: what a client without files does not have.

#include "client/connection/connection.h"
#include "common/bundle/scan_bundle.h"

namespace burnish {

namespace {

class BundleSource final : public ScanSource {
 public:
  explicit BundleSource(const ScanBundle& bundle) : bundle_(bundle) {}

  MeshFormat format() const override { return bundle_.format(); }
  uint64_t size_bytes() const override { return bundle_.bytes().size(); }
  Result<std::string_view> read(uint64_t offset, size_t bytes) override {
    const auto part = bundle_.bytes().subspan(offset, bytes);
    return std::string_view(reinterpret_cast<const char*>(part.data()), part.size());
  }

 private:
  const ScanBundle& bundle_;
};

}  // namespace

Result<ImportOutcome> Connection::import_scan(const ScanBundle& scan, const std::string& name,
                                              const PreparedKey& key, const Progress& progress,
                                              bool exact_name) {
  BundleSource source(scan);
  return import_scan(source, name, key, progress, exact_name);
}

Result<ImportOutcome> Connection::import_scan(const std::filesystem::path& path,
                                              const std::string& name, const PreparedKey& key,
                                              const Progress& progress, bool exact_name) {
  ASSIGN_OR_RETURN(const ScanBundle scan, ScanBundle::open(path));
  return import_scan(scan, name, key, progress, exact_name);
}

}  // namespace burnish
