#include "server/trust/certificates.h"

#include <ctime>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"
#include "tests/server/trust/test_certificates.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class CertificatesTest : public testing::Test {
 protected:
  CertificateFiles write(const TestCa::Issued& issued) const {
    const CertificateFiles files{
        folder_.write("c.pem", issued.certificate), folder_.write("k.pem", issued.key), {}};
    std::filesystem::permissions(files.key, std::filesystem::perms(0640));
    return files;
  }

  TestCa ca_{"test"};
  TemporaryFolder folder_;
};

TEST_F(CertificatesTest, AreReadWithTheirEnd) {
  const auto read = read_certificates(write(ca_.issue("server", 30)));
  ASSERT_TRUE(read.is_ok()) << read.status().message();
  EXPECT_NEAR(static_cast<double>(read.value().expires_unix_seconds),
              static_cast<double>(std::time(nullptr) + 30 * 86'400), 300);
}

TEST_F(CertificatesTest, AKeyThatEverybodyReadsIsRefusedWithItsMode) {
  const CertificateFiles files = write(ca_.issue("server"));
  EXPECT_TRUE(read_certificates(files).is_ok());  // its group may read it
  std::filesystem::permissions(files.key, std::filesystem::perms(0644));
  const Status status = read_certificates(files).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("k.pem can be read or written by everybody: its mode is "
                                          "0644"));
}

TEST_F(CertificatesTest, AKeyOfAnotherCertificateIsRefusedByName) {
  TestCa::Issued mixed = ca_.issue("server");
  mixed.key = ca_.issue("other").key;
  EXPECT_THAT(read_certificates(write(mixed)).status().message(),
              HasSubstr("k.pem is not the key of"));
}

TEST_F(CertificatesTest, FilesThatHoldSomethingElseAreNamed) {
  TestCa::Issued issued = ca_.issue("server");
  issued.key = "no key";
  EXPECT_THAT(read_certificates(write(issued)).status().message(), HasSubstr("k.pem"));
  issued.certificate = "nothing";
  EXPECT_THAT(read_certificates(write(issued)).status().message(), HasSubstr("c.pem"));
  CertificateFiles files = write(ca_.issue("server"));
  files.client_ca = folder_ / "absent.pem";
  EXPECT_THAT(read_certificates(files).status().message(), HasSubstr("absent.pem"));
}

}  // namespace
}  // namespace burnish
