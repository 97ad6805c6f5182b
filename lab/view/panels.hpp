// The panels over the picture, one file each. They show the state and store the user's requests in it.
#pragma once

#include "lab/view/viewer_state.hpp"

namespace glint::view {

void drawViewBar(ViewerState& state);        ///< view_bar.cpp: views, split, camera, time
void drawSettingsPanel(ViewerState& state);  ///< settings_panel.cpp
void drawMaterialsPanel(ViewerState& state); ///< materials_panel.cpp
void drawHelpPanel(ViewerState& state);      ///< help_panel.cpp
void drawTimesPanel(ViewerState& state);     ///< times_panel.cpp
void drawPalette(ViewerState& state);        ///< palette.cpp
void drawOpenPanel(ViewerState& state);      ///< open_panel.cpp
void drawRayPanel(ViewerState& state);       ///< ray_panel.cpp
void drawSecondPanel(ViewerState& state);    ///< second_panel.cpp
void drawMessage(ViewerState& state);        ///< view_bar.cpp
void drawShaderError(ViewerState& state);    ///< view_bar.cpp

/// Draws a slider, a check box or a list for one setting; a change is made in the model. One drag of a slider is one
/// undo step.
void drawSetting(ViewerState& state, const SettingInfo& info, float width); ///< setting_control.cpp

/// For ImGui::SetNextWindowPos: a panel is placed when it is new and when the window's size changes.
int placing(const ViewerState& state);

/// True if this ImGui key was pressed or repeats.
bool keyPressed(int key); ///< palette.cpp

/// "0.50 ms", or "-" without a measurement.
std::string millisecondsText(double milliseconds);

} // namespace glint::view
