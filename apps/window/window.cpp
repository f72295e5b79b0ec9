// SPDX-License-Identifier: Apache-2.0
#include "window/window.h"

#include <epoxy/gl.h>
// After epoxy, because it uses epoxy's declarations of OpenGL.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>  // ImGuiSettingsHandler

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>

#include "command/exit_status.h"
#include "window/own_files.h"

namespace litfog::window {
namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";  // fonts-dejavu-core
constexpr float kFontSize = 14;
constexpr int kSettlingFrames = 3;

[[noreturn]] void fail(const std::string& sentence) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw command::MissingCapability(sentence + (reason ? std::string(": ") + reason : ""));
}

/// A size, limited to the display's.
std::pair<int, int> fitted(int width, int height) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (!monitor) return {width, height};
  int left, top, most_width, most_height;
  glfwGetMonitorWorkarea(monitor, &left, &top, &most_width, &most_height);
  return {std::min(width, most_width), std::min(height, most_height)};
}

/// Lets ImGui keep the window's size with its layout, and the window take it from there.
void keep_size(GLFWwindow* window, bool is_taken) {
  using Handler = ImGuiSettingsHandler;
  Handler size;
  size.TypeName = "Display";
  size.TypeHash = ImHashStr(size.TypeName);
  size.UserData = window;
  size.ReadOpenFn = [](ImGuiContext*, Handler* handler, const char*) { return handler->UserData; };
  size.ReadLineFn = [](ImGuiContext*, Handler*, void*, const char*) {};
  if (is_taken) {
    size.ReadLineFn = [](ImGuiContext*, Handler*, void* taker, const char* line) {
      int width, height;
      if (std::sscanf(line, "Size=%d,%d", &width, &height) != 2 || width < 1 || height < 1) return;
      std::tie(width, height) = fitted(width, height);
      glfwSetWindowSize(static_cast<GLFWwindow*>(taker), width, height);
    };
  }
  size.WriteAllFn = [](ImGuiContext*, Handler* handler, ImGuiTextBuffer* text) {
    int width, height;
    glfwGetWindowSize(static_cast<GLFWwindow*>(handler->UserData), &width, &height);
    text->appendf("[%s][window]\nSize=%d,%d\n\n", handler->TypeName, width, height);
  };
  ImGui::GetCurrentContext()->SettingsHandlers.push_back(size);
  glfwSetWindowSizeCallback(window, [](GLFWwindow*, int, int) { ImGui::MarkIniSettingsDirty(); });
}

void set_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.ChildRounding = 0;
  style.FrameRounding = style.GrabRounding = 3;
  style.WindowBorderSize = 0;
  style.WindowPadding = {12, 10};
  style.ItemSpacing = {8, 5};
  style.ScrollbarSize = 11;
  const ImVec4 accent(0.93f, 0.62f, 0.22f, 1);  // sodium light
  const auto faded = [&accent](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
  style.Colors[ImGuiCol_WindowBg] = {0.085f, 0.09f, 0.1f, 1};
  style.Colors[ImGuiCol_FrameBg] = {0.17f, 0.18f, 0.2f, 1};
  style.Colors[ImGuiCol_FrameBgHovered] = {0.23f, 0.24f, 0.27f, 1};
  style.Colors[ImGuiCol_FrameBgActive] = {0.27f, 0.28f, 0.31f, 1};
  style.Colors[ImGuiCol_Button] = {0.21f, 0.22f, 0.25f, 1};
  style.Colors[ImGuiCol_ButtonHovered] = faded(0.45f);
  style.Colors[ImGuiCol_ButtonActive] = faded(0.7f);
  style.Colors[ImGuiCol_SliderGrab] = faded(0.5f);  // because values are written over it
  style.Colors[ImGuiCol_SliderGrabActive] = accent;
  style.Colors[ImGuiCol_CheckMark] = accent;
  style.Colors[ImGuiCol_Header] = faded(0.3f);
  style.Colors[ImGuiCol_HeaderHovered] = faded(0.4f);
  style.Colors[ImGuiCol_HeaderActive] = faded(0.5f);
  style.Colors[ImGuiCol_TitleBgActive] = style.Colors[ImGuiCol_Button];
  style.Colors[ImGuiCol_ResizeGrip] = {};
  style.Colors[ImGuiCol_ResizeGripHovered] = faded(0.45f);
  style.Colors[ImGuiCol_ResizeGripActive] = faded(0.7f);
  style.Colors[ImGuiCol_Separator] = {0.22f, 0.23f, 0.26f, 1};
  style.Colors[ImGuiCol_TextDisabled] = {0.58f, 0.6f, 0.63f, 1};
  style.ScaleAllSizes(scale);
}

}  // namespace

void Window::prepare() { glfwInit(); }

Window::Window(const std::string& title, int width, int height, bool is_size_kept) {
  if (!glfwInit()) fail("a window needs a display");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  std::tie(width, height) = fitted(width, height);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    glfwTerminate();
    fail("a window needs OpenGL 3.3 on its display");
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  layout_file_ = own_file("window.ini").string();
  io.IniFilename = layout_file_.empty() ? nullptr : layout_file_.c_str();
  keep_size(window_, is_size_kept);
  if (io.IniFilename) ImGui::LoadIniSettingsFromDisk(io.IniFilename);
  float scale = 1;
  glfwGetWindowContentScale(window_, &scale, nullptr);
  set_style(scale);
  if (std::filesystem::exists(kFont)) io.Fonts->AddFontFromFileTTF(kFont, kFontSize * scale);
  glfwSetWindowUserPointer(window_, this);
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    std::vector<std::string>& dropped = static_cast<Window*>(glfwGetWindowUserPointer(window))->dropped_;
    dropped.insert(dropped.end(), paths, paths + count);
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
    const bool is_letter = key >= GLFW_KEY_A && key <= GLFW_KEY_Z;
    std::string& shortcuts = static_cast<Window*>(glfwGetWindowUserPointer(window))->shortcuts_;
    if (action != GLFW_PRESS) return;
    if (is_letter && modifiers == GLFW_MOD_CONTROL) shortcuts += char(key);  // GLFW's letters are ASCII's
    if (is_letter && modifiers == 0) shortcuts += char(key - 'A' + 'a');
    if (key == GLFW_KEY_F1) shortcuts += kHelp;
    if (key == GLFW_KEY_DELETE) shortcuts += kDelete;
  });
  ImGui_ImplGlfw_InitForOpenGL(window_, true);  // chains to that callback
  ImGui_ImplOpenGL3_Init("#version 330");
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::show() { glfwShowWindow(window_); }

bool Window::is_closed() const { return glfwWindowShouldClose(window_); }

void Window::wait(double seconds) {
  if (frames_to_settle_ > 0) {
    --frames_to_settle_;
    glfwPollEvents();
    return;
  }
  const double begin = glfwGetTime();
  glfwWaitEventsTimeout(seconds);
  if (glfwGetTime() - begin < seconds) frames_to_settle_ = kSettlingFrames;
}

void Window::wake() { glfwPostEmptyEvent(); }

std::string Window::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  return std::exchange(shortcuts_, {});
}

void Window::end_frame() {
  ImGui::Render();
  int width, height;
  glfwGetFramebufferSize(window_, &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

}  // namespace litfog::window
