#include "results/history/elout_text.hpp"

#include "results/text.hpp"

namespace cleave::results {

using model::ElementKind;

void append_elout_heading(std::string& ascii, ElementKind kind, std::int64_t cycle, double time) {
  const auto step = static_cast<long long>(cycle);
  if (kind == ElementKind::beam) {
    append_format(ascii,
                  "\n\n\n\n r e s u l t a n t s   a n d   s t r e s s e s   f o r   t i m e  s t e p%9lld"
                  "   ( at time%12.5E )\n",
                  step, column(time));
    return;
  }
  append_format(ascii,
                "\n\n\n e l e m e n t   s t r e s s   c a l c u l a t i o n s   f o r   t i m e  s t e p%9lld"
                "   ( at time%12.5E )\n\n",
                step, column(time));
  if (kind == ElementKind::shell)
    ascii +=
        " element  materl(global)\n"
        " ipt-shl  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx"
        "       plastic\n"
        "           state                                                                       "
        "          strain \n";
  else
    ascii +=
        " element  materl\n"
        "     ipt  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx"
        "                       plastic\n"
        "           state                                                                       "
        "           effsg      strain\n";
}

void append_elout_element(std::string& ascii, ElementKind kind, model::Id element, model::Id part,
                          const double* stress, double von_mises, double plastic_strain, double area) {
  const auto id = static_cast<long long>(element), owner = static_cast<long long>(part);
  if (kind == ElementKind::beam) {
    append_format(ascii, "\n\n beam/truss # =%8lld      part ID  =%10lld      material type=%8d\n", id, owner,
                  1);
    ascii += "\n resultants      axial    shear-s    shear-t    moment-s   moment-t   torsion\n           ";
    append_format(ascii, "%11.3E", column(area * stress[0]));
    for (int k = 0; k < 5; ++k) append_format(ascii, "%11.3E", 0.0);
    ascii +=
        "\n\n\n integration point stresses\n"
        "                       sigma 11       sigma 12       sigma 31   plastic  eps\n";
    append_format(ascii, "%5d           %15.6E%15.6E%15.6E%15.6E\n", 1, column(stress[0]), 0.0, 0.0,
                  column(plastic_strain));
    return;
  }
  append_format(ascii, "%8lld-%7lld\n", id, owner);
  append_format(ascii, kind == ElementKind::shell ? "   1-  1 %-7s " : "       1 %-7s ",
                plastic_strain > 0.0 ? "plastic" : "elastic");
  for (int k = 0; k < 6; ++k) append_format(ascii, "%12.4E", column(stress[k]));
  if (kind == ElementKind::solid) append_format(ascii, "%14.4E", column(von_mises));
  append_format(ascii, "%14.4E\n", column(plastic_strain));
}

}  // namespace cleave::results
