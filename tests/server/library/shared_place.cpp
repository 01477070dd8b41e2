#include "tests/server/library/shared_place.h"

#include "server/library/scan_record.h"
#include "server/library/shared_bucket.h"
#include "server/library/shared_folder.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/s3/s3_service.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

std::string original_name(const ScanInfo& scan) {
  return "scans/" + scan.id + "/" + original_file_name(scan.format);
}

class PlaceInFolder final : public SharedPlace {
 public:
  std::unique_ptr<OriginalStore> open(const std::string& server) override {
    return SharedFolder::open(folder_.path(), server).value();
  }
  std::string name() const override { return "shared folder"; }
  std::string place() const override { return folder_.path().string(); }
  std::string original(const ScanInfo& scan) const override {
    return content_of(folder_ / original_name(scan));
  }
  std::string info(const ScanInfo& scan) const override {
    return content_of(folder_ / ("scans/" + scan.id + "/info.json"));
  }
  void put_original(const ScanInfo& scan, const std::string& content) override {
    fs::create_directories(folder_ / ("scans/" + scan.id));
    folder_.write(original_name(scan), content);
  }
  void clear() override {
    for (const auto& scan : fs::directory_iterator(folder_ / "scans")) fs::remove_all(scan);
  }
  size_t file_count() const override { return files_below("scans"); }
  size_t unfinished() const override { return files_below("staging"); }

 private:
  size_t files_below(const std::string& name) const {
    size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / name))
      count += entry.is_regular_file() ? 1 : 0;
    return count;
  }

  const TemporaryFolder folder_;
};

class PlaceInBucket final : public SharedPlace {
 public:
  std::unique_ptr<OriginalStore> open(const std::string&) override {
    return SharedBucket::open(service_.address(), S3Service::credentials, short_patience()).value();
  }
  std::string name() const override { return "bucket"; }
  std::string place() const override { return "s3://"; }
  std::string original(const ScanInfo& scan) const override { return get(original_name(scan)); }
  std::string info(const ScanInfo& scan) const override {
    return get("scans/" + scan.id + "/info.json");
  }
  void put_original(const ScanInfo& scan, const std::string& content) override {
    EXPECT_TRUE(bucket_.put(original_name(scan), content).is_ok());
  }
  void clear() override { EXPECT_TRUE(bucket_.remove_all("").is_ok()); }
  size_t file_count() const override { return listed("list-type=2", "Key"); }
  size_t unfinished() const override { return listed("uploads=", "UploadId"); }

 private:
  std::string get(const std::string& name) const {
    std::string all;
    const auto take = [&](std::string_view piece) {
      all += piece;
      return Status::ok();
    };
    return bucket_.get(name, 1 << 30, take, {}).is_ok() ? all : "";
  }
  size_t listed(const std::string& query, const std::string& element) const {
    S3Request list{"GET", ""};
    list.query = query;
    return xml_texts(bucket_.send_quickly(list)->body, element).size();
  }

  const S3Service service_;
  const S3Bucket bucket_ = service_.bucket(short_patience());
};

}  // namespace

std::unique_ptr<SharedPlace> make_shared_place(const std::string& store) {
  if (store == "Bucket") return std::make_unique<PlaceInBucket>();
  return std::make_unique<PlaceInFolder>();
}

std::string missing_for(const std::string& store) {
  return store == "Bucket" && !S3Service::is_installed() ? S3Service::kMissing : "";
}

}  // namespace burnish
