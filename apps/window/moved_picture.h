// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "measure/triangle_tree.h"
#include "scene/scene.h"

namespace litfog::window {

/// The distance of the sky, metres.
inline constexpr double kFarthestSurface = 1e6;

/// Where the points that a moved camera sees lie in the picture drawn before it moved, so that a window can show that
/// picture, distorted, until the next one is drawn.
class MovedPicture {
 public:
  // Cells of the mesh, within which positions are interpolated.
  static constexpr int kColumns = 48;
  static constexpr int kRows = 27;
  static constexpr double kMargin = 0.25;  ///< of the picture, within which its edge stands for what lay outside

  /// Each vertex shows the point that the camera sees there.
  ///
  /// drawn, drawn_aspect  the picture's camera and width / height
  /// surfaces             null: all points count as at the distance of the camera's target
  MovedPicture(const scene::Camera& drawn, double drawn_aspect, const scene::Camera& camera, double aspect,
               const measure::TriangleTree* surfaces);

  /// A vertex's position in the new view: fractions of its width and height from the top left corner.
  ///
  /// column, row  in [0, kColumns] and [0, kRows]
  static glm::dvec2 place(int column, int row) { return {double(column) / kColumns, double(row) / kRows}; }
  /// Its position in the picture, also in fractions, within [-kMargin, 1 + kMargin]; nothing for what lay farther
  /// outside or behind that camera.
  std::optional<glm::dvec2> source(int column, int row) const {
    return sources_[std::size_t(row * (kColumns + 1) + column)];
  }

 private:
  std::vector<std::optional<glm::dvec2>> sources_;
};

}  // namespace litfog::window
