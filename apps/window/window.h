// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

struct GLFWwindow;

namespace litfog::window {

/// A window on a display with an OpenGL 3.3 context, current on the calling thread, and Dear ImGui in it. One at a
/// time.
class Window {
 public:
  /// width, height  in the display's units; made smaller where the display is
  /// throws         command::MissingCapability where there is no display or no OpenGL 3.3 on it
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool is_closed() const;
  /// Waits for an event or wake(), at most for a time in seconds. Not at all where something has just happened, because
  /// controls take a few frames to settle.
  void wait(double seconds);
  /// Ends wait(); from any thread.
  static void wake();

  /// Between them controls are drawn.
  ///
  /// returns  the letters that have been pressed with Ctrl since the last frame, however shortly
  std::string begin_frame();
  void end_frame();

 private:
  GLFWwindow* window_;
  int frames_to_settle_ = 0;
  std::string shortcuts_;
};

}  // namespace litfog::window
