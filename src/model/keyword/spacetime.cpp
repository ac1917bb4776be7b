/// *CONTROL_SPACETIME: how spacetime parts are solved; *BOUNDARY_PRECRACK: cracks that are there from the
/// start.

#include "model/keyword/handler.hpp"
#include "model/keyword/local_space.hpp"

namespace cleave::model {

bool check_local_space(Draft& draft, const Entry& entry) {
  const auto space = entry.integer("SPACE"), degree = entry.integer("DEGREE");
  const bool known = space >= 0 && space <= 3, fair = degree >= 0 && degree <= 6;
  if (!known)
    draft.error(entry, "SPACE", "found " + std::to_string(space) + ", expected 1, 2 or 3",
                "1 displacement alone, 2 displacement, velocity and strain, 3 Trefftz");
  if (!fair) draft.error(entry, "DEGREE", "found " + std::to_string(degree) + ", expected 1 to 6");
  return known && fair;
}

namespace {

void take_control(Draft& draft, const Entry& entry) {
  SpacetimeControl& control = draft.model.control.spacetime;
  control = {};
  control.place = entry.place();
  if (!check_local_space(draft, entry)) return;
  using Space = SpacetimeControl::Space;
  using Progress = SpacetimeControl::Progress;
  static constexpr Space spaces[] = {Space::trefftz, Space::one_field, Space::three_field, Space::trefftz};
  static constexpr Progress constraints[] = {Progress::subsimplex, Progress::triangle, Progress::subsimplex,
                                             Progress::budget};
  control.space = spaces[entry.integer("SPACE")];
  if (entry.integer("DEGREE") != 0) control.degree = static_cast<int>(entry.integer("DEGREE"));
  const auto progress = entry.integer("PROG");
  if (progress < 0 || progress > 3)
    draft.error(entry, "PROG", "found " + std::to_string(progress) + ", expected 1, 2 or 3",
                "1 bounds of triangles, 2 of edges and faces, 3 time budgets");
  else
    control.progress = constraints[progress];

  // A number with the range it may lie in; blank or 0 leaves the default.
  const auto number = [&](std::string_view field, Dimension dimension, double high, bool high_too,
                          double& to) {
    const double value = entry.real_or(field, dimension, to);
    if (value < 0.0 || value > high || (value == high && !high_too))
      draft.error(entry, field,
                  "found " + std::to_string(value) + ", expected a value above 0 and " +
                      (high_too ? "at most " : "below ") + std::to_string(high));
    else
      to = value;
  };
  number("CHI", pure, 1.0, false, control.chi);
  number("EPS", pure, 0.5, true, control.eps);
  number("HFAC", pure, 1.0, true, control.height_factor);
  number("HCAP", a_time, 1e300, true, control.height_cap);
  number("SMOOTH", pure, 1.0, true, control.smoothing);
  const auto count = [&](std::string_view field, std::int64_t most, int& to) {
    const auto value = entry.integer(field);
    if (value < 0 || value > most)
      draft.error(entry, field, "found " + std::to_string(value) + ", expected 0 to " + std::to_string(most));
    else
      to = static_cast<int>(value);
  };
  count("NTHR", 4096, control.threads);
  count("NSUB", 16, control.subdivision);
  int verify = 0;
  count("VERIFY", 1, verify);
  control.verify = verify == 1;
  int repeat = 0;
  count("REPEAT", 1, repeat);
  control.repeat = repeat == 1;
}

/// Corners of a polyline (in the plane) or of a plane convex polygon (in space).
void take_precrack(Draft& draft, const Entry& entry) {
  if (const auto type = entry.integer("CTYPE"); type != 0 && type != 1)
    return draft.refuse(entry, "CTYPE", "a crack of type " + std::to_string(type),
                        "give its corners (type 1)");
  const Index part = draft.part(entry, "PID");
  if (part < 0) return;
  if (spacetime_dimension(draft.model.parts[part].section) == 0)
    return draft.refuse(entry, "PID",
                        "part " + std::to_string(draft.model.parts[part].id) + " is not solved in spacetime",
                        "cracks are opened in parts with *SECTION_SHELL_SDG, _SOLID_SDG or _BEAM_SDG");
  Precrack crack{.part = draft.model.parts[part].id, .points = {}, .place = entry.place("PID")};
  for (std::size_t row = 0; row < entry.card().row_count("X"); ++row) {
    const auto at = [&](std::string_view field) { return entry.real(field, a_length, row); };
    crack.points.push_back(entry.motion().point({at("X"), at("Y"), at("Z")}));
  }
  if (crack.points.empty()) return draft.error(entry, "NP", "the crack has no points");
  draft.model.precracks.push_back(std::move(crack));
}

/// The unit vector along a direction across another one; zero if there is none.
Vector across(const Vector& v, const Vector& direction) {
  const Vector left = v - base::dot(v, direction) * direction;
  return length(left) > 1e-6 * length(v) ? unit(left) : Vector{0, 0, 0};
}

/// A plane wave through silent faces; its speed is that of the material behind them.
void take_incident_wave(Draft& draft, const Entry& entry) {
  int dimension = 0;
  for (const Part& part : draft.model.parts)
    dimension = std::max(dimension, spacetime_dimension(part.section));
  if (dimension == 0)
    return draft.refuse(entry, "SSID", "incident waves are computed for spacetime parts only",
                        "give the parts *SECTION_SHELL_SDG, _SOLID_SDG or _BEAM_SDG");
  const auto* set = draft.segment_set(entry, "SSID");
  IncidentWave wave;
  wave.place = entry.place("SSID");
  const auto type = entry.integer("WTYPE");
  if (type < 0 || type > 2)
    return draft.error(entry, "WTYPE", "found " + std::to_string(type) + ", expected 1 or 2",
                       "1 pressure wave, 2 shear wave");
  wave.kind = type == 2 ? IncidentWave::Kind::shear : IncidentWave::Kind::pressure;
  wave.curve = draft.curve(entry, "LCID");
  wave.scale = entry.real_or("SF", pure, 1.0);
  wave.arrival = entry.real("AT", a_time);
  const auto direction = [&](std::string_view x, std::string_view y, std::string_view z) {
    return entry.motion().direction({entry.card().real(x), entry.card().real(y), entry.card().real(z)});
  };
  wave.direction = direction("DX", "DY", "DZ");
  if (length(wave.direction) == 0.0) return draft.error(entry, "DX", "the direction has no length");
  wave.direction = unit(wave.direction);
  const double out = dimension == 1   ? std::hypot(wave.direction.y, wave.direction.z)
                     : dimension == 2 ? std::fabs(wave.direction.z)
                                      : 0.0;
  if (out > 1e-9)
    return draft.error(entry, dimension == 1 ? "DY" : "DZ",
                       "the wave does not travel in the plane or line of the body",
                       dimension == 1 ? "waves in bars travel along x" : "let DZ be 0");
  wave.reference = entry.point("XR", "YR", "ZR");
  if (wave.kind == IncidentWave::Kind::shear) {
    if (dimension == 1)
      return draft.error(entry, "WTYPE", "there are no shear waves in a bar", "choose 1, a pressure wave");
    const Vector given = direction("PX", "PY", "PZ");
    if (dimension == 2) {
      if (given.z != 0.0)
        return draft.refuse(entry, "PZ", "motion out of the plane", "let the wave move in the plane: PZ = 0");
      wave.polarisation = length(given) > 0.0 ? across(given, wave.direction)
                                              : Vector{-wave.direction.y, wave.direction.x, 0.0};
    } else {
      wave.polarisation = across(given, wave.direction);
    }
    if (length(wave.polarisation) == 0.0)
      return draft.error(entry, "PX", "the motion of a shear wave needs a direction across its path");
  }
  if (!set || wave.curve < 0) return;
  wave.segments = *set;
  draft.model.incident_waves.push_back(std::move(wave));
}

constexpr Handler handlers[] = {
    {.keyword = "CONTROL_SPACETIME", .phase = Phase::definition, .honoured = "*", .take = take_control},
    {.keyword = "BOUNDARY_PRECRACK",
     .honoured = "ID HEADING PID CTYPE NP X Y Z",
     .take = take_precrack,
     .remark = "in spacetime parts, along edges or faces of the mesh"},
    {.keyword = "LOAD_INCIDENT_WAVE",
     .honoured = "ID HEADING SSID WTYPE LCID SF AT DX DY DZ XR YR ZR PX PY PZ",
     .take = take_incident_wave,
     .remark = "in spacetime parts, through faces that are silent by *BOUNDARY_NON_REFLECTING"},
};

}  // namespace
extern const Family spacetime_cards{handlers};

}  // namespace cleave::model
