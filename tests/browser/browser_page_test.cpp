// SPDX-License-Identifier: Apache-2.0
// The page in Chromium beside the double precision formulas; built where Chromium and Emscripten are installed.

#include <OpenImageIO/color.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>

#include "browser/street.h"
#include "command/temporary_directory.h"
#include "gl/gl_test.h"
#include "litfog/files/light_file.h"
#include "measure/reference_picture.h"
#include "render/display.h"
#include "render/renderer.h"
#include "scene/paint/material_catalogue.h"

namespace litfog::test {
namespace {

using render::FogLighting;

constexpr int kWidth = 160;
constexpr int kHeight = 90;

using Pixels = std::vector<double>;  // RGB as the display gets it, in 1/255; the top row first

/// How the street's pictures are sampled. How textures are filtered is left to drivers.
enum class Textures { filtered, first_texel };

/// The page's scene with its lights and materials.
scene::Scene painted_street(Textures textures) {
  scene::Scene street = browser::make_street();
  for (PlacedLight& placed : street.lights) {
    placed.light = read_light(LITFOG_DATA_DIR "/lights/" + placed.light.name + ".json");
  }
  scene::add_materials(street);
  if (textures == Textures::filtered) return street;
  for (scene::Material& material : street.materials) {
    for (auto* const picture : {&material.albedo, &material.normal}) {
      const std::vector<std::uint8_t>& rgba = (*picture)->rgba;
      *picture = std::make_shared<const scene::Texels>(scene::Texels{1, 1, {rgba.begin(), rgba.begin() + 4}});
    }
  }
  return street;
}

/// Makes the page upload the first texel of each texture alone.
constexpr const char* kFirstTexelScript = R"(
  const upload = WebGL2RenderingContext.prototype.texImage2D;
  WebGL2RenderingContext.prototype.texImage2D = function(target, level, format, width, height, ...rest) {
    upload.call(this, target, level, format, 1, 1, ...rest);
  };
)";

/// How far apart two pictures are, in steps of 1/255, by each pixel's largest channel.
struct Difference {
  double mean;      ///< over all pixels except in lamps' points, which the reference lacks
  double flat_p99;  ///< over pixels like their neighbours: drivers put samples of edges elsewhere
  double flat_fraction;
};

/// Makes the page compile its code at once: Chromium's virtual time, which ends the test, does not wait for the threads
/// that it compiles on otherwise.
constexpr const char* kCompileAtOnceScript = R"(<script>
  WebAssembly.instantiate = async (bytes, imports) => {
    const module = new WebAssembly.Module(bytes);
    return {module, instance: new WebAssembly.Instance(module, imports)};
  };
</script>)";

class BrowserPage : public GlTest {
 protected:
  /// What the formulas make of the street, without the points of its lamps.
  static Pixels reference(const scene::Scene& street, const Fog& fog, FogLighting fog_lighting,
                          const render::Display& display = {}) {
    render::RenderSettings settings;
    settings.fog_lighting = fog_lighting;
    render::Renderer renderer(street, kWidth, kHeight, settings);
    renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
    renderer.set_exposure(display.exposure);
    Pixels pixels;
    for (const float light : render::displayed(measure::shade_reference(renderer).picture, display).rgb) {
      pixels.push_back(255 * double{OIIO::linear_to_sRGB(light)});
    }
    return pixels;
  }

  /// The pictures that the page draws: for a state in its address and, where a script of the test's changes that, for
  /// the next ones. They are taken as soon as they are drawn: a screenshot might be of an earlier frame.
  std::vector<Pixels> shown(const std::string& state, Textures textures, const std::string& script = {}) const {
    std::ifstream page(LITFOG_PAGE);
    std::string html{std::istreambuf_iterator<char>(page), {}};
    html.insert(html.find("<script>"), kCompileAtOnceScript);
    html.insert(html.rfind("</body>"),
                fmt::format(R"(<script>
      {}
      picture.style.cssText = 'position: fixed; left: 0; top: 0; width: {}px; height: {}px';
      const drawn = draw;
      draw = (divisor) => {{
        drawn(divisor);
        if (divisor !== 1) return;
        const copy = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
        copy.drawImage(picture, 0, 0);
        const rgba = copy.getImageData(0, 0, picture.width, picture.height).data;
        const pixels = document.createElement('pre');
        pixels.textContent = Array.from(rgba, (level) => level.toString(16).padStart(2, '0')).join('');
        document.body.append(pixels);
        if (document.getElementsByTagName('pre').length === 1) {{ {} }}
      }};
    </script>)",
                            textures == Textures::first_texel ? kFirstTexelScript : "", kWidth, kHeight, script));
    const std::string folder = directory_.path().string();
    std::ofstream(directory_.path() / "page.html") << html;
    const std::string command = fmt::format(
        "cd {0} && HOME={0} chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader "
        "--user-data-dir={0}/profile --virtual-time-budget=10000 --dump-dom 'file://{0}/page.html#{1}' >dom 2>messages",
        folder, state);
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream stream(directory_.path() / "dom");
    const std::string dom{std::istreambuf_iterator<char>(stream), {}};
    std::vector<Pixels> pictures;
    for (std::size_t at = dom.find("<pre>"); at != dom.npos; at = dom.find("<pre>", at + 1)) {
      pictures.push_back(decoded(std::string_view(dom).substr(at + 5, dom.find('<', at + 1) - at - 5)));
    }
    if (pictures.empty()) ADD_FAILURE() << dom.substr(std::min(dom.find("id=\"note\""), dom.size()), 200);
    return pictures;
  }

  static Difference difference(const scene::Scene& street, const Pixels& page, const Pixels& formulas) {
    double sum = 0;
    std::size_t count = 0;
    std::vector<double> flat;
    for (int y = 1; y < kHeight - 1; ++y) {
      for (int x = 1; x < kWidth - 1; ++x) {
        if (is_at_point(street, {x + 0.5, y + 0.5})) continue;
        double steps = 0;
        bool is_flat = true;
        for (int channel = 0; channel < 3; ++channel) {
          const auto value = [&](int right, int down) { return formulas[index(x + right, y + down, channel)]; };
          steps = std::max(steps, std::abs(page[index(x, y, channel)] - value(0, 0)));
          for (const auto& [right, down] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            is_flat = is_flat && std::abs(value(right, down) - value(0, 0)) < 4;
          }
        }
        sum += steps;
        ++count;
        if (is_flat) flat.push_back(steps);
      }
    }
    std::ranges::sort(flat);
    return {sum / double(count), flat[flat.size() * 99 / 100], double(flat.size()) / double(count)};
  }

 private:
  static std::size_t index(int x, int y, int channel) { return std::size_t((y * kWidth + x) * 3 + channel); }

  /// From two hexadecimal digits a channel, alpha included.
  static Pixels decoded(std::string_view text) {
    Pixels pixels;
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
      int level = 0;
      std::from_chars(&text[i], &text[i] + 2, level, 16);
      if (i % 8 != 6) pixels.push_back(level);
    }
    EXPECT_EQ(pixels.size(), index(0, kHeight, 0));
    pixels.resize(index(0, kHeight, 0));
    return pixels;
  }

  /// The largest point has render::kPointRadius * kMaxGlare * kPointRadii / 2 pixels of a picture 720 high.
  static bool is_at_point(const scene::Scene& street, const glm::dvec2& pixel) {
    const scene::Camera& camera = street.camera;
    const glm::dmat4 clip_from_world =
        glm::perspective(double(camera.field_of_view), double(kWidth) / kHeight, 0.1, 1000.0) *
        glm::lookAt(glm::dvec3(camera.position), glm::dvec3(camera.target), glm::dvec3(0, 1, 0));
    return std::ranges::any_of(street.lights, [&](const PlacedLight& light) {
      const glm::dvec4 clip = clip_from_world * glm::dvec4(light.position, 1);
      const glm::dvec2 at = (glm::dvec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * glm::dvec2(kWidth, kHeight);
      return !light.carried && clip.w > 0 && glm::distance(at, pixel) < 26 * kHeight / 720.0 + 1;
    });
  }

  TemporaryDirectory directory_;
};

/// most  of what is like its neighbours, in steps: half a step is dither's, half a step rounding's
void expect_close(const Difference& difference, double most) {
  fmt::print("mean {:.2f}/255; of {:.0f} % that are like their neighbours, 99 % within {:.2f}/255\n", difference.mean,
             100 * difference.flat_fraction, difference.flat_p99);
  EXPECT_LT(difference.flat_p99, most);
  EXPECT_GT(difference.flat_fraction, 0.4);
}

TEST_F(BrowserPage, AirlightIsThatOfTheFormulasAlsoAfterSlidersAreMoved) {
  const std::vector<Pixels> page = shown("visibility=120", Textures::first_texel, R"(
    const move = (id, fraction) => {
      byId(id).value = fraction;
      byId(id).dispatchEvent(new Event('input'));
    };
    byId('lamps').selectedIndex = 1;
    byId('lamps').dispatchEvent(new Event('change'));
    move('visibility', 0.25);  // 5 m to 50 km: 50 m
    move('quadratic', 5 / 7);  // 1e-6 to 10: 0.1
  )");
  ASSERT_GE(page.size(), 2u);
  scene::Scene street = painted_street(Textures::first_texel);
  expect_close(difference(street, page.front(),
                          reference(street, Fog::from_visibility(FogMode::exp, 120.0), FogLighting::airlight)),
               2);
  for (PlacedLight& placed : street.lights) {
    if (placed.light.name == "street lamp, sodium") placed.light.attenuation.quadratic = 0.1;
  }
  const Pixels moved = reference(street, Fog::from_visibility(FogMode::exp, 50.0), FogLighting::airlight);
  expect_close(difference(street, page.back(), moved), 2);
  EXPECT_GT(difference(street, page.front(), moved).mean, 20);
}

TEST_F(BrowserPage, PeakInExp2FogIsThatOfTheFormulasAlsoAtAnAutomaticExposure) {
  const std::vector<Pixels> page = shown("mode=exp2&visibility=60&contrast=0.01&light=peak&ev=1&tone=clip",
                                         Textures::first_texel, "document.querySelector('[value=auto]').click();");
  ASSERT_GE(page.size(), 2u);
  const scene::Scene street = painted_street(Textures::first_texel);
  const Fog fog = Fog::from_visibility(FogMode::exp2, 60.0, kContrastFlightgear);
  render::Display display{.exposure = {.ev = 1}, .tone = render::ToneCurve::clip};
  expect_close(difference(street, page.front(), reference(street, fog, FogLighting::peak, display)), 2);

  render::RenderSettings settings;
  settings.fog_lighting = FogLighting::peak;
  render::Renderer renderer(street, kWidth, kHeight, settings);
  renderer.set_atmosphere(renderer.scene().atmosphere.with(fog));
  display.exposure = renderer.set_exposure({.is_auto = true});
  fmt::print("automatic exposure {} EV\n", display.exposure.ev);
  EXPECT_GT(std::abs(display.exposure.ev - 1), 0.3);
  expect_close(difference(street, page.back(), reference(street, fog, FogLighting::peak, display)), 3);
}

TEST_F(BrowserPage, TexturesInClearAirAreThoseOfTheFormulasWhateverElseTheAddressSays) {
  // Without fog its visibility cannot be chosen: only then is there a second picture.
  const std::vector<Pixels> page = shown(
      "mode=none&light=peak&lamp0=1,1,1,1,0,1,0.1,0,7,0,0&lamp1=1,1,1,-1,0,1,0.1,0,0,0,0&lamp9=1&ev=x&contrast=2&"
      "visibility=-1&tone=7&camera=1e300,0,0,0,0,0&camera=1&%=%&=",
      Textures::filtered,
      "if (byId('visibility').matches(':disabled')) document.querySelector('[name=tone][value=clip]').click();");
  ASSERT_EQ(page.size(), 2u);
  const scene::Scene street = painted_street(Textures::filtered);
  expect_close(difference(street, page.front(), reference(street, Fog{}, FogLighting::peak)), 8);
}

TEST_F(BrowserPage, LampsHaveNoEndThatALargeExposureShows) {
  const std::vector<Pixels> page =
      shown("visibility=2000&ev=4&tone=clip&lamp1=1.728,0.8638,0.2073,1,0,0.5,0.05,0.15,0,0,0", Textures::first_texel);
  ASSERT_FALSE(page.empty());
  scene::Scene street = painted_street(Textures::first_texel);
  for (PlacedLight& placed : street.lights) {
    if (placed.light.name != "street lamp, sodium") continue;
    placed.light.attenuation.quadratic = 0.5;
    placed.light.cone = {};
  }
  const Fog fog = Fog::from_visibility(FogMode::exp, 2000.0);
  const render::Display display{.exposure = {.ev = 4}, .tone = render::ToneCurve::clip};
  expect_close(difference(street, page.back(), reference(street, fog, FogLighting::airlight, display)), 2);
}

}  // namespace
}  // namespace litfog::test
