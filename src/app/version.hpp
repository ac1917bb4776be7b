#pragma once

namespace cleave::app {

inline constexpr const char* version = CLEAVE_VERSION;

}  // namespace cleave::app
