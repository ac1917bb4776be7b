#include "model/keyword/entry.hpp"

namespace cleave::model {
namespace {

double power(double base, int exponent) {
  double r = 1.0;
  for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) r *= base;
  return exponent < 0 ? 1.0 / r : r;
}

}  // namespace

double unit_factor(const deck::IncludeTransform& t, Dimension d) {
  if (!changes_units(t)) return 1.0;
  return power(t.mass, d.mass) * power(t.length, d.length) * power(t.time, d.time);
}

bool changes_units(const deck::IncludeTransform& t) {
  return t.mass != 1.0 || t.length != 1.0 || t.time != 1.0;
}

Id id_offset(const deck::IncludeTransform& t, IdKind kind) {
  switch (kind) {
    case IdKind::node:
      return t.node_offset;
    case IdKind::element:
      return t.element_offset;
    case IdKind::part:
      return t.part_offset;
    case IdKind::material:
      return t.material_offset;
    case IdKind::set:
      return t.set_offset;
    case IdKind::function:
      return t.function_offset;
    case IdKind::definition:
      return t.definition_offset;
    case IdKind::other:
      return t.other_offset;
  }
  return 0;
}

Id Entry::offset(IdKind kind, Id written) const {
  if (written == 0) return 0;
  const Id shift = id_offset(*transform_, kind);
  return written > 0 ? written + shift : written - shift;
}

Id Entry::id(IdKind kind, std::string_view field, std::size_t row) const {
  return offset(kind, card_.integer(field, row));
}

Vector Entry::point(std::string_view x, std::string_view y, std::string_view z) const {
  return motion_->point({real(x, a_length), real(y, a_length), real(z, a_length)});
}

std::string Entry::title() const {
  for (const char* field : {"TITLE", "HEADING"})
    if (has(field)) return std::string(card_.text(field));
  return {};
}

}  // namespace cleave::model
