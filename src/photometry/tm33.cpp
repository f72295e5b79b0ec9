// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/tm33.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "photometry/photometric_grid.h"
#include "photometry/xml_text.h"

namespace litfog {
namespace {

using Piece = TextScanner::Piece;

bool is_root(std::string_view local_name) {
  return local_name.starts_with("IESTM33") || local_name.starts_with("ATLA_S001") ||
         local_name == "LuminaireOpticalData";
}

/// The element that holds an emitter's intensities.
pugi::xml_node intensities_of(const pugi::xml_node& emitter) {
  const pugi::xml_node data = child_of(emitter, "LuminousData");
  for (const char* name : {"LuminousIntensity", "IntensityDistribution"}) {
    if (const pugi::xml_node inner = child_of(data, name)) return inner;
  }
  return data;
}

/// A remark on the intensities, beside them or beside the element that holds them.
pugi::xml_node remark_of(const pugi::xml_node& data, const char* name) {
  const pugi::xml_node remark = child_of(data, name);
  return remark ? remark : child_of(data.parent(), name);
}

pugi::xml_node the_lit_emitter(const XmlText& xml) {
  pugi::xml_node lit;
  for (const pugi::xml_node& emitter : xml.root().children()) {
    if (local_name(emitter) != "Emitter" || !intensities_of(emitter)) continue;
    if (lit) xml.fail(emitter, "must be the only one with LuminousData");
    lit = emitter;
  }
  if (!lit) xml.fail(xml.root(), "must have an Emitter with LuminousData");
  return lit;
}

/// A, B or C, as in "CIE _ C" and "TypeC".
PhotometryType type_of(const XmlText& xml, const pugi::xml_node& data) {
  const Piece piece = xml.text_of(remark_of(data, "PhotometryType"));
  if (piece.text.empty() || piece.text.ends_with('C')) return PhotometryType::c;
  if (piece.text.ends_with('B')) return PhotometryType::b;
  if (!piece.text.ends_with('A')) xml.scanner().fail(piece, "PhotometryType", "must be type A, B or C");
  return PhotometryType::a;
}

/// The only luminous opening, in millimetres in the file.
LuminousOpening opening_of(const XmlText& xml, const pugi::xml_node& luminaire) {
  const pugi::xml_node opening = child_of(luminaire, "LuminousOpening");
  const auto is_opening = [](const pugi::xml_node& child) { return local_name(child) == "LuminousOpening"; };
  if (std::ranges::count_if(luminaire.children(), is_opening) != 1) return {};
  const auto metres = [&](const char* name) {
    return 1e-3 * TextScanner::number_if_any(xml.text_of(child_of(opening, name))).value_or(0);
  };
  if (const double diameter = metres("Diameter"); diameter > 0) return {-diameter, -diameter, 0};
  return {metres("Width"), metres("Length"), 0};
}

void expect_luminous(const XmlText& xml, const pugi::xml_node& data) {
  const Piece metric = xml.text_of(remark_of(data, "Metric"));
  if (metric.text.empty() || metric.text == "Luminous" || metric.text == "luminous") return;
  xml.scanner().fail(metric, "Metric", "must be Luminous");
}

/// One measured intensity.
struct Entry {
  double horizontal, vertical;  // degrees
  Piece intensity;
};

double angle_of(const XmlText& xml, const pugi::xml_node& element, const char* attribute, double low, double high) {
  const Piece piece = xml.value_of(element, attribute);
  if (piece.text.empty()) xml.scanner().fail(piece, attribute, "");
  const double angle = with_right_angles(xml.scanner().number(piece, attribute));
  if (!(angle >= low && angle <= high)) xml.scanner().fail(piece, attribute, range_rule(low, high));
  return angle;
}

std::vector<Entry> entries_of(const XmlText& xml, const pugi::xml_node& data, const AngleLimits& limits) {
  std::vector<Entry> entries;
  for (const pugi::xml_node& element : data.children()) {
    const bool is_short = local_name(element) == "IntData";
    if (!is_short && local_name(element) != "IntensityData") continue;
    entries.push_back({angle_of(xml, element, is_short ? "h" : "horz", limits.least_horizontal, limits.most_horizontal),
                       angle_of(xml, element, is_short ? "v" : "vert", limits.least_vertical, limits.most_vertical),
                       xml.text_of(element)});
  }
  if (entries.empty()) xml.fail(data, "must have IntData");
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::pair(a.horizontal, a.vertical) < std::pair(b.horizontal, b.vertical);
  });
  return entries;
}

std::vector<double> sorted_angles(const std::vector<Entry>& entries, double Entry::*angle) {
  std::vector<double> angles;
  for (const Entry& entry : entries) angles.push_back(entry.*angle);
  std::ranges::sort(angles);
  angles.erase(std::unique(angles.begin(), angles.end(), is_same_angle), angles.end());
  return angles;
}

/// Fails unless the sorted entries have each pair of the angles once.
void expect_grid(const TextScanner& scanner, const std::vector<Entry>& entries, const std::vector<double>& horizontal,
                 const std::vector<double>& vertical) {
  const auto is_next = [&](std::size_t i) {
    return i < horizontal.size() * vertical.size() && entries[i].horizontal == horizontal[i / vertical.size()] &&
           entries[i].vertical == vertical[i % vertical.size()];
  };
  std::size_t i = 0;
  while (i < entries.size() && is_next(i)) ++i;
  if (i == horizontal.size() * vertical.size() && i == entries.size()) return;
  scanner.fail(entries[std::min(i, entries.size() - 1)].intensity, "intensity",
               "must be given once for each pair of the angles there are");
}

}  // namespace

bool is_tm33(std::string_view text) {
  // Finds the first element. Comments, and declarations that begin with <? or <!, may precede it.
  for (auto at = text.find('<'); at != text.npos; at = text.find('<', at)) {
    text.remove_prefix(at + 1);
    if (text.starts_with("!--")) {
      at = text.find("-->", 3);
    } else if (text.starts_with('?')) {
      at = text.find("?>");
    } else if (text.starts_with('!')) {
      at = 0;
    } else {
      const std::string_view name = text.substr(0, text.find_first_of(" \t\r\n/>"));
      return is_root(name.substr(name.find(':') + 1));  // npos + 1 is 0
    }
    if (at == text.npos) return false;
  }
  return false;
}

Luminaire parse_tm33(std::string text, const std::string& name) {
  const XmlText xml(std::move(text), name);
  const TextScanner& scanner = xml.scanner();
  if (!is_root(local_name(xml.root()))) {
    xml.fail(xml.root(), "must be IESTM33-18, IESTM33-22, ATLA_S001_A or LuminaireOpticalData");
  }
  const pugi::xml_node emitter = the_lit_emitter(xml);
  const pugi::xml_node data = intensities_of(emitter);
  expect_luminous(xml, data);

  Luminaire luminaire;
  luminaire.file = name;
  const pugi::xml_node header = child_of(xml.root(), "Header");
  luminaire.name = xml.text_of(child_of(header, "Description")).text;
  if (luminaire.name.empty()) luminaire.name = xml.text_of(child_of(header, "CatalogNumber")).text;
  luminaire.manufacturer = xml.text_of(child_of(header, "Manufacturer")).text;
  luminaire.is_absolute = xml.text_of(remark_of(data, "AbsolutePhotometry")).text == "true";
  luminaire.opening = opening_of(xml, child_of(xml.root(), "Luminaire"));
  const pugi::xml_node quantity = child_of(emitter, "Quantity");
  const auto lamps = quantity ? TextScanner::number_if_any(xml.text_of(quantity)) : 1;
  const auto lumens = TextScanner::number_if_any(xml.text_of(child_of(emitter, "RatedLumens")));
  if (lamps && lumens) luminaire.lamp_flux = lamp_flux_of(*lamps, *lumens);

  const PhotometryType type = type_of(xml, data);
  const std::vector<Entry> entries = entries_of(xml, data, limits_of(type));
  std::vector<double> horizontal = sorted_angles(entries, &Entry::horizontal);
  const std::vector<double> vertical = sorted_angles(entries, &Entry::vertical);
  expect_grid(scanner, entries, horizontal, vertical);
  const bool is_c = type == PhotometryType::c;
  if (is_c && !is_turn(horizontal)) xml.fail(data, std::string("must have horizontal ") + kTurns);
  if (vertical.size() < 2 || (!is_c && horizontal.size() < 2)) {
    xml.fail(data, "must have two vertical angles or more, and in types A and B two horizontal ones");
  }

  const pugi::xml_node multiplier = remark_of(data, "Multiplier");
  const double factor = multiplier ? scanner.positive(xml.text_of(multiplier), "Multiplier") : 1;
  IntensityReader reader(scanner, entries.size(), factor);
  for (const Entry& entry : entries) reader.add(entry.intensity);
  auto intensity = reader.finish();
  luminaire.peak_location = scanner.location(reader.largest());
  if (is_c && horizontal.back() - horizontal.front() > 180) close_turn(horizontal, intensity);
  luminaire.distribution = distribution_of_degrees(type, std::move(horizontal), vertical, std::move(intensity));
  return luminaire;
}

}  // namespace litfog
