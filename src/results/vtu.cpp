#include "results/vtu.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "results/vtu_arrays.hpp"

namespace cleave::results {
namespace {

using model::Index;
using model::Shape;

/// VTK cell types (vtkCellType.h) and the order in which VTK wants our nodes.
struct Cell {
  std::uint8_t type;
  int nodes;
  const int* order;
};

/// VTK's wedge has the normal of its first triangle pointing out of the element, ours points in.
constexpr int wedge_order[6] = {0, 2, 1, 3, 5, 4};
constexpr int same_order[10] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};

Cell cell_of(Shape shape, const Index* node) {
  switch (shape) {
    case Shape::hex8:
      // A hexahedron with its upper face drawn to one point is a pyramid.
      if (node[4] == node[5] && node[5] == node[6] && node[6] == node[7]) return {14, 5, same_order};
      return {12, 8, same_order};
    case Shape::penta6:
      return {13, 6, wedge_order};
    case Shape::tet4:
      return {10, 4, same_order};
    case Shape::tet10:
      return {24, 10, same_order};
    case Shape::tri3:
      return {5, 3, same_order};
    case Shape::quad4:
      return {9, 4, same_order};
    case Shape::line2:
      return {3, 2, same_order};
  }
  return {};
}

/// The living elements of one frame and the nodes they use.
class Grid {
 public:
  Grid(const solver::Frame& frame, bool doubles) : frame_(frame), real_{doubles} {
    used_.assign(frame.world.node_count(), -1);
    for (std::size_t b = 0; b < frame.world.blocks.size(); ++b) {
      const discretisation::Block& block = *frame.world.blocks[b];
      alive_.emplace_back(block, frame.state.blocks[b]);
      each_alive(b, [&](std::size_t, const Index* node) {
        const Cell cell = cell_of(block.shape(), node);
        connectivity_count_ += static_cast<std::size_t>(cell.nodes);
        for (int a = 0; a < cell.nodes; ++a) used_[static_cast<std::size_t>(node[a])] = 0;
      });
      cell_count_ += alive_.back().count();
    }
    // Points keep the order of the model's nodes.
    for (std::size_t a = 0; a < used_.size(); ++a)
      if (used_[a] == 0) {
        used_[a] = static_cast<std::int64_t>(points_.size());
        points_.push_back(a);
      }
  }

  std::string write(const std::filesystem::path& path) {
    Arrays arrays;
    const std::string head = describe(arrays);
    WholeFile file(path);
    file.write(head);
    arrays.write(file);
    file.write(vtu_end);
    return file.commit();
  }

 private:
  std::string describe(Arrays& arrays) {
    std::string xml = vtu_head(frame_.state);
    append_format(xml, "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n", points_.size(), cell_count_);
    describe_points(xml, arrays);
    describe_cells(xml, arrays);
    return xml + vtu_appended;
  }

  void describe_points(std::string& xml, Arrays& arrays) {
    const std::vector<double>& reference = frame_.model.mesh.nodes.position;
    const auto& position = frame_.state.position;
    xml += "<PointData Vectors=\"displacement\">\n";
    arrays.add(xml, "Int64", "node_id", 1, 8 * points_.size(), [this](WholeFile& file) {
      for (const std::size_t a : points_) file.write(&frame_.model.mesh.nodes.id[a], 8);
    });
    nodal(xml, arrays, "displacement", [&](std::size_t i) { return position[i] - reference[i]; });
    nodal(xml, arrays, "velocity", [this](std::size_t i) { return frame_.velocity[i]; });
    nodal(xml, arrays, "acceleration", [this](std::size_t i) { return frame_.acceleration[i]; });
    if (frame_.contact) {
      nodal(xml, arrays, "contact_force", [this](std::size_t i) { return frame_.contact_force[i]; });
      const auto contact = std::make_shared<solver::ContactFields>(frame_.contact->contact_fields());
      const auto scalar = [&](const char* name, std::vector<double> solver::ContactFields::*field) {
        arrays.add(xml, real_type(), name, 1, real_bytes() * points_.size(),
                   [this, contact, field](WholeFile& file) {
                     for (const std::size_t a : points_) real(file, ((*contact).*field)[a]);
                   });
      };
      scalar("contact_pressure", &solver::ContactFields::pressure);
      scalar("contact_gap", &solver::ContactFields::gap);
    }
    xml += "</PointData>\n<Points>\n";
    nodal(xml, arrays, "Points", [&](std::size_t i) { return position[i]; });
    xml += "</Points>\n";
  }

  void describe_cells(std::string& xml, Arrays& arrays) {
    xml += "<CellData Scalars=\"effective_plastic_strain\">\n";
    const auto ids = [&](const char* name, auto id_of) {
      arrays.add(xml, "Int64", name, 1, 8 * cell_count_, [this, id_of](WholeFile& file) {
        for (std::size_t b = 0; b < alive_.size(); ++b)
          each_alive(b, [&](std::size_t e, const Index*) {
            const std::int64_t id = id_of(*frame_.world.blocks[b], e);
            file.write(&id, 8);
          });
      });
    };
    ids("part_id", [this](const discretisation::Block& block, std::size_t) {
      return frame_.model.parts[static_cast<std::size_t>(block.part())].id;
    });
    ids("element_id",
        [](const discretisation::Block& block, std::size_t e) { return block.element_ids()[e]; });
    for (const Quantity& quantity : element_quantities(frame_.world)) {
      const std::size_t size = static_cast<std::size_t>(quantity.size);
      arrays.add(xml, real_type(), quantity.name, quantity.size, real_bytes() * size * cell_count_,
                 [this, quantity, size](WholeFile& file) {
                   std::vector<double> values;
                   for (std::size_t b = 0; b < alive_.size(); ++b) {
                     evaluate(quantity, *frame_.world.blocks[b], frame_.state.position,
                              frame_.state.blocks[b], {}, values);
                     each_alive(b, [&](std::size_t e, const Index*) {
                       for (std::size_t k = 0; k < size; ++k) real(file, values[size * e + k]);
                     });
                   }
                 });
    }
    xml += "</CellData>\n<Cells>\n";
    // 32 bits while they suffice: the cells are a third of a file otherwise.
    const bool narrow = connectivity_count_ < std::size_t{1} << 31;
    const char* type = narrow ? "Int32" : "Int64";
    const std::size_t bytes = narrow ? 4 : 8;
    arrays.add(xml, type, "connectivity", 1, bytes * connectivity_count_, [this, bytes](WholeFile& file) {
      each_cell([&](const Cell& cell, const Index* node) {
        for (int a = 0; a < cell.nodes; ++a)
          file.write(&used_[static_cast<std::size_t>(node[cell.order[a]])],
                     bytes);  // little endian: the low half
      });
    });
    arrays.add(xml, type, "offsets", 1, bytes * cell_count_, [this, bytes](WholeFile& file) {
      std::int64_t end = 0;
      each_cell([&](const Cell& cell, const Index*) {
        end += cell.nodes;
        file.write(&end, bytes);
      });
    });
    arrays.add(xml, "UInt8", "types", 1, cell_count_, [this](WholeFile& file) {
      each_cell([&](const Cell& cell, const Index*) { file.write(&cell.type, 1); });
    });
    xml += "</Cells>\n";
  }

  /// A vector per node; value_of takes 3 * node + component.
  template <class ValueOf>
  void nodal(std::string& xml, Arrays& arrays, const char* name, ValueOf value_of) {
    arrays.add(xml, real_type(), name, 3, 3 * real_bytes() * points_.size(),
               [this, value_of](WholeFile& file) {
                 for (const std::size_t a : points_)
                   for (std::size_t k = 0; k < 3; ++k) real(file, value_of(3 * a + k));
               });
  }

  template <class Visit>
  void each_alive(std::size_t b, const Visit& visit) const {
    const discretisation::Block& block = *frame_.world.blocks[b];
    const std::size_t count = block.element_ids().size();
    const std::size_t nodes = static_cast<std::size_t>(model::nodes_of(block.shape()));
    const Index* connectivity = block.connectivity().data();
    for (std::size_t e = 0; e < count; ++e)
      if (alive_[b][e]) visit(e, connectivity + nodes * e);
  }
  template <class Visit>
  void each_cell(const Visit& visit) const {
    for (std::size_t b = 0; b < alive_.size(); ++b)
      each_alive(b, [&](std::size_t, const Index* node) {
        visit(cell_of(frame_.world.blocks[b]->shape(), node), node);
      });
  }

  const char* real_type() const { return real_.type(); }
  std::size_t real_bytes() const { return real_.bytes(); }
  void real(WholeFile& file, double value) const { real_.write(file, value); }

  const solver::Frame& frame_;
  const VtuReal real_;
  std::vector<Alive> alive_;         // of each block
  std::vector<std::int64_t> used_;   // node -> point, -1 for none
  std::vector<std::size_t> points_;  // point -> node
  std::size_t cell_count_ = 0, connectivity_count_ = 0;
};

}  // namespace

std::string write_vtu(const std::filesystem::path& path, const solver::Frame& frame, bool doubles) {
  if (frame.cells) return write_cells(path, frame.cells->cells(), frame.state, doubles);
  return Grid(frame, doubles).write(path);
}

}  // namespace cleave::results
