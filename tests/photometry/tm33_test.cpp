// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/tm33.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "photometry/photometric_file.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

/// A sound file; each test spoils a part of it.
struct Tm33Text {
  std::string declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- a lamp -->\n";
  std::string root = "IESTM33-22";
  std::string header =
      "<Header><Manufacturer>litfog</Manufacturer><CatalogNumber>L 1</CatalogNumber>"
      "<Description>Spot &amp; flood</Description></Header>\n";
  std::string emitter = "<Quantity>2</Quantity><RatedLumens>500</RatedLumens>\n";
  std::string data = "<Multiplier>2</Multiplier>\n";
  std::string intensities =
      "<IntData h=\"0\" v=\"0\">100</IntData>\n<IntData h=\"90\" v=\"0\">100</IntData>\n"
      "<IntData h=\"0\" v=\"90\"> 1.0D+01 </IntData>\n<IntData h=\"90\" v=\"90\">20</IntData>\n";

  std::string str() const {
    return declaration + "<" + root + "><Version>1.1</Version>\n" + header + "<Emitter>" + emitter +
           "<LuminousData><LuminousIntensity>\n" + data + intensities +
           "</LuminousIntensity></LuminousData></Emitter></" + root + ">\n";
  }
};

Luminaire parsed_tm33(const std::string& text) { return parse_tm33(text, "lamp.xml"); }
std::string tm33_error(const std::string& text) {
  return photometry_error_of([&] { parsed_tm33(text); });
}
std::string tm33_error(std::string Tm33Text::*part, const std::string& text) {
  Tm33Text tm33;
  tm33.*part = text;
  return tm33_error(tm33.str());
}

TEST(Tm33, IntensitiesAreThoseOfTheirAnglesTimesTheMultiplier) {
  const Luminaire luminaire = parsed_tm33(Tm33Text().str());
  EXPECT_EQ(luminaire.name, "Spot & flood");
  EXPECT_EQ(luminaire.manufacturer, "litfog");
  EXPECT_EQ(luminaire.lamp_flux, 1000);
  EXPECT_FALSE(luminaire.is_absolute);
  EXPECT_EQ(luminaire.distribution.type, PhotometryType::c);
  EXPECT_EQ(luminaire.distribution.horizontal, (std::vector<double>{0, pi / 2}));
  EXPECT_EQ(luminaire.distribution.vertical, (std::vector<double>{0, pi / 2}));
  EXPECT_EQ(luminaire.distribution.intensity, (std::vector<double>{200, 20, 200, 40}));
  EXPECT_EQ(to_string(luminaire.peak_location), "lamp.xml:8:22");
}

TEST(Tm33, OnlyOpeningIsReadInMetres) {
  const auto radius_of = [](const std::string& luminaire) {
    Tm33Text tm33;
    tm33.header += "<Luminaire><Dimensions><Length>900</Length><Width>900</Width><Height>9</Height></Dimensions>" +
                   luminaire + "</Luminaire>\n";
    return opening_radius(parsed_tm33(tm33.str()).opening);
  };
  const std::string disc = "<LuminousOpening><Shape>round</Shape><Diameter>200</Diameter></LuminousOpening>";
  EXPECT_DOUBLE_EQ(radius_of(disc), 0.1);
  EXPECT_DOUBLE_EQ(radius_of("<LuminousOpening><Length>1200</Length><Width>300</Width></LuminousOpening>"),
                   std::sqrt(0.36 / pi));
  EXPECT_EQ(radius_of(""), 0) << "the dimensions are those of the housing";
  EXPECT_EQ(radius_of(disc + disc), 0);
  EXPECT_EQ(radius_of("<LuminousOpening><Length>long</Length></LuminousOpening>"), 0);
}

TEST(Tm33, RemarksMayStandBesideTheElementOfTheIntensities) {
  const auto with = [](const std::string& remarks) {
    Tm33Text tm33;
    tm33.data = "";
    std::string text = tm33.str();
    return text.insert(text.find("<LuminousIntensity>"), remarks);
  };
  const Luminaire luminaire = parsed_tm33(with(
      "<PhotometryType>TypeB</PhotometryType><Multiplier>3</Multiplier><AbsolutePhotometry>true</AbsolutePhotometry>"));
  EXPECT_EQ(luminaire.distribution.type, PhotometryType::b);
  EXPECT_EQ(luminaire.distribution.intensity.front(), 300);
  EXPECT_TRUE(luminaire.is_absolute);
  EXPECT_EQ(tm33_error(with("<Metric>Radiant</Metric>")), "6:23: Metric = Radiant: must be Luminous");
}

TEST(Tm33, BothSpellingsOfItsElementsAreRead) {
  std::string other = Tm33Text().str();
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"IntData", "IntensityData"},
                                 {" h=", " horz="},
                                 {" v=", " vert="},
                                 {"<LuminousIntensity>", ""},
                                 {"</LuminousIntensity>", ""},
                                 {"IESTM33-22", "LuminaireOpticalData"}}) {
    for (auto at = other.find(from); at != other.npos; at = other.find(from, at + to.size())) {
      other.replace(at, from.size(), to);
    }
  }
  expect_same_beam(parsed_tm33(other), parsed_tm33(Tm33Text().str()));
}

TEST(Tm33, RatingsThatCannotBeAreNotStated) {
  const auto flux_of = [](const std::string& lamps, const std::string& lumens) {
    Tm33Text tm33;
    tm33.emitter = "<Quantity>" + lamps + "</Quantity><RatedLumens>" + lumens + "</RatedLumens>";
    const Luminaire luminaire = parsed_tm33(tm33.str());
    EXPECT_EQ(luminaire.distribution.intensity, (std::vector<double>{200, 20, 200, 40})) << lamps << " " << lumens;
    return luminaire.lamp_flux;
  };
  EXPECT_EQ(flux_of("3", "500"), 1500);
  for (const char* lumens : {"0", "0.0", "-1", "", " ", "unknown", "nan", "1e999", "-inf"}) {
    EXPECT_FALSE(flux_of("1", lumens)) << lumens;
  }
  for (const char* lamps : {"0", "-1", "4294967295", "1.5", "", "two", "inf"})
    EXPECT_FALSE(flux_of(lamps, "500")) << lamps;
  EXPECT_FALSE(flux_of("1000000", "1e308"));
}

TEST(Tm33, ElementsMayHaveThePrefixOfANamespace) {
  const std::string plain = Tm33Text().str();
  std::string prefixed = plain;
  for (std::size_t at = prefixed.find("<IES"); at != prefixed.npos; at = prefixed.find('<', at + 1)) {
    prefixed.insert(at + (prefixed[at + 1] == '/' ? 2 : 1), "tm:");
  }
  ASSERT_NE(prefixed.find("</tm:IntData>"), prefixed.npos);
  EXPECT_TRUE(is_tm33(prefixed));
  expect_same_beam(parsed_tm33(prefixed), parsed_tm33(plain));
  EXPECT_EQ(parsed_tm33(prefixed).name, "Spot & flood");
  EXPECT_EQ(parsed_tm33(prefixed).lamp_flux, 1000);
  EXPECT_FALSE(is_tm33("<IESTM33-22:html/>"));
}

TEST(Tm33, IntensitiesMayStandInAnIntensityDistribution) {
  std::string text = Tm33Text().str();
  for (auto at = text.find("LuminousIntensity"); at != text.npos; at = text.find("LuminousIntensity")) {
    text.replace(at, std::string("LuminousIntensity").size(), "IntensityDistribution");
  }
  expect_same_beam(parsed_tm33(text), parsed_tm33(Tm33Text().str()));
}

TEST(Tm33, TypesAAndBAreRead) {
  for (const auto& [text, type] : {std::pair{"CIE _ A", PhotometryType::a}, {"TypeB", PhotometryType::b}}) {
    Tm33Text tm33;
    tm33.data =
        std::string("<PhotometryType>") + text + "</PhotometryType><AbsolutePhotometry>true</AbsolutePhotometry>";
    const Luminaire luminaire = parsed_tm33(tm33.str());
    EXPECT_EQ(luminaire.distribution.type, type);
    EXPECT_TRUE(luminaire.is_absolute);
  }
}

TEST(Tm33, EveryRootIsRead) {
  for (const char* root : {"IESTM33-18", "IESTM33-22", "ATLA_S001_A", "LuminaireOpticalData"}) {
    Tm33Text tm33;
    tm33.root = root;
    expect_same_beam(parsed_tm33(tm33.str()), parsed_tm33(Tm33Text().str()));
  }
}

TEST(Tm33, FileIsKnownByItsRoot) {
  EXPECT_TRUE(is_tm33(Tm33Text().str()));
  EXPECT_TRUE(is_tm33("<LuminaireOpticalData version=\"1.0\"/>"));
  EXPECT_TRUE(is_tm33("<ATLA_S001_A>"));
  EXPECT_TRUE(is_tm33("<atla:LuminaireOpticalData xmlns:atla=\"urn:a\"/>"));
  EXPECT_TRUE(is_tm33("<?xml version=\"1.0\" note=\"a < b\"?>\n<!-- <html> --><!DOCTYPE a>\n<IESTM33-22>"));
  EXPECT_FALSE(is_tm33("<!-- <IESTM33-22> --><html/>"));
  EXPECT_FALSE(is_tm33("<!-- <IESTM33-22>"));
  EXPECT_FALSE(is_tm33("<html><body/></html>"));
  EXPECT_FALSE(is_tm33("IESNA91\nTILT=NONE\n"));
  EXPECT_FALSE(is_tm33("<"));
  EXPECT_FALSE(is_tm33(""));
}

TEST(Tm33, BadFileIsAnErrorAtItsLocation) {
  EXPECT_EQ(tm33_error(Tm33Text().str()), "(accepted)");
  EXPECT_EQ(tm33_error(&Tm33Text::root, "html"),
            "3:1: element = html: must be IESTM33-18, IESTM33-22, ATLA_S001_A or LuminaireOpticalData");
  EXPECT_EQ(tm33_error(&Tm33Text::header, "<Header>\n"), "12:48: XML: must be well-formed: Start-end tags mismatch");
  EXPECT_EQ(tm33_error("<IESTM33-22><Emitter/></IESTM33-22>"),
            "1:1: element = IESTM33-22: must have an Emitter with LuminousData");
  EXPECT_EQ(tm33_error(&Tm33Text::header, "<Emitter><LuminousData/></Emitter>"),
            "4:35: element = Emitter: must be the only one with LuminousData");
  EXPECT_EQ(tm33_error(&Tm33Text::data, "<Multiplier>x</Multiplier>"), "7:13: Multiplier = x: must be a finite number");
  EXPECT_EQ(tm33_error(&Tm33Text::data, "<Metric>Radiant</Metric>"), "7:9: Metric = Radiant: must be Luminous");
  EXPECT_EQ(tm33_error(&Tm33Text::data, "<PhotometryType>D</PhotometryType>"),
            "7:17: PhotometryType = D: must be type A, B or C");
  EXPECT_EQ(tm33_error(&Tm33Text::intensities, ""), "6:15: element = LuminousIntensity: must have IntData");
  EXPECT_EQ(tm33_error(Tm33Text().str() + std::string(16'777'216, ' ')),
            " XML: must not be larger than 16777216 bytes");
}

TEST(Tm33, XmlHasOneRootAndEachAttributeOnce) {
  const std::string rule = "XML: must be well-formed: ", lamp = Tm33Text().str();
  EXPECT_EQ(tm33_error("<!-- none -->"), "1:14: " + rule + "No document element found");
  EXPECT_EQ(tm33_error(" lamp " + lamp), "1:2: " + rule + "Text or an element beside the root");
  EXPECT_EQ(tm33_error(lamp + "lamp"), "13:1: " + rule + "Text or an element beside the root");
  EXPECT_EQ(tm33_error(lamp + "<Emitter/>"), "13:1: " + rule + "Text or an element beside the root");
  EXPECT_EQ(tm33_error("<!-- a -->" + lamp + "<!-- b -->\n"), "(accepted)");
  EXPECT_EQ(tm33_error(&Tm33Text::intensities, "<IntData h=\"0\" v=\"0\" v=\"9\">9</IntData>"),
            "8:1: element = IntData: must have one attribute v");
}

TEST(Tm33, TextGoesOnAfterACommentAndEndsAtAnElement) {
  const auto intensity = [](const std::string& text) {
    Tm33Text tm33;
    tm33.data.clear();
    tm33.intensities = "<IntData h=\"0\" v=\"0\">" + text + "</IntData><IntData h=\"0\" v=\"90\">1</IntData>";
    return tm33.str();
  };
  EXPECT_EQ(parsed_tm33(intensity("12<!-- of 15 -->34")).distribution.intensity.front(), 1234);
  EXPECT_EQ(parsed_tm33(intensity("12<![CDATA[34]]>")).distribution.intensity.front(), 1234);
  EXPECT_EQ(tm33_error(intensity("12<b/>34")), "7:22: intensity = 12 34: must be a finite number");
}

TEST(Tm33, LocationOfTextThatEndsWithinACharacterIsThatCharacters) {
  const std::string rule = "XML: must be well-formed: ";
  EXPECT_TRUE(tm33_error("<IESTM33-22><Header>caf\xC3\xA9").starts_with("1:24: " + rule));
  EXPECT_TRUE(tm33_error("<IESTM33-22>\n<Header>\xE2\x82\xAC\xE2\x82\xAC").starts_with("2:10: " + rule));
  EXPECT_TRUE(tm33_error("<IESTM33-22>\n<Header>\xF0\x9F\x92\xA1").starts_with("2:9: " + rule));
}

TEST(Tm33, BadIntensitiesAreAnErrorAtTheirLocation) {
  const auto error = [](const std::string& text) { return tm33_error(&Tm33Text::intensities, text); };
  const std::string nadir = "<IntData h=\"0\" v=\"0\">9</IntData>";
  EXPECT_EQ(error(nadir + "<IntData h=\"0\" v=\"90\">1</IntData>"), "(accepted)");
  EXPECT_EQ(error(nadir + "<IntData h=\"0\" v=\"181\">1</IntData>"), "8:33: v = 181: must be in [0, 180]");
  EXPECT_EQ(error(nadir + "<IntData h=\"x\" v=\"90\">1</IntData>"), "8:33: h = x: must be a finite number");
  EXPECT_EQ(error(nadir + "<IntData v=\"90\">1</IntData>"), "8:33: h: must be given");
  EXPECT_EQ(error(nadir + "<IntData h=\"0\" v=\"90\"></IntData>"), "8:33: intensity 2 of 2: must be given");
  EXPECT_EQ(error(nadir + "<IntData h=\"0\" v=\"90\">-1</IntData>"), "8:55: intensity 2 of 2 = -1: must be >= 0");
  const std::string rule = "must be given once for each pair of the angles there are";
  EXPECT_EQ(error(nadir + "\n<IntData h=\"0\" v=\"0\">1</IntData>"), "9:22: intensity = 1: " + rule);
  EXPECT_EQ(error(nadir + "\n<IntData h=\"90\" v=\"90\">1</IntData>"), "9:24: intensity = 1: " + rule);
  EXPECT_EQ(error(nadir + "\n<IntData h=\"0\" v=\"29\">1</IntData>\n"
                          "<IntData h=\"0\" v=\"29.000000000000004\">1</IntData>"),
            "10:39: intensity = 1: " + rule)
      << "the same in radians";
  EXPECT_EQ(error(nadir),
            "6:15: element = LuminousIntensity: must have two vertical angles or more, and in types A and "
            "B two horizontal ones");
  EXPECT_EQ(error(nadir + "<IntData h=\"0\" v=\"90\">1</IntData><IntData h=\"45\" v=\"0\">1</IntData>"
                          "<IntData h=\"45\" v=\"90\">1</IntData>"),
            "6:15: element = LuminousIntensity: must have horizontal planes at 0, from 0 to 90, 180 or 360, "
            "from 90 to 270, from -90 to 90, or from -180 to 180");
}

}  // namespace
}  // namespace litfog::test
