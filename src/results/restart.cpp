#include "results/restart.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "results/files.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

using discretisation::State;

constexpr std::int64_t format_version = 2;
static_assert(std::endian::native == std::endian::little, "the files hold little-endian numbers");

/// An HDF5 identifier with its way of closing.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
  ~Handle() { close(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: it is one
  bool good() const { return id_ >= 0; }
  bool close() {
    const bool closed = id_ < 0 || close_(id_) >= 0;
    id_ = -1;
    return closed;
  }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The message of the system inside HDF5's error stack, else its innermost description.
std::string hdf5_reason() {
  std::string found;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
        auto& text = *static_cast<std::string*>(out);
        const std::string description = error->desc ? error->desc : "";
        const std::string mark = "error message = '";
        if (const auto at = description.find(mark); at != std::string::npos) {
          const auto from = at + mark.size();
          text = description.substr(from, description.find('\'', from) - from);
          return 1;
        }
        if (text.empty()) text = description;
        return 0;
      },
      &found);
  return found.empty() ? "HDF5 gives no reason" : found;
}

/// Writes named values below a group; the first failure is kept.
class Output {
 public:
  explicit Output(hid_t group) : group_(group) {}
  void integer(const char* name, std::int64_t value) {
    attribute(name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
  }
  void real(const char* name, double value) { attribute(name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value); }
  void text(const char* name, const std::string& value) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, value.size() + 1);
    attribute(name, type, type, value.c_str());
  }
  void array(const char* name, const double* values, std::size_t count) {
    const hsize_t extent = count;
    const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false);  // equal states give equal files, whenever they were written
    Handle data(H5Dcreate2(group_, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                H5Dclose);
    check(data.good() &&
          (count == 0 || H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0));
    check(data.close());
  }
  const std::string& error() const { return error_; }
  void check(bool good) {
    if (!good && error_.empty()) error_ = hdf5_reason();
  }

 private:
  void attribute(const char* name, hid_t type, hid_t memory_type, const void* value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle item(H5Acreate2(group_, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(item.good() && H5Awrite(item, memory_type, value) >= 0);
  }

  hid_t group_;
  std::string error_;
};

/// Reads what Output wrote; a missing or odd item leaves its default and is kept as error.
class Input {
 public:
  explicit Input(hid_t group) : group_(group) {}
  std::int64_t integer(const char* name) {
    std::int64_t value = 0;
    attribute(name, H5T_NATIVE_INT64, &value);
    return value;
  }
  double real(const char* name) {
    double value = 0.0;
    attribute(name, H5T_NATIVE_DOUBLE, &value);
    return value;
  }
  std::string text(const char* name) {
    const Handle item(H5Aopen(group_, name, H5P_DEFAULT), H5Aclose);
    if (!item.good()) return fail(name), std::string();
    const Handle type(H5Aget_type(item), H5Tclose);
    std::string value(H5Tget_size(type), '\0');
    if (H5Aread(item, type, value.data()) < 0) fail(name);
    value.resize(std::strlen(value.c_str()));
    return value;
  }
  template <class Array>
  void array(const char* name, Array& values) {
    const Handle data(H5Dopen2(group_, name, H5P_DEFAULT), H5Dclose);
    if (!data.good()) return fail(name);
    const Handle space(H5Dget_space(data), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count < 0) return fail(name);
    values.resize(static_cast<std::size_t>(count));
    if (count > 0 && H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
      fail(name);
  }
  const std::string& error() const { return error_; }
  void fail(const char* name) {
    if (error_.empty()) error_ = std::string("it has no readable '") + name + "'";
  }

 private:
  void attribute(const char* name, hid_t memory_type, void* value) {
    const Handle item(H5Aopen(group_, name, H5P_DEFAULT), H5Aclose);
    if (!item.good() || H5Aread(item, memory_type, value) < 0) fail(name);
  }

  hid_t group_;
  std::string error_;
};

/// Every number of a State outside its arrays, in the order in which the file has them.
template <class Scalar, class Visit>
void each_scalar(Scalar& state, const Visit& visit) {
  visit("time", state.time);
  visit("step", state.step);
  visit("next_step", state.next_step);
  visit("first_step", state.first_step);
  visit("added_mass", state.added_mass);
  visit("largest_force", state.largest_force);
  auto& energy = state.energy;
  visit("energy_kinetic", energy.kinetic);
  visit("energy_internal", energy.internal);
  visit("energy_hourglass", energy.hourglass);
  visit("energy_damping", energy.damping);
  visit("energy_wall", energy.wall);
  visit("energy_sliding", energy.sliding);
  visit("energy_external", energy.external);
  visit("energy_eroded_kinetic", energy.eroded_kinetic);
  visit("energy_eroded_internal", energy.eroded_internal);
  visit("energy_eroded_hourglass", energy.eroded_hourglass);
  visit("energy_initial", energy.initial);
}

constexpr std::size_t part_numbers = 5;
static_assert(sizeof(discretisation::PartEnergy) == part_numbers * sizeof(double),
              "a new number of PartEnergy belongs in the restart file");
static_assert(sizeof(discretisation::Energy) == 11 * sizeof(double),
              "a new number of Energy belongs in the restart file");

using Memories = std::vector<const discretisation::Memory*>;

Memories all_memory(const State& state, std::span<const discretisation::Memory> observers) {
  Memories all;
  for (const auto& memory : state.memory)
    if (std::none_of(observers.begin(), observers.end(),
                     [&](const auto& o) { return o.name == memory.name; }))
      all.push_back(&memory);
  for (const auto& memory : observers) all.push_back(&memory);
  return all;
}

void write_state(Output& out, const State& state, const Memories& memories) {
  out.integer("cycle", state.cycle);
  each_scalar(state, [&](const char* name, double value) { out.real(name, value); });
  out.array("position", state.position.data(), state.position.size());
  out.array("velocity", state.velocity.data(), state.velocity.size());
  out.array("mass", state.mass.data(), state.mass.size());
  std::vector<double> parts;
  for (const auto& part : state.parts)
    parts.insert(parts.end(), {part.internal, part.hourglass, part.eroded_internal, part.eroded_hourglass,
                               part.eroded_kinetic});
  out.array("parts", parts.data(), parts.size());
  out.integer("block_count", static_cast<std::int64_t>(state.blocks.size()));
  for (std::size_t b = 0; b < state.blocks.size(); ++b) {
    const std::string name = "block_" + std::to_string(b) + '_';
    const auto& block = state.blocks[b];
    out.array((name + "point").c_str(), block.point.data(), block.point.size());
    out.array((name + "element").c_str(), block.element.data(), block.element.size());
    out.array((name + "alive").c_str(), block.alive.data(), block.alive.size());
  }
  out.integer("memory_count", static_cast<std::int64_t>(memories.size()));
  for (std::size_t m = 0; m < memories.size(); ++m) {
    const std::string name = "memory_" + std::to_string(m);
    out.text((name + "_name").c_str(), memories[m]->name);
    out.array(name.c_str(), memories[m]->values.data(), memories[m]->values.size());
  }
}

void read_state(Input& in, State& state) {
  state.cycle = in.integer("cycle");
  each_scalar(state, [&](const char* name, double& value) { value = in.real(name); });
  in.array("position", state.position);
  in.array("velocity", state.velocity);
  in.array("mass", state.mass);
  std::vector<double> parts;
  in.array("parts", parts);
  for (std::size_t p = 0; p + part_numbers <= parts.size(); p += part_numbers)
    state.parts.push_back({parts[p], parts[p + 1], parts[p + 2], parts[p + 3], parts[p + 4]});
  const std::int64_t blocks = in.integer("block_count");
  for (std::int64_t b = 0; b < blocks && in.error().empty(); ++b) {
    const std::string name = "block_" + std::to_string(b) + '_';
    auto& block = state.blocks.emplace_back();
    in.array((name + "point").c_str(), block.point);
    in.array((name + "element").c_str(), block.element);
    in.array((name + "alive").c_str(), block.alive);
  }
  const std::int64_t memories = in.integer("memory_count");
  for (std::int64_t m = 0; m < memories && in.error().empty(); ++m) {
    const std::string name = "memory_" + std::to_string(m);
    auto& memory = state.memory.emplace_back();
    memory.name = in.text((name + "_name").c_str());
    in.array(name.c_str(), memory.values);
  }
}

/// Bytes the file will need, a little more than the arrays.
std::uint64_t size_of(const State& state, const Memories& memories) {
  std::uint64_t values = state.position.size() + state.velocity.size() + state.mass.size();
  for (const auto& block : state.blocks)
    values += block.point.size() + block.element.size() + block.alive.size();
  for (const auto* memory : memories) values += memory->values.size();
  return 8 * values + 65536 + 4096 * (state.blocks.size() + memories.size());
}

/// Is there room for that many bytes? Asked before HDF5 begins, which recovers badly from a full disk.
std::string room_for(const std::filesystem::path& path, std::uint64_t bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return std::strerror(errno);
  std::string reason;
  // File systems that cannot reserve space are simply tried.
  if (::fallocate(file, 0, 0, static_cast<off_t>(bytes)) != 0 && errno != EOPNOTSUPP && errno != ENOSYS)
    reason = std::strerror(errno);
  ::close(file);
  ::unlink(path.c_str());
  return reason;
}

std::string write_file(const std::filesystem::path& path, const State& state, const Memories& memories,
                       const RestartOrigin& origin) {
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (!file.good()) return hdf5_reason();
  Output out(file);
  out.text("program", "cleave");
  out.integer("format_version", format_version);
  out.text("deck", origin.deck);
  out.text("deck_fingerprint", origin.fingerprint);
  out.text("version", origin.version);
  out.text("title", origin.title);
  std::string paths;
  for (const auto& include : origin.include_paths) paths += include.string() + '\n';
  out.text("include_paths", paths);
  out.integer("allow_unsupported", origin.allow_unsupported);
  out.real("end_time", origin.end_time);
  write_state(out, state, memories);
  out.check(file.close());
  return out.error();
}

/// HDF5 prints its error stacks unless told not to (the text goes into our own messages instead), and its
/// cleanup at exit aborts when a file could not be closed because the disk is full; we close what we open.
void tame_hdf5() {
  static const herr_t once = H5dont_atexit();
  (void)once;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace

std::string fingerprint(const deck::Sources& sources) {
  std::uint64_t hash = 14695981039346656037u;
  const auto add = [&](unsigned char byte) { hash = (hash ^ byte) * 1099511628211u; };
  for (int i = 0; i < sources.count(); ++i) {
    for (const char c : sources.file(i).text) add(static_cast<unsigned char>(c));
    add(0);  // where one file ends and the next begins
  }
  std::string digits;
  append_format(digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::string write_restart(const std::filesystem::path& path, const State& state, const RestartOrigin& origin,
                          std::span<const discretisation::Memory> observers) {
  const Memories memories = all_memory(state, observers);
  tame_hdf5();
  std::filesystem::path unfinished = path;
  unfinished += unfinished_suffix;
  std::string reason = room_for(unfinished, size_of(state, memories));
  if (reason.empty()) reason = write_file(unfinished, state, memories, origin);
  if (reason.empty()) {
    // On the disk before the old file is replaced: also a power cut leaves one of the two.
    const int file = ::open(unfinished.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0 || ::fsync(file) != 0 || ::rename(unfinished.c_str(), path.c_str()) != 0)
      reason = std::strerror(errno);
    if (file >= 0) ::close(file);
  }
  if (!reason.empty()) ::unlink(unfinished.c_str());
  return reason;
}

Restart read_restart(const std::filesystem::path& path) {
  tame_hdf5();
  Restart restart;
  const std::string start = "cannot restart from " + path.string() + ": ";
  if (!std::filesystem::exists(path)) {
    restart.error = start + "there is no such file";
    return restart;
  }
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.good()) {
    restart.error =
        start + (H5Fis_hdf5(path.c_str()) > 0 ? "the file is cut off or damaged (" + hdf5_reason() + ")"
                                              : "it is not an HDF5 file, or cut off");
    return restart;
  }
  Input in(file);
  const std::string program = in.text("program");
  if (program != "cleave") {
    restart.error = start + "it is an HDF5 file, but not a restart file of cleave";
    return restart;
  }
  const std::int64_t version = in.integer("format_version");
  RestartOrigin& origin = restart.origin;
  origin.deck = in.text("deck");
  origin.fingerprint = in.text("deck_fingerprint");
  origin.version = in.text("version");
  origin.title = in.text("title");
  if (version != format_version) {
    restart.error = start + "its format is version " + std::to_string(version) + " (cleave " +
                    origin.version + "), this program reads version " + std::to_string(format_version);
    return restart;
  }
  std::istringstream paths(in.text("include_paths"));
  for (std::string line; std::getline(paths, line);) origin.include_paths.emplace_back(line);
  origin.allow_unsupported = in.integer("allow_unsupported") != 0;
  origin.end_time = in.real("end_time");
  read_state(in, restart.state);
  if (!in.error().empty()) restart.error = start + in.error();
  return restart;
}

std::string misfit(const Restart& restart, const discretisation::World& world,
                   const std::string& deck_fingerprint) {
  const State& state = restart.state;
  if (restart.origin.fingerprint != deck_fingerprint)
    return "the restart file was written for " + restart.origin.deck +
           " with other content: the deck, or a file it includes, has changed since";
  if (state.position.size() != 3 * world.node_count())
    return "the restart file has " + std::to_string(state.position.size() / 3) + " nodes, the deck " +
           std::to_string(world.node_count());
  if (state.blocks.size() != world.blocks.size())
    return "the restart file has " + std::to_string(state.blocks.size()) + " blocks of elements, the deck " +
           std::to_string(world.blocks.size());
  for (std::size_t b = 0; b < state.blocks.size(); ++b)
    if (state.blocks[b].alive.size() < world.blocks[b]->element_ids().size())
      return "the restart file has fewer elements than the deck in part " +
             std::to_string(world.model->parts[static_cast<std::size_t>(world.blocks[b]->part())].id);
  return {};
}

}  // namespace cleave::results
