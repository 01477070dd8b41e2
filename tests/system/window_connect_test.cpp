// The dialogs for another server and for preferences in a real window.

#include <fstream>

#include <gmock/gmock.h>

#include "server/trust/users.h"
#include "tests/server/trust/test_certificates.h"
#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kToken = "anna-secret";

/// A server with TLS that lets in anna alone, besides the plain one of the window.
class SecureWindow : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    server_->folder.write("window.toml", "native_dialogs = false\n");
    const TestCa::Issued issued = ca_.issue("server");
    const auto key = folder_.write("server.key", issued.key);
    std::filesystem::permissions(key, std::filesystem::perms(0600));
    secure_ = std::make_unique<ServerProcess>(std::vector<std::string>{
        "--tls-certificate", folder_.write("server.pem", issued.certificate).string(), "--tls-key",
        key.string(), "--users", folder_.write("users.toml", entry_of_anna()).string()});
    trusted_ = folder_.write("ca.pem", ca_.certificate());
  }

  static std::string entry_of_anna() {
    std::string digest;
    char digits[3];
    for (const unsigned char byte : hash_token(kToken)) {
      std::snprintf(digits, sizeof(digits), "%02x", byte);
      digest += digits;
    }
    return "[[user]]\nname = \"anna\"\nrole = \"editor\"\ntoken_sha256 = \"" + digest + "\"\n";
  }

  void type_into(const std::string& field, const std::string& text) {
    click_on("Connect/" + field);  // chooses all of the field's text
    screen_->type(text);
  }

  void fill_in(const std::string& token) {
    click_on("Start/Another server");
    places_->wait_for("Connect/Host");
    screen_->type("127.0.0.1");  // the first field has the keyboard and is chosen
    type_into("Port", secure_->address.substr(secure_->address.rfind(':') + 1));
    click_on("Connect/Encrypted");
    type_into("Certificate", trusted_.string());
    type_into("Token", token);
  }

  bool dialog_is_open() const { return places_->find("Connect/Connect").has_value(); }

  std::string kept() {
    screen_->close_window();
    EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
    std::ifstream file(server_->folder / "window.toml");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TestCa ca_{"our CA"};
  TemporaryFolder folder_;
  std::filesystem::path trusted_;
  std::unique_ptr<ServerProcess> secure_;
};

TEST_F(SecureWindow, ATokenLetsInOverTlsAndIsForgottenUnlessItIsToBeKept) {
  start_window({"--scale", "1"});
  fill_in(kToken);
  save_screen("connect.png");
  click_on("Connect/Connect");
  EXPECT_TRUE(eventually([this] { return !dialog_is_open(); })) << window_->output();
  const std::string preferences = kept();
  EXPECT_THAT(preferences, HasSubstr(secure_->address));
  EXPECT_THAT(preferences, Not(HasSubstr(kToken)));
}

TEST_F(SecureWindow, ATokenThatIsToBeKeptLetsInAgain) {
  start_window({"--scale", "1"});
  fill_in(kToken);
  click_on("Connect/Keep the token");
  click_on("Connect/Connect");
  ASSERT_TRUE(eventually([this] { return !dialog_is_open(); })) << window_->output();
  EXPECT_THAT(kept(), HasSubstr(kToken));
  start_window({"--scale", "1"});
  click_on("Start/Another server");  // has the server's fields
  click_on("Connect/Connect");
  EXPECT_TRUE(eventually([this] { return !dialog_is_open(); })) << window_->output();
}

TEST_F(SecureWindow, AWrongTokenIsToldInTheDialogAndTheRightOneLetsInThen) {
  start_window({"--scale", "1"});
  fill_in("berta-guess");
  click_on("Connect/Connect");
  places_->wait_for("Connect/Problem");
  save_screen("wrong-token.png");
  EXPECT_TRUE(dialog_is_open());
  type_into("Token", kToken);
  click_on("Connect/Connect");
  EXPECT_TRUE(eventually([this] { return !dialog_is_open(); })) << window_->output();
}

TEST_F(SecureWindow, AClickIntoAFieldThatHasTheKeyboardMovesTheCursor) {
  start_window({"--scale", "1"});
  fill_in(kToken);
  type_into("Host", "27.0.0.1");
  const Box host = places_->wait_for("Connect/Host");
  ASSERT_GT(host.width, 40);  // far from the click before, so they are no double click
  click(host.x + 2, host.y + host.height / 2);
  screen_->type("1");
  click_on("Connect/Connect");
  EXPECT_TRUE(eventually([this] { return !dialog_is_open(); })) << window_->output();
}

class PreferencesWindow : public WindowTest {
 protected:
  void choose(const std::string& list, const std::string& entry) {
    click_on("Preferences/" + list);
    click_on("Preferences/" + entry);
  }
  int panel_brightness() { return screen_->capture().pixel(3, 400)[0]; }
};

TEST_F(PreferencesWindow, ColoursAndSizeCountAtOnceAndAreKept) {
  open_window();
  EXPECT_LT(panel_brightness(), 60);
  const int small = places_->wait_for("Brush/Sharpen").width;
  click_on("Menu/File");
  click_on("Menu/Preferences");
  choose("Colours", "Light");
  EXPECT_TRUE(eventually([this] { return panel_brightness() > 150; }));  // dimmed by the dialog
  choose("Size", "125 %");
  click_on("Preferences/Your name");
  screen_->type("berta");
  save_screen("preferences.png");
  click_on("Preferences/Close");
  EXPECT_TRUE(eventually([&] {
    const auto button = places_->find("Brush/Sharpen");
    return button && button->width > 1.2 * small;
  }));
  EXPECT_TRUE(eventually([this] { return panel_brightness() > 200; }));
  std::ifstream file(server_->folder / "window.toml");
  const std::string kept{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(kept, HasSubstr("light_theme = true"));
  EXPECT_THAT(kept, HasSubstr("scale = 1.25"));
  EXPECT_THAT(kept, HasSubstr("berta"));
}

}  // namespace
}  // namespace burnish
