#include "model/material/elastic.hpp"

namespace cleave::model {
namespace {

// Parts of this material do not deform; the elastic constants give contact its stiffness, and a model of
// rigid parts alone its step. Constraints of the centre and the body's axes are read where the bodies are
// made.
constexpr LawField fields[] = {
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
    {.name = "CMO", .dimension = "-", .low = -1.0, .high = 1.0},
    {.name = "CON1", .dimension = "-", .low = 0.0},
    {.name = "CON2", .dimension = "-", .low = 0.0},
    {.name = "LCO", .dimension = "-"},
    {.name = "A2", .dimension = "-"},
    {.name = "A3", .dimension = "-"},
    {.name = "V1", .dimension = "-"},
    {.name = "V2", .dimension = "-"},
    {.name = "V3", .dimension = "-"},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext&) {
  const double e = card["E"], nu = card["PR"];
  return std::make_unique<TiledLaw<Elastic>>(
      Elastic{.bulk_modulus = e / (3.0 * (1.0 - 2.0 * nu)), .shear_modulus = e / (2.0 * (1.0 + nu))});
}

}  // namespace

extern const LawEntry rigid{.keyword = "MAT_RIGID",
                            .fields = fields,
                            .build = build,
                            .source = "Belytschko, Liu & Moran 2000, eq. 5.4.21, where others touch it",
                            .harmless = "BNDLCO"};

}  // namespace cleave::model
