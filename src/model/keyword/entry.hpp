#pragma once
/// A card seen through the *INCLUDE_TRANSFORM it stands under: ids offset, quantities in the units of the
/// model.

#include "deck/card.hpp"
#include "deck/deck.hpp"
#include "model/keyword/affine.hpp"

namespace cleave::model {

/// The number spaces that *INCLUDE_TRANSFORM offsets separately.
enum class IdKind { node, element, part, material, set, function, definition, other };

/// Exponents of mass, length and time.
struct Dimension {
  int mass = 0, length = 0, time = 0;
};
inline constexpr Dimension pure{}, a_length{0, 1, 0}, a_time{0, 0, 1}, a_velocity{0, 1, -1}, a_mass{1, 0, 0},
    a_rate{0, 0, -1};

/// Factor from the units of an included file to those of the model.
double unit_factor(const deck::IncludeTransform& transform, Dimension dimension);
/// The offset for one number space.
Id id_offset(const deck::IncludeTransform& transform, IdKind kind);
bool changes_units(const deck::IncludeTransform& transform);

class Entry {
 public:
  Entry(deck::Card card, const deck::IncludeTransform& transform, const Affine& motion)
      : card_(std::move(card)), transform_(&transform), motion_(&motion) {}

  const deck::Card& card() const { return card_; }
  const deck::IncludeTransform& transform() const { return *transform_; }
  const Affine& motion() const { return *motion_; }  ///< identity unless the file is moved
  const std::string& keyword() const { return card_.keyword(); }
  bool has(std::string_view field) const { return card_.has_field(field); }
  bool given(std::string_view field, std::size_t row = 0) const { return card_.given(field, row); }
  deck::Place place() const { return card_.place(); }
  deck::Place place(std::string_view field, std::size_t row = 0) const { return card_.place(field, row); }

  /// An id with its offset; 0 stays 0, a negative id keeps its sign.
  Id id(IdKind kind, std::string_view field, std::size_t row = 0) const;
  /// The same for a number found elsewhere (series, first column of a row).
  Id offset(IdKind kind, Id written) const;
  std::int64_t integer(std::string_view field, std::size_t row = 0) const {
    return card_.integer(field, row);
  }
  double real(std::string_view field, Dimension dimension, std::size_t row = 0) const {
    return card_.real(field, row) * unit_factor(*transform_, dimension);
  }
  /// The value, or `fallback` (in model units) where the field is blank or 0, as the format reads most
  /// fields.
  double real_or(std::string_view field, Dimension dimension, double fallback) const {
    const double value = real(field, dimension);
    return value == 0.0 ? fallback : value;
  }
  /// A point in space, in model units and moved with its file.
  Vector point(std::string_view x, std::string_view y, std::string_view z) const;
  /// Title of the card: its _TITLE or _ID line, empty if there is none.
  std::string title() const;
  /// Number of the _ID line, 0 if there is none.
  Id own_id() const { return has("ID") ? card_.integer("ID") : 0; }

 private:
  deck::Card card_;
  const deck::IncludeTransform* transform_;
  const Affine* motion_;
};

}  // namespace cleave::model
