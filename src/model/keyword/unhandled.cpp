#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

using Policy = Account::Policy;

struct Rule {
  std::string_view keyword;  ///< a trailing * matches everything that begins so; the first match counts
  Policy policy;
  std::string_view remark;
};

constexpr std::string_view elsewhere = "settings of a feature that is itself refused where it is used";

/// Known keywords without a handler. What is not listed is refused.
constexpr Rule rules[] = {
    {"INCLUDE_STAMPED_PART", Policy::refused,
     "formed parts are not mapped; write the deformed mesh as *NODE"},
    {"INCLUDE_*", Policy::refused, "only decks are read; convert the file, or include it by *INCLUDE"},

    // Plot and print controls.
    {"DATABASE_CROSS_SECTION*", Policy::output_only, "section forces are not written"},
    {"DATABASE_*", Policy::output_only, "this result is not written"},
    {"CONTROL_OUTPUT", Policy::output_only, "print control"},
    {"CONTROL_MPP*", Policy::output_only, "set the ranks on the command line"},
    {"CONTROL_PARALLEL", Policy::output_only, "set the threads on the command line"},
    {"CONTROL_CPU", Policy::output_only, "limit the run time on the command line"},
    {"CONTROL_STRUCTURED", Policy::output_only, "the deck is printed back by another command"},
    {"CONTROL_UNITS", Policy::output_only, "units are only reported; no quantity is converted"},
    {"ELEMENT_PLOTEL", Policy::output_only, "drawn lines without stiffness"},
    {"INTERFACE_SPRINGBACK*", Policy::output_only,
     "no springback file is written; the restart file holds the state"},
    {"SENSOR_*", Policy::refused, "end the run by *TERMINATION_NODE or *CONTROL_TERMINATION"},

    // Settings and definitions that act only through keywords refused on their own.
    {"CONTROL_SHELL", Policy::output_only, elsewhere},
    {"CONTROL_CHECK_SHELL", Policy::output_only, elsewhere},
    {"CONTROL_RIGID", Policy::output_only,
     "joints and modes of rigid bodies are not computed; other bodies need none of it"},
    {"CONTROL_SPH", Policy::output_only, elsewhere},
    {"CONTROL_EFG", Policy::output_only, elsewhere},
    {"DEFINE_BOX_ADAPTIVE", Policy::output_only, elsewhere},
    {"DEFINE_BOX_SPH", Policy::output_only, elsewhere},
    {"DEFINE_CONTACT_VOLUME", Policy::output_only, elsewhere},
    {"DEFINE_FRICTION", Policy::output_only, elsewhere},
    {"DEFINE_SD_ORIENTATION", Policy::output_only, elsewhere},
    {"MAT_THERMAL_*", Policy::output_only, elsewhere},
    {"INTEGRATION_SHELL", Policy::output_only, elsewhere},
    {"SET_DISCRETE*", Policy::output_only, elsewhere},

    // Physics that is not computed, with what to do instead.
    {"AIRBAG_*", Policy::refused, "apply a pressure by *LOAD_SEGMENT_SET"},
    {"CONSTRAINED_*", Policy::refused, "merge the nodes, or hold them by *BOUNDARY_SPC"},
    {"CONTACT_*", Policy::refused,
     "this kind of contact is not computed; see the page on contact for those that are"},
    {"CONTROL_IMPLICIT_*", Policy::refused, "only explicit dynamics is computed"},
    {"CONTROL_ADAP*", Policy::refused, "the mesh is not refined during the run"},
    {"CONTROL_REMESH*", Policy::refused, "the mesh is not rebuilt during the run"},
    {"CONTROL_THERMAL*", Policy::refused, "heat conduction is not computed"},
    {"DAMPING_FREQUENCY_RANGE*", Policy::refused, "use *DAMPING_PART_MASS or *DAMPING_PART_STIFFNESS"},
    {"LOAD_SHELL*", Policy::refused,
     "shells deform in spacetime only, in their plane: load their edges by *LOAD_SEGMENT"},
    {"ELEMENT_SHELL*", Policy::refused, "rigid shells and spacetime parts are computed, by *ELEMENT_SHELL"},
    {"ELEMENT_BEAM*", Policy::refused, "solids are computed, and *ELEMENT_BEAM in spacetime"},
    {"ELEMENT_*", Policy::refused, "only *ELEMENT_SOLID and *ELEMENT_MASS are computed"},
};

bool matches(std::string_view pattern, std::string_view keyword) {
  if (!pattern.ends_with('*')) return pattern == keyword;
  return keyword.starts_with(pattern.substr(0, pattern.size() - 1));
}

}  // namespace

Unhandled unhandled(std::string_view keyword) {
  for (const Rule& rule : rules)
    if (matches(rule.keyword, keyword)) return {rule.policy, rule.remark};
  return {Policy::refused, "remove it, or allow unsupported keywords to run without it"};
}

}  // namespace cleave::model
