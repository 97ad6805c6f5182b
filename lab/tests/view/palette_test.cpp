// What the command palette shows, as Dear ImGui's text log has it: no window is needed.
#include "lab/view/gui.hpp"
#include "lab/view/panels.hpp"
#include "lab/view/viewer_state.hpp"

#include <gmock/gmock.h>
#include <imgui.h>

namespace glint::view {
namespace palette_test {

using testing::HasSubstr;
using testing::Not;

class PaletteTest : public testing::Test {
protected:
    PaletteTest() { ImGui::GetIO().Fonts->Build(); } // as GuiRenderer does

    /// The texts of the palette in the next frame.
    std::string texts() {
        gui_.begin({}, {1280, 720}, 0.01);
        ImGui::LogToClipboard();
        drawPalette(state_);
        ImGui::LogFinish();
        gui_.end();
        return std::exchange(log_, {});
    }

    std::string log_;
    Gui gui_{1, {[this](const std::string& text) { log_ = text; }, [] { return std::string(); }}};
    ViewerState state_{SettingsModel({}, {})};
};

TEST_F(PaletteTest, ShowsTheFiguresOfTheHelpPanelWithTheirLoads) {
    EXPECT_THAT(texts(), Not(HasSubstr("GPU")));
    state_.showPalette = state_.paletteOpens = true;
    const std::string unmeasured = texts();
    EXPECT_THAT(unmeasured, HasSubstr("GPU Compute - (0 %)"));
    state_.figures = {.computeMs = 1.3, .renderMs = 2, .totalMs = 4.5, .cpuMs = 5, .intervalMs = 10};
    const std::string shown = texts();
    EXPECT_THAT(shown, HasSubstr("GPU Compute 1.30 ms (13 %)"));
    EXPECT_THAT(shown, HasSubstr("Render 2.00 ms (20 %)"));
    EXPECT_THAT(shown, HasSubstr("Total 4.50 ms (45 %)"));
    EXPECT_THAT(shown, HasSubstr("CPU 5.00 ms (50 %)"));
}

} // namespace palette_test
} // namespace glint::view
