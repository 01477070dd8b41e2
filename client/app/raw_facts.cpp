#include "client/app/raw_facts.h"

#include "client/app/theme.h"
#include "client/app/words.h"

namespace burnish {

void draw_raw_facts(const RawScan& scan) {
  text_with_ellipsis(scan.file.filename().string(), ImGui::GetContentRegionAvail().x);
  faint_text("%s vertices, %s triangles", counted(scan.vertices).c_str(),
             counted(scan.triangles).c_str());
  faint_text("%s", megabytes(scan.size_bytes).c_str());
  ImGui::Dummy({0, em(0.6f)});
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted("The scan is being prepared. The tools appear here when it is ready.");
  faint_text("Drag turns it, with Shift or the right button moves it, the wheel zooms.");
  ImGui::PopTextWrapPos();
}

}  // namespace burnish
