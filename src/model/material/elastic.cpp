#include "model/material/elastic.hpp"

namespace cleave::model {
namespace {

constexpr LawField fields[] = {
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext&) {
  const double e = card["E"], nu = card["PR"];
  return std::make_unique<TiledLaw<Elastic>>(
      Elastic{.bulk_modulus = e / (3.0 * (1.0 - 2.0 * nu)), .shear_modulus = e / (2.0 * (1.0 + nu))});
}

}  // namespace

extern const LawEntry elastic{.keyword = "MAT_ELASTIC",
                              .fields = fields,
                              .build = build,
                              .source = "Belytschko, Liu & Moran 2000, eq. 5.4.21",
                              .harmless = "DA DB"};

}  // namespace cleave::model
