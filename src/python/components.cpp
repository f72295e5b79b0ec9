// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "files/bundled_name.h"
#include "litfog/files/light_file.h"
#include "litfog/files/output_error.h"
#include "litfog/fit/attenuation_fit.h"
#include "litfog/fit/cone_fit.h"
#include "litfog/input_error.h"
#include "litfog/photometry/axial_beam.h"
#include "litfog/photometry/gldf.h"
#include "litfog/photometry/intensity_distribution.h"
#include "litfog/photometry/luminaire.h"
#include "model/require.h"
#include "python/errors.h"
#include "python/module.h"
#include "python/numbers.h"

namespace litfog::python {
namespace {

using Path = std::filesystem::path;
using Released = py::call_guard<py::gil_scoped_release>;

void bind_errors(py::module_& m) {
  const py::exception<InputError> input_error(m, "InputError", PyExc_ValueError);
  const py::exception<OutputError> output_error(m, "OutputError", PyExc_OSError);
  input_error.attr("__doc__") =
      "A file that cannot be used. str() is the whole sentence:\n"
      "\"lamps.json:7:12: threshold = 7: must be in (0, 1)\".\n"
      "Attributes: file, the path as given; line and column, from 1; 0 where the error is of the whole.";
  output_error.attr("__doc__") = "Output that could not be written; str() is the whole sentence.";
  translate_errors(input_error, output_error);
}

/// The source of figures: a line or several.
using Source = std::variant<std::string, std::vector<std::string>>;

std::vector<std::string> lines_of(const Source& source) {
  const auto* line = std::get_if<std::string>(&source);
  return line ? std::vector{*line} : std::get<std::vector<std::string>>(source);
}

Path light_path(const Path& given) {
  return files::file_or_bundled(given, py::module_::import("litfog").attr("data_dir").cast<Path>() / "lights");
}

void bind_files(py::module_& m) {
  m.def(
      "read_light",
      [](const Path& path) {
        const Path found = light_path(path);
        const py::gil_scoped_release released;
        return read_light(found.string());
      },
      py::arg("path"),
      "Reads a light file, or by its bare name a light of data_dir / \"lights\". InputError with file, line and\n"
      "column of what is wrong.");
  m.def(
      "write_light",
      [](const Path& path, const Light& light, const Source& source) {
        write_light(path.string(), light, lines_of(source));
      },
      py::arg("path"), py::arg("light"), py::arg("source") = std::vector<std::string>(),
      "Writes a light file atomically. source: a line, or lines, saying where the figures are from. OutputError.");
  m.def(
      "format_light", [](const Light& light, const Source& source) { return format_light(light, lines_of(source)); },
      py::arg("light"), py::arg("source") = std::vector<std::string>(), "A light as the text of its file.");
}

py::dtype axial_sample_dtype() { return make_dtype({{"angle", "f8", 1}, {"mean", "f8", 1}, {"deviation", "f8", 1}}); }

/// A measured table of a distribution, kept alive by the array.
template <std::vector<double> IntensityDistribution::*kTable>
py::array table(const py::object& self) {
  const std::vector<double>& values = self.cast<const IntensityDistribution&>().*kTable;
  return view(py::dtype::of<double>(), {py::ssize_t(values.size())}, values.data(), self);
}

void bind_photometry(py::module_& m) {
  py::enum_<PhotometryType>(m, "PhotometryType", "How a goniophotometer turned the luminaire (IES LM-63).")
      .value("a", PhotometryType::a, "half planes round the vertical axis")
      .value("b", PhotometryType::b, "half planes round the horizontal axis")
      .value("c", PhotometryType::c, "half planes round the photometric axis");
  m.attr("PHOTOMETRIC_AXIS") = kPhotometricAxis;
  m.attr("AXIAL_SAMPLE") = axial_sample_dtype();
  py::class_<IntensityDistribution>(
      m, "IntensityDistribution",
      "Luminous intensity by direction, as measured. Tables are read-only arrays where they lie.")
      .def_readonly("type", &IntensityDistribution::type, "PhotometryType")
      .def_property_readonly("horizontal", &table<&IntensityDistribution::horizontal>, "radians, strictly increasing")
      .def_property_readonly("vertical", &table<&IntensityDistribution::vertical>, "radians, strictly increasing")
      .def_property_readonly(
          "intensity",
          [](const py::object& self) {
            const auto& distribution = self.cast<const IntensityDistribution&>();
            return view(py::dtype::of<double>(),
                        {py::ssize_t(distribution.horizontal.size()), py::ssize_t(distribution.vertical.size())},
                        distribution.intensity.data(), self);
          },
          "candela, by horizontal and vertical angle")
      .def("__repr__", [](const py::object& self) {
        return "<litfog.IntensityDistribution: type=litfog." + str_of(self.attr("type")) + ", " +
               str_of(self.attr("horizontal").attr("size")) + " horizontal and " +
               str_of(self.attr("vertical").attr("size")) + " vertical angles>";
      });
  py::class_<IntensityPeak>(m, "IntensityPeak", "The largest intensity, always at measured angles.")
      .def_readonly("intensity", &IntensityPeak::intensity, "candela, > 0")
      .def_readonly("direction", &IntensityPeak::direction, "unit; the photometric axis is (0, 0, -1)");
  show_fields(m.attr("IntensityPeak"), {"intensity", "direction"});
  py::class_<Luminaire>(m, "Luminaire", "What a photometric file states about a luminaire.")
      .def_readonly("name", &Luminaire::name, "empty if the file does not state it")
      .def_readonly("manufacturer", &Luminaire::manufacturer, "likewise")
      .def_readonly("distribution", &Luminaire::distribution, "IntensityDistribution")
      .def_readonly("lamp_flux", &Luminaire::lamp_flux, "rated flux of all its lamps in lumens, or None")
      .def_readonly("light_output_ratio", &Luminaire::light_output_ratio,
                    "stated fraction of the lamps' flux that leaves the luminaire, or None")
      .def_readonly("is_absolute", &Luminaire::is_absolute, "measured as a whole");
  show_fields(m.attr("Luminaire"), {"name", "manufacturer", "lamp_flux", "light_output_ratio", "is_absolute"});
  m.def(
      "read_luminaire", [](const Path& path) { return read_luminaire(path.string()); }, py::arg("path"), Released(),
      "Reads a photometric file of any kind that its content says: IES LM-63, EULUMDAT, TM-33, an isocandela table,\n"
      "or a GLDF container with one photometric file. InputError. Releases the GIL.");
  m.def(
      "list_gldf", [](const Path& path) { return list_gldf(path.string()); }, py::arg("path"), Released(),
      "The photometric files in a GLDF container, as paths that read_luminaire takes. InputError.");
  py::class_<GldfContainer>(m, "GldfContainer",
                            "A GLDF container whose directory is read once: for reading all of its photometric files.")
      .def(py::init([](const Path& path) { return GldfContainer(path.string()); }), py::arg("path"), Released())
      .def_property_readonly("files", &GldfContainer::files, "as list_gldf gives them")
      .def("read", &GldfContainer::read, py::arg("file"), Released(), "Reads one of its files. InputError.");
  show_fields(m.attr("GldfContainer"), {"files"});
  m.def("stated_flux", &stated_flux, py::arg("luminaire"),
        "The luminaire's flux in lumens as its file states it, or None.");
  m.def("luminous_flux", &luminous_flux, py::arg("distribution"), Released(),
        "Luminous flux in lumens: the intensity as interpolated, integrated over the sphere in closed form.");
  m.def("find_peak", &find_peak, py::arg("distribution"),
        "The largest intensity; of several equal peaks one closest to the photometric axis.");
  m.def(
      "axial_profile",
      [](const IntensityDistribution& distribution, const glm::dvec3& axis) {
        std::vector<AxialSample> profile;
        {
          const py::gil_scoped_release released;
          profile = AxialBeam(distribution, axis).profile();
        }
        const auto count = py::ssize_t(profile.size());
        return own(std::move(profile), axial_sample_dtype(), {count});
      },
      py::arg("distribution"), py::arg("axis") = kPhotometricAxis,
      "Intensity against the angle from an axis, as the mean over each circle, and its largest deviation: an array of\n"
      "dtype AXIAL_SAMPLE by increasing angles from 0 to pi. Releases the GIL.");
  m.def(
      "asymmetry",
      [](const IntensityDistribution& distribution, const glm::dvec3& axis) {
        return AxialBeam(distribution, axis).asymmetry();
      },
      py::arg("distribution"), py::arg("axis") = kPhotometricAxis, Released(),
      "How far a beam is from rotational symmetry about an axis: relative rms, 0 to 1, to 0.001. Releases the GIL.");
}

/// An argument that holds samples, or None.
struct Column {
  const char* name;
  const py::object& numbers;
};

/// Columns of samples; without weights each weighs 1.
template <typename Sample>
std::vector<Sample> samples_of(const Column& first, const Column& second, const Column& weights) {
  if (first.numbers.is_none() && second.numbers.is_none() && weights.numbers.is_none()) return {};
  std::vector<Numbers<double>> columns;
  for (const Column& column : {first, second, weights}) {
    if (!column.numbers.is_none()) columns.push_back(take_numbers(column.numbers, column.name));
  }
  const auto is_like_first = [&](const auto& column) {
    return column.ndim() <= 1 && column.size() == columns[0].size();
  };
  const bool has_both = !first.numbers.is_none() && !second.numbers.is_none();
  if (!has_both || !std::ranges::all_of(columns, is_like_first)) {
    throw py::value_error(std::string(first.name) + ", " + second.name + " and " + weights.name +
                          ": must be one-dimensional and of one length");
  }
  std::vector<Sample> samples;
  for (py::ssize_t i = 0; i < columns[0].size(); ++i) {
    samples.push_back({columns[0].data()[i], columns[1].data()[i], columns.size() > 2 ? columns[2].data()[i] : 1});
  }
  return samples;
}

template <std::size_t kSize>
using Matrix = std::array<std::array<double, kSize>, kSize>;

/// A covariance as an array, or None.
template <std::size_t kSize, typename Values>
py::object array_of(const std::optional<Values>& values) {
  static_assert(sizeof(Values) == sizeof(Matrix<kSize>));
  if (!values) return py::none();
  return py::array_t<double>({kSize, kSize}, reinterpret_cast<const double*>(values->data()));
}

void bind_attenuation_fit(py::module_& m) {
  py::enum_<AttenuationFamily>(m, "AttenuationFamily", "Which attenuation meets an extent, if there are no samples.")
      .value("quadratic", AttenuationFamily::quadratic, "no linear term")
      .value("linear", AttenuationFamily::linear, "no quadratic term")
      .value("mixed", AttenuationFamily::mixed, "both alike at the extent");
  py::enum_<AttenuationFitStatus>(m, "AttenuationFitStatus", "How a fit of an attenuation ended.")
      .value("optimal", AttenuationFitStatus::optimal, "no attenuation has a smaller objective by more than 1e-7 of it")
      .value("unproven", AttenuationFitStatus::unproven, "the best found")
      .value("infeasible", AttenuationFitStatus::infeasible, "the best fit to a target that no attenuation meets");
  py::class_<AttenuationFit> fit(m, "AttenuationFit", "A fit and how good it is.");
  fit.def(py::init([](const Attenuation& attenuation, double threshold, AttenuationFitStatus status,
                      std::string sentence, double objective, double rms_error, double largest_error,
                      std::vector<double> residuals, const std::optional<Matrix<3>>& covariance, double kkt_residual) {
       AttenuationFit made{.attenuation = attenuation,
                           .threshold = threshold,
                           .status = status,
                           .sentence = std::move(sentence),
                           .objective = objective,
                           .rms_error = rms_error,
                           .largest_error = largest_error,
                           .residuals = std::move(residuals),
                           .kkt_residual = kkt_residual};
       if (covariance) made.covariance = std::bit_cast<std::array<double, 9>>(*covariance);
       return made;
     }))
      .def_readonly("attenuation", &AttenuationFit::attenuation, "Attenuation")
      .def_readonly("threshold", &AttenuationFit::threshold, "attenuation at the extent")
      .def_readonly("status", &AttenuationFit::status, "AttenuationFitStatus")
      .def_readonly("sentence", &AttenuationFit::sentence, "the outcome in words")
      .def_readonly("objective", &AttenuationFit::objective, "sum of weight * residual^2")
      .def_readonly("rms_error", &AttenuationFit::rms_error, "root of the weighted mean of error^2")
      .def_readonly("largest_error", &AttenuationFit::largest_error, "signed; 0.01 is 1 % too bright")
      .def_property_readonly(
          "residuals",
          [](const py::object& self) {
            const auto& residuals = self.cast<const AttenuationFit&>().residuals;
            return view(py::dtype::of<double>(), {py::ssize_t(residuals.size())}, residuals.data(), self);
          },
          "ln a(range) - ln attenuation of each sample, a read-only array")
      .def_property_readonly(
          "covariance", [](const AttenuationFit& self) { return array_of<3>(self.covariance); },
          "of constant, linear, quadratic, 3 x 3; None where the samples do not identify them")
      .def_readonly("kkt_residual", &AttenuationFit::kkt_residual, "largest violation of the conditions of optimality");
  show_fields(fit, {"attenuation", "threshold", "status", "rms_error", "largest_error"});
  make_picklable(fit, {"attenuation", "threshold", "status", "sentence", "objective", "rms_error", "largest_error",
                       "residuals", "covariance", "kkt_residual"});
  m.def(
      "fit_attenuation",
      [](std::optional<double> extent, std::optional<double> constant, const py::object& ranges,
         const py::object& attenuations, const py::object& weights, double threshold, AttenuationFamily family,
         bool is_robust) {
        AttenuationTarget target{.threshold = threshold, .extent = extent, .constant = constant};
        target.samples =
            samples_of<AttenuationSample>({"ranges", ranges}, {"attenuations", attenuations}, {"weights", weights});
        target.family = family;
        target.is_robust = is_robust;
        const py::gil_scoped_release released;
        return fit_attenuation(target);
      },
      py::kw_only(), py::arg("extent") = py::none(), py::arg("constant") = py::none(), py::arg("ranges") = py::none(),
      py::arg("attenuations") = py::none(), py::arg("weights") = py::none(), py::arg("threshold") = kDefaultThreshold,
      py::arg("family") = AttenuationFamily::quadratic, py::arg("is_robust") = false,
      "Fits an attenuation to an extent in metres, to samples, or to both: the global minimum of\n"
      "sum w (ln a(r) - ln attenuation)^2 that meets the extent exactly. Samples are columns: ranges in metres,\n"
      "attenuations, and weights (1 where absent); is_robust is for tables with outliers. Releases the GIL.\n"
      "ValueError with field, value and rule.");
}

void bind_cone_fit(py::module_& m) {
  py::enum_<ConeFitStatus>(m, "ConeFitStatus", "How a fit of a cone ended.")
      .value("optimal", ConeFitStatus::optimal, "no cone has an objective smaller by more than 0.1 %")
      .value("unproven", ConeFitStatus::unproven, "the best found");
  py::class_<ConeProfileFit> profile_fit(m, "ConeProfileFit",
                                         "A fitted profile, how good it is, and how that is known.");
  profile_fit
      .def(py::init([](const Cone& cone, ConeFitStatus status, double objective, double lower_bound, double rms,
                       double largest_error, std::optional<double> flux_error, std::optional<double> beam_angle_error,
                       std::optional<double> field_angle_error, const std::optional<Matrix<2>>& covariance) {
        return ConeProfileFit{.cone = cone,
                              .objective = objective,
                              .lower_bound = lower_bound,
                              .rms = rms,
                              .largest_error = largest_error,
                              .flux_error = flux_error,
                              .beam_angle_error = beam_angle_error,
                              .field_angle_error = field_angle_error,
                              .covariance = covariance,
                              .status = status};
      }))
      .def_readonly("cone", &ConeProfileFit::cone, "Cone")
      .def_readonly("status", &ConeProfileFit::status, "ConeFitStatus")
      .def_readonly("objective", &ConeProfileFit::objective, "sum of weight * (cone - I / I_max)^2")
      .def_readonly("lower_bound", &ConeProfileFit::lower_bound, "no cone of this profile has a smaller objective")
      .def_readonly("rms", &ConeProfileFit::rms, "sqrt(objective / sum of weights)")
      .def_readonly("largest_error", &ConeProfileFit::largest_error, "cone - I / I_max, signed")
      .def_readonly("flux_error", &ConeProfileFit::flux_error, "flux of the cone / of the samples - 1, or None")
      .def_readonly("beam_angle_error", &ConeProfileFit::beam_angle_error, "relative, or None")
      .def_readonly("field_angle_error", &ConeProfileFit::field_angle_error, "relative, or None")
      .def_property_readonly(
          "covariance", [](const ConeProfileFit& self) { return array_of<2>(self.covariance); },
          "of the parameters that the fit determines, 2 x 2; None where the samples do not identify them");
  show_fields(profile_fit, {"cone", "status", "rms", "largest_error", "flux_error"});
  make_picklable(profile_fit, {"cone", "status", "objective", "lower_bound", "rms", "largest_error", "flux_error",
                               "beam_angle_error", "field_angle_error", "covariance"});
  py::class_<ConeFit> fit(m, "ConeFit", "The fits of one or all profiles, and which is best.");
  fit.def(py::init([](std::vector<ConeProfileFit> profiles, std::size_t best_index) {
       if (best_index >= profiles.size()) throw py::value_error("best_index: must be that of a profile");
       return ConeFit{.profiles = std::move(profiles), .best_index = best_index};
     }))
      .def_readonly("profiles", &ConeFit::profiles, "a ConeProfileFit of each")
      .def_readonly("best_index", &ConeFit::best_index, "of the best of them")
      .def_property_readonly("best", &ConeFit::best, "its ConeProfileFit");
  show_fields(fit, {"profiles", "best_index"});
  make_picklable(fit, {"profiles", "best_index"});
  m.def(
      "fit_cone",
      [](std::optional<ConeProfile> profile, std::optional<double> half_angle, std::optional<double> beam_angle,
         std::optional<double> field_angle, const py::object& angles, const py::object& intensities,
         const py::object& weights) {
        ConeTarget target{profile, half_angle, beam_angle, field_angle};
        target.samples = samples_of<ConeSample>({"angles", angles}, {"intensities", intensities}, {"weights", weights});
        const py::gil_scoped_release released;
        return fit_cone(target);
      },
      py::kw_only(), py::arg("profile") = py::none(), py::arg("half_angle") = py::none(),
      py::arg("beam_angle") = py::none(), py::arg("field_angle") = py::none(), py::arg("angles") = py::none(),
      py::arg("intensities") = py::none(), py::arg("weights") = py::none(),
      "Fits a cone to samples, to beam and field angles (full, in radians), or to all of these: the global minimum of\n"
      "sum of weight * (cone - I / I_max)^2 of the profile, of each if there is none. Samples are columns: angles "
      "from\n"
      "the axis in radians, intensities in any unit, and weights (1 where absent). Releases the GIL. ValueError with\n"
      "field, value and rule.");
}

}  // namespace

void bind_components(py::module_& m) {
  bind_errors(m);
  bind_files(m);
  bind_photometry(m);
  bind_attenuation_fit(m);
  bind_cone_fit(m);
}

}  // namespace litfog::python
