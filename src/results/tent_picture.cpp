#include "results/tent_picture.hpp"

#include <algorithm>

#include "results/picture.hpp"
#include "results/surface_cells.hpp"
#include "results/vtu.hpp"

namespace cleave::results {

void TentPicture::finish(const solver::Frame& frame, solver::Ending, const discretisation::StepStatus&) {
  const solver::CellFields cells = frame.cells ? frame.cells->tents() : solver::CellFields{};
  if (cells.cell.empty()) {
    problem_ = "there are no tents to draw: it takes spacetime parts on a line or in the plane";
    return;
  }
  problem_ = write_cells(directory_ / "tents.vtu", cells, frame.state, true);

  // Every face of every tetrahedron: points belong to one element each, and the nearest face hides the
  // others.
  const bool flat = cells.dimension == 2;
  const SolidCells group{flat ? model::Shape::tri3 : model::Shape::tet4, cells.cell, {}};
  PictureModel picture{.cells = {&group, 1}, .position = cells.point};
  CellSurface shown;
  if (flat) {
    shown = surface_of(cells);
    picture.surface = &shown.surface;
    std::fill(shown.surface.edges.begin(), shown.surface.edges.end(), std::uint8_t{0b111});
  }
  const auto& order = cells.fields[0].value;
  picture.node_value.assign(order.begin(), order.end());
  PictureOptions look;
  look.title = frame.model.title;
  look.field = "order of the tents";
  look.moment = "the first " + std::to_string(static_cast<long long>(order.back())) + " tents; time upwards";
  look.axes[flat ? 1 : 2] = "t";
  if (flat)
    look.views = {{.eye = {0, 0, 1}, .up = {0, 1, 0}}};
  else
    look.views = {{.eye = {0.45, -0.75, 0.55}}};
  const std::string wrong = write_picture(picture, look, directory_ / "tents.png");
  if (problem_.empty()) problem_ = wrong;
}

}  // namespace cleave::results
