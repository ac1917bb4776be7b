#include "results/vtu.hpp"
#include "results/vtu_arrays.hpp"

namespace cleave::results {

std::string write_cells(const std::filesystem::path& path, const solver::CellFields& cells,
                        const discretisation::State& state, bool doubles) {
  const VtuReal real{doubles};
  const std::size_t points = cells.point.size() / 3, count = cells.element.size();
  const auto corners = static_cast<std::size_t>(cells.dimension + 1);
  std::string xml = vtu_head(state);
  append_format(xml, "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n", points, count);

  Arrays arrays;
  const auto reals = [&](const std::string& name, int size, const std::vector<double>& values) {
    arrays.add(xml, real.type(), name, size, real.bytes() * values.size(), [&values, real](WholeFile& file) {
      for (const double value : values) real.write(file, value);
    });
  };
  const auto ids = [&](const char* name, const std::vector<discretisation::Id>& values) {
    arrays.add(xml, "Int64", name, 1, 8 * values.size(),
               [&values](WholeFile& file) { file.write(values.data(), 8 * values.size()); });
  };
  xml += "<PointData Vectors=\"velocity\">\n";
  for (const auto& field : cells.fields) reals(field.name, field.size, field.value);
  xml += "</PointData>\n<Points>\n";
  reals("Points", 3, cells.point);
  xml += "</Points>\n<CellData>\n";
  ids("part_id", cells.part);
  ids("element_id", cells.element);
  xml += "</CellData>\n<Cells>\n";
  arrays.add(xml, "Int32", "connectivity", 1, 4 * cells.cell.size(),
             [&](WholeFile& file) { file.write(cells.cell.data(), 4 * cells.cell.size()); });
  arrays.add(xml, "Int64", "offsets", 1, 8 * count, [&](WholeFile& file) {
    for (std::size_t c = 1; c <= count; ++c) {
      const std::int64_t end = static_cast<std::int64_t>(c * corners);
      file.write(&end, 8);
    }
  });
  arrays.add(xml, "UInt8", "types", 1, count, [&](WholeFile& file) {
    static constexpr std::uint8_t types[] = {1, 3, 5, 10};  // vtkCellType.h
    for (std::size_t c = 0; c < count; ++c) file.write(&types[cells.dimension], 1);
  });
  xml += "</Cells>\n";

  WholeFile file(path);
  file.write(xml + vtu_appended);
  arrays.write(file);
  file.write(vtu_end);
  return file.commit();
}

}  // namespace cleave::results
