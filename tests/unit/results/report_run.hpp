#pragma once
/// A run directory as a Taylor bar would leave it, made from closed forms: for tests of the page.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "picture_meshes.hpp"

namespace cleave::results::test {

/// Arrays of a .vtu file: the tags of its head and the raw data behind them.
class VtuText {
 public:
  template <class Value>
  std::string array(const char* type, const char* name, int components, const std::vector<Value>& values) {
    const std::string tag = std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
                            "\" NumberOfComponents=\"" + std::to_string(components) +
                            "\" format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>\n";
    const std::uint64_t bytes = values.size() * sizeof(Value);
    data_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    data_.append(reinterpret_cast<const char*>(values.data()), bytes);
    return tag;
  }
  const std::string& data() const { return data_; }

 private:
  std::string data_;
};

/// One frame of hexahedra with plastic strain, pressure and displacement; element ids from 101.
inline void write_vtu_file(const std::filesystem::path& file, const TestMesh& now, const TestMesh& start,
                           double time) {
  const std::size_t cells = now.node.size() / 8;
  std::vector<std::int64_t> connectivity(now.node.begin(), now.node.end()), offsets, ids;
  std::vector<std::uint8_t> types(cells, 12);
  std::vector<float> strain, pressure, points(now.position.begin(), now.position.end()), displacement;
  for (std::size_t c = 0; c < cells; ++c) {
    offsets.push_back(static_cast<std::int64_t>(8 * (c + 1)));
    ids.push_back(static_cast<std::int64_t>(101 + c));
    const double z = start.position[3 * static_cast<std::size_t>(now.node[8 * c]) + 2];
    strain.push_back(static_cast<float>(2.7 * std::exp(-0.21 * z) * time / 8e-5));
    pressure.push_back(static_cast<float>(400.0 * std::cos(0.3 * z + 4e5 * time)));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    displacement.push_back(static_cast<float>(now.position[i] - start.position[i]));
  VtuText text;
  std::string head =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
      std::to_string(now.node_count()) + "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n";
  head += "<PointData>\n" + text.array("Float32", "displacement", 3, displacement) +
          "</PointData>\n<Points>\n" + text.array("Float32", "Points", 3, points) + "</Points>\n<CellData>\n";
  head += text.array("Int64", "element_id", 1, ids) + text.array("Float32", "pressure", 1, pressure) +
          text.array("Float32", "effective_plastic_strain", 1, strain) + "</CellData>\n<Cells>\n";
  head += text.array("Int64", "connectivity", 1, connectivity) + text.array("Int64", "offsets", 1, offsets) +
          text.array("UInt8", "types", 1, types) + "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
  std::ofstream(file, std::ios::binary)
      << head << "<AppendedData encoding=\"raw\">\n_" << text.data() << "\n</AppendedData>\n</VTKFile>\n";
}

/// Writes the whole directory. @param across, along  elements of the bar; @param frames  at least 1
inline void write_run(const std::filesystem::path& directory, int across, int along, int frames) {
  namespace fs = std::filesystem;
  constexpr double end = 8e-5;
  fs::create_directories(directory / "result");
  const TestMesh start = mushroom(across, along, 3.2, 32.4, 0.0);
  std::string list = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">\n<Collection>\n";
  for (int f = 0; f < frames; ++f) {
    const double time = frames > 1 ? end * f / (frames - 1) : end;
    const std::string name = "result/result_" + std::to_string(f) + ".vtu";
    write_vtu_file(directory / name, mushroom(across, along, 3.2, 32.4, 1.2 * std::sin(1.57 * time / end)),
                   start, time);
    list +=
        "<DataSet timestep=\"" + std::to_string(time * 1e6) + "e-6\" part=\"0\" file=\"" + name + "\"/>\n";
  }
  std::ofstream(directory / "result.pvd") << list << "</Collection>\n</VTKFile>\n";

  std::ofstream glstat(directory / "glstat.csv"), nodout(directory / "nodout.csv"),
      wall(directory / "rwforc.csv");
  glstat << "time,cycle,time_step,kinetic_energy,internal_energy,hourglass_energy,stonewall_energy,external_"
            "work,"
            "total_energy,energy_ratio,z_momentum,percent_mass_increase\n";
  nodout << "time,cycle,id,x_displacement,y_displacement,z_displacement,z_velocity\n";
  wall << "time,cycle,id,normal_force\n";
  for (int row = 0; row <= 400; ++row) {
    const double time = end * row / 400, kinetic = 238.0 * std::pow(std::cos(1.5 * row / 400.0), 2);
    const double hourglass = 2.4 * row / 400.0,
                 internal = 238.0 - kinetic - hourglass - 0.3 * std::sin(row / 60.0);
    glstat << time << ',' << 6 * row << ',' << 3.4e-8 - 1.9e-8 * row / 400 << ',' << kinetic << ','
           << internal << ',' << hourglass << ",0,0," << kinetic + internal + hourglass << ','
           << (kinetic + internal + hourglass) / 238.0 << ',' << -2.1 * std::cos(1.6 * row / 400.0) << ",0\n";
    for (const int id : {11, 12, 2034})
      nodout << time << ',' << 6 * row << ',' << id << ',' << 0.001 * id * row / 400 << ",0,"
             << (row == 200 ? NAN : -11.0 * row / 400 * std::exp(-id / 3000.0)) << ','
             << -227e3 * (1 - row / 400.0) << '\n';
    wall << time << ',' << 6 * row << ",1,"
         << 9.1e3 * std::exp(-row / 160.0) * (1 + 0.3 * std::sin(row / 4.0)) << '\n';
  }
  std::ofstream(directory / "summary.json") << R"({
 "title": "Taylor bar, OFHC copper, 227 m/s </script>", "program": "cleave", "version": "0.1.0",
 "deck": "examples/taylor/taylor.k", "ending": "end_time", "ending_text": "the end time was reached",
 "normal": true, "failure": null, "files_failed": null, "final_time": 8e-5, "cycles": 2400,
 "time_step": {"first": 3.4e-8, "last": 1.5e-8, "smallest": 1.48e-8, "largest": 3.4e-8},
 "energy": {"kinetic": 1.2, "internal": 233.9, "hourglass": 2.4, "total": 237.5, "ratio": 0.99874,
   "ratio_low": 0.99860, "ratio_high": 1.00001},
 "mass": {"total": 0.00933, "added": 0, "percent_increase": 0},
 "counts": {"nodes": 29000, "hex8": 25600, "elements": 25600, "parts": 1},
 "eroded_elements": 0,
 "parts": [{"id": 1, "title": "bar", "elements": 25600, "mass": 0.00933,
   "final": {"low": [-7.1, -7.1, 0], "high": [7.1, 7.1, 21.4], "length": [14.2, 14.2, 21.4], "diameter": 14.2}}],
 "speed": {"seconds": 12.4, "element_cycles": 61440000, "element_cycles_per_second": 4954838,
   "nanoseconds_per_element_cycle": 201.8, "threads": 2,
   "phases": {"elements": 9.8, "loads": 0.6, "update": 1.1, "output": 0.7}},
 "memory": {"peak_bytes": 74000000, "bytes_per_element": 612},
 "deck_account": [
  {"keyword": "NODE", "policy": "honoured", "cards": 29000, "defaulted": 58000, "ignored_fields": [], "remark": ""},
  {"keyword": "SECTION_SOLID", "policy": "in_part", "cards": 1, "defaulted": 2, "ignored_fields": ["AET"],
   "remark": "ambient elements are not treated"},
  {"keyword": "DATABASE_BINARY_D3PLOT", "policy": "output_only", "cards": 1, "defaulted": 0, "ignored_fields": [],
   "remark": "frames are written as .vtu"},
  {"keyword": "CONTACT_AUTOMATIC", "policy": "refused", "cards": 1, "defaulted": 0, "ignored_fields": [],
   "remark": "contact is not available"}],
 "unsupported": ["CONTACT_AUTOMATIC"], "warnings": 1
})";
}

}  // namespace cleave::results::test
