// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <string_view>
#include <vector>

#include "files/json_document.h"
#include "fuzz/fuzz_target.h"
#include "litfog/files/light_file.h"
#include "litfog/files/light_spec_file.h"
#include "litfog/files/phase_name.h"
#include "litfog/photometry/cookie_file.h"
#include "litfog/photometry/eulumdat.h"
#include "litfog/photometry/gldf.h"
#include "litfog/photometry/ies.h"
#include "litfog/photometry/isocandela.h"
#include "litfog/photometry/tm33.h"
#include "photometry/photometric_file.h"
#include "photometry/zip_file.h"

namespace litfog::test {
namespace {

/// Asks everything of a value and of those within it.
void visit(const files::JsonValue& value) {
  if (value.is_object()) {
    for (const std::string_view name : value.names()) visit(value.member(name));
  } else if (value.is_array()) {
    const auto items = value.items();
    for (const files::JsonValue& item : items) visit(item);
    if (items.size() == 3 && !items[0].is_array() && !items[0].is_object() && !items[0].is_string()) value.vec3();
  } else if (value.is_string()) {
    value.string();
  }
  EXPECT_FALSE(std::string_view(value.error("must be else").what()).empty());
}

void read_json(std::string_view bytes) {
  expect_read_or_refused(bytes, "text", [&] { visit(files::parse_json(std::string(bytes), "text")); });
}

void read_light(std::string_view bytes) {
  const MemoryFile file(bytes);
  expect_read_or_refused(bytes, file.path(), [&] {
    const Light light = litfog::read_light(file.path());
    EXPECT_FALSE(find_error(light));
    const MemoryFile again(format_light(light));  // the same file
    const Light same = litfog::read_light(again.path());
    EXPECT_EQ(same.attenuation, light.attenuation);
    EXPECT_EQ(same.threshold, light.threshold);
    EXPECT_EQ(same.color, light.color);
    EXPECT_EQ(same.name, light.name);
    EXPECT_EQ(same.cone.profile, light.cone.profile);
    EXPECT_EQ(same.flash, light.flash);
  });
}

void read_spec(std::string_view bytes) {
  const MemoryFile file(bytes);
  expect_read_or_refused(bytes, file.path(), [&] {
    const LightSpec spec = read_light_spec(file.path());
    EXPECT_TRUE(spec.range || spec.cone);
    EXPECT_FALSE(std::string_view(spec.error_at("cone.beam_angle", "1", "must be else").what()).empty());
  });
}

void read_cookie(std::string_view bytes) {
  expect_read_or_refused(bytes, "cookie", [&] {
    const Cookie cookie = parse_cookie(bytes, "cookie");
    EXPECT_FALSE(find_error(cookie));
    EXPECT_EQ(parse_cookie(format_cookie(cookie), "again").texels, cookie.texels);
  });
}

std::vector<std::string> cookie_seeds() {
  Cookie cookie;
  cookie.size = 2;
  cookie.texels.assign(24, 0.5f);
  return {format_cookie(cookie)};
}

void read_phase(std::string_view bytes) {
  const auto phase = files::phase_named(bytes);
  EXPECT_FALSE(phase && find_error(*phase));
}

std::vector<std::string> phase_seeds() {
  return {"isotropic", "rayleigh", "hg:0.8", "droplets:10", "draine:0.5,1e+3", "0.7*hg:0.8+0.3*hg:-0.2"};
}

template <Luminaire (*parse)(std::string, const std::string&)>
void read_photometry(std::string_view bytes) {
  expect_read_or_fail(std::string(bytes), [](const std::string& text) { return parse(text, "lamp"); });
}

void read_gldf(std::string_view bytes) {
  const MemoryFile file(bytes);
  expect_read_or_refused(bytes, "", [&] {
    const GldfContainer container(file.path());
    for (const std::string& name : container.files()) {
      expect_read_or_refused(bytes, "", [&] { EXPECT_FALSE(find_error(container.read(name).distribution)); });
    }
  });
}

std::vector<std::string> tm33_seeds() {
  return {R"(<?xml version="1.0" encoding="UTF-8"?>
<IESTM33-22><Version>1.1</Version><Header><Manufacturer>Lämpe €</Manufacturer><CatalogNumber>L 1</CatalogNumber>
<Description>Spot &amp; flood</Description></Header>
<Emitter><Quantity>2</Quantity><RatedLumens>500</RatedLumens><LuminousData><LuminousIntensity>
<Multiplier>2</Multiplier><IntData h="0" v="0">100</IntData><IntData h="90" v="0">100</IntData>
<IntData h="0" v="90">1.0D+01</IntData><IntData h="90" v="90">20</IntData>
</LuminousIntensity></LuminousData></Emitter></IESTM33-22>)"};
}

std::vector<std::string> gldf_seeds() {
  const MemoryFile file("");
  write_zip(file.path(), {{"product.xml",
                           R"(<?xml version="1.0"?>
<Root><GeneralDefinitions><Files><File id="a" contentType="ldc/ies" type="localFileName">a.ies</File>
<File id="b" contentType="ldc/eulumdat" type="localFileName">b.ldt</File></Files></GeneralDefinitions></Root>)"},
                          {"ldc/a.ies", bytes_of(LITFOG_PHOTOMETRY_DIR "/edition_2002.ies")},
                          {"ldc/b.ldt", bytes_of(LITFOG_PHOTOMETRY_DIR "/isym_1.ldt")}});
  return {bytes_of(file.path())};
}

const std::string kData = LITFOG_DATA_DIR;
const AddFuzzTargets kAdd{
    {"json", read_json, {kData + "/scenes", kData + "/specs", kData + "/layers"}},
    {"light", read_light, {kData + "/lights"}},
    {"spec", read_spec, {kData + "/specs"}},
    {"cookie", read_cookie, {}, cookie_seeds},
    {"phase", read_phase, {}, phase_seeds},
    {"isocandela", read_photometry<parse_isocandela>, {LITFOG_PHOTOMETRY_DIR, kData + "/photometry"}},
    {"ies", read_photometry<parse_ies>, {LITFOG_PHOTOMETRY_DIR}},
    {"eulumdat", read_photometry<parse_eulumdat>, {LITFOG_PHOTOMETRY_DIR}},
    {"tm33", read_photometry<parse_tm33>, {}, tm33_seeds},
    {"gldf", read_gldf, {}, gldf_seeds}};

}  // namespace
}  // namespace litfog::test
