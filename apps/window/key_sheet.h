// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::window {

/// A mouse or keyboard action.
struct KeyMeaning {
  const char* keys;
  const char* meaning;
};

inline constexpr KeyMeaning kKeyMeanings[] = {
    {"drag", "orbits about the point under the mouse, or looks around"},
    {"right drag", "shifts the view"},
    {"wheel", "approaches the point under the mouse"},
    {"W A S D, Q E", "fly, with Shift faster; walls stop you"},
    {"click", "picks a lamp"},
    {"Ctrl drag", "moves the picked lamp"},
    {"Del", "removes the picked lamp"},
    {"Ctrl Z, Ctrl Y", "undo and redo changes of lamps"},
    {"Ctrl P", "saves the picture"},
    {"Ctrl C", "copies and prints the litfog-demo command that draws it"},
    {"F", "shows light levels in false colours"},
    {"F1, ?", "show these keys"},
};

}  // namespace litfog::window
