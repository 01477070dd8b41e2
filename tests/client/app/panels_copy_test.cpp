#include "client/app/window/panels_copy.h"

#include <imgui.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

class PanelsCopyTest : public testing::Test {
 protected:
  PanelsCopyTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {200, 100};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    for (int i = 0; i < 3; ++i) take("first");  // a window finds its size first
  }
  ~PanelsCopyTest() override { ImGui::DestroyContext(); }

  bool take(const char* text) {
    ImGui::NewFrame();
    ImGui::Begin("panel");
    ImGui::TextUnformatted(text);
    ImGui::End();
    ImGui::Render();
    return panels_.take(*ImGui::GetDrawData());
  }

  PanelsCopy panels_;
};

TEST_F(PanelsCopyTest, TheSamePanelsDoNotDiffer) {
  EXPECT_FALSE(take("first"));
  EXPECT_FALSE(take("first"));
}

TEST_F(PanelsCopyTest, AnotherLetterDiffersOnce) {
  EXPECT_TRUE(take("third"));
  EXPECT_FALSE(take("third"));
}

}  // namespace
}  // namespace burnish
