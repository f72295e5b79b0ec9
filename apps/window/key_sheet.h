// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::window {

/// What mouse and keys do.
struct KeyMeaning {
  const char* keys;
  const char* meaning;
};

inline constexpr KeyMeaning kKeyMeanings[] = {
    {"drag", "orbits about what is under the mouse, or looks around"},
    {"right drag", "shifts the view"},
    {"wheel", "goes nearer to what is under the mouse"},
    {"W A S D, Q E", "fly, not through walls; with Shift faster"},
    {"click", "picks a lamp"},
    {"Ctrl drag", "moves the picked lamp"},
    {"Del", "removes the picked lamp"},
    {"Ctrl Z, Ctrl Y", "undo and redo changes of lamps"},
    {"Ctrl P", "saves the picture"},
    {"Ctrl C", "copies the litfog-demo command that draws it, and prints it"},
    {"F", "shows levels of light by false colours"},
    {"F1, ?", "show these keys"},
};

}  // namespace litfog::window
