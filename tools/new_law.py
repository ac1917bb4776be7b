#!/usr/bin/env python3
"""Writes the skeleton of a material law and its line in the catalogue.

usage: new_law.py NAME [ROOT]      (./x new law NAME)

NAME is the file's and the entry's name in snake_case; the keyword starts as MAT_NAME. The skeleton is a complete
law, von Mises plasticity with linear hardening: replace its fields, state and update by those of the new law. The
sweep tests over the catalogue test it from the first build.
"""
import re
import sys
from pathlib import Path

SKELETON = """\
#include <array>

#include "model/material/kernel.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// von Mises plasticity, linear isotropic hardening, radial return.
/// Source: Simo & Hughes, Computational Inelasticity (1998), box 3.1.
struct @Type@ {
  static constexpr int state_size = 1;       ///< equivalent plastic strain [-]
  static constexpr int rotated_tensors = 0;  ///< no state value turns with the body
  static constexpr int plastic_strain = 0;   ///< its index in the state
  static constexpr bool needs_F = false;
  static constexpr std::array<StateName, 1> state_names{{{"effective_plastic_strain", 0, 1}}};

  double k, g;          ///< bulk and shear modulus [stress]
  double yield, slope;  ///< yield stress, plastic modulus [stress]

  bool can_fail() const { return false; }
  double longitudinal() const { return k + 4.0 / 3.0 * g; }
  double shear() const { return g; }
  void initialise(std::span<double> state) const { state[0] = 0.0; }

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    // Trial stress, as if the whole step were elastic.
    const Real mean = (1.0 / 3.0) * trace(p.stress) + k * trace(p.strain_increment);
    const auto trial = deviator(p.stress) + (2.0 * g) * deviator(p.strain_increment);
    const Real q = sqrt(1.5 * dot(trial, trial));
    // Return along the radius to the yield surface of the end of the step.
    const Real excess = q - (yield + slope * p.state[0]);
    const Real flow = max(excess, Real(0.0)) * (1.0 / (3.0 * g + slope));
    const Real scale = 1.0 - 3.0 * g * flow / max(q, Real(1e-300));
    p.stress = scale * trial + base::spherical(mean);
    p.state[0] = p.state[0] + flow;
    p.modulus = Real(longitudinal());
  }
};

constexpr LawField fields[] = {
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
    {.name = "SIGY", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "ETAN", .dimension = "stress", .low = 0.0},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext&) {
  const double e = card["E"], nu = card["PR"], tangent = card["ETAN"];
  @Type@ law{};
  law.k = e / (3.0 * (1.0 - 2.0 * nu));
  law.g = e / (2.0 * (1.0 + nu));
  law.yield = card["SIGY"];
  law.slope = e * tangent / (e - tangent);
  return std::make_unique<TiledLaw<@Type@>>(law);
}

}  // namespace

extern const LawEntry @name@{
    .keyword = "@KEYWORD@", .fields = fields, .build = build, .source = "Simo & Hughes 1998, box 3.1"};

}  // namespace cleave::model
"""


def main(name, root):
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name):
        sys.exit(f"new_law.py: '{name}': a snake_case name is expected")
    folder = root / "src/model/material"
    source, catalogue = folder / f"{name}.cpp", folder / "catalogue.inc"
    if source.exists():
        sys.exit(f"new_law.py: {source} is there already")
    text = SKELETON.replace("@Type@", "".join(w.capitalize() for w in name.split("_")))
    source.write_text(text.replace("@name@", name).replace("@KEYWORD@", "MAT_" + name.upper()))
    with catalogue.open("a") as stream:
        stream.write(f"CLEAVE_LAW({name})\n")
    print(f"{source.relative_to(root)}: a complete law to start from; set its keyword, fields, state and update")
    print(f"{catalogue.relative_to(root)}: one line added")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(sys.argv[1], Path(sys.argv[2] if len(sys.argv) == 3 else Path(__file__).parent.parent).resolve())
