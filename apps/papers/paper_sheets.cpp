// SPDX-License-Identifier: Apache-2.0
#include "papers/paper_sheets.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "command/progress.h"
#include "command/standard_output.h"
#include "drawing/contact_sheet.h"
#include "drawing/picture_folder.h"
#include "litfog/gl/headless_context.h"
#include "papers/figure.h"

namespace litfog::papers {

void draw_paper_sheets(const std::string& folder, int width, int height, int frames) {
  const std::pair<const char*, Rows (*)(const FigurePainter&)> sheets[] = {{"hales.png", hales_figures},
                                                                           {"lacroix.png", lacroix_figures},
                                                                           {"cg.png", cg_figures},
                                                                           {"frazier.png", frazier_figures}};
  std::vector<std::string> files;
  for (const auto& [file, draw] : sheets) files.emplace_back(file);
  drawing::PictureFolder pictures(folder, files, {});
  const gl::HeadlessContext context;
  const FigurePainter painter(width, height, frames);
  command::Progress progress;
  for (const auto& [file, draw] : sheets) {
    progress.show(fmt::format("drawing {}", file));
    pictures.write(file, drawing::make_contact_sheet(draw(painter)));
    command::report(fmt::format("{}\n", pictures.path_of(file)));
  }
  pictures.finish();
}

}  // namespace litfog::papers
