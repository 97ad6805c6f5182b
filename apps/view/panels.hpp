// The panels over the picture, one file each. They show the state and write down what the person wants.
#pragma once

#include "viewer_state.hpp"

namespace glint::view {

void drawViewBar(ViewerState& state);       ///< view_bar.cpp: views, split, camera, time
void drawSettingsPanel(ViewerState& state); ///< settings_panel.cpp
void drawHelpPanel(ViewerState& state);     ///< help_panel.cpp
void drawTimesPanel(ViewerState& state);    ///< times_panel.cpp
void drawPalette(ViewerState& state);       ///< palette.cpp
void drawOpenPanel(ViewerState& state);     ///< open_panel.cpp
void drawRayPanel(ViewerState& state);      ///< ray_panel.cpp
void drawSecondPanel(ViewerState& state);   ///< second_panel.cpp
void drawMessage(ViewerState& state);       ///< view_bar.cpp
void drawShaderError(ViewerState& state);   ///< view_bar.cpp

/// A slider, a box or a list for one setting; a change goes into the model. One edit of a slider is one step to undo.
void drawSetting(ViewerState& state, const SettingInfo& info, float width); ///< setting_control.cpp

/// For ImGui::SetNextWindowPos: a panel goes where it belongs when it is new and when the window's size changes.
int placing(const ViewerState& state);

/// One of ImGui's keys went down, or repeats.
bool keyPressed(int key); ///< palette.cpp

/// "0.50 ms", or "-" for nothing measured.
std::string millisecondsText(double milliseconds);

} // namespace glint::view
