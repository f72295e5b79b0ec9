// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace litfog::window {

/// A window on a display with an OpenGL 3.3 context, current on the calling thread, and Dear ImGui in it. One at a
/// time. Hidden until show().
class Window {
 public:
  /// Sets what GLFW takes from the environment, as the locale. Must be called before other threads start.
  static void prepare();
  /// width, height  in the display's units; limited to the display's size
  /// is_size_kept   whether the size that the last window had at its end is taken instead, if there was one
  /// throws         command::MissingCapability if there is no display or no OpenGL 3.3 on it
  Window(const std::string& title, int width, int height, bool is_size_kept);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  static constexpr char kHelp = '?';  ///< F1
  static constexpr char kDelete = 127;

  void show();
  bool is_closed() const;
  /// Waits for an event or wake(), at most for a time in seconds. Does not wait just after an event, because controls
  /// take a few frames to settle.
  void wait(double seconds);
  /// Ends wait(). May be called from any thread.
  static void wake();

  /// The files that have been dropped on the window since the last call.
  std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }

  /// Controls are drawn between begin_frame() and end_frame().
  ///
  /// returns  the keys pressed since the last frame, however shortly: capital letters with Ctrl, small letters without,
  ///          kHelp and kDelete
  std::string begin_frame();
  void end_frame();

 private:
  GLFWwindow* window_;
  int frames_to_settle_ = 0;
  std::string shortcuts_;
  std::vector<std::string> dropped_;
  std::string layout_file_;  // ImGui keeps a pointer to it
};

}  // namespace litfog::window
