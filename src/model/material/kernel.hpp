#pragma once
/// The functions a law may call on any value type. For Lanes and Dual the argument's namespace is searched
/// anyway; a plain double has none, so the names are made visible here.

#include "base/dual.hpp"
#include "base/lanes.hpp"
#include "base/tensor.hpp"

namespace cleave::model {

using base::abs;
using base::any;
using base::cbrt;
using base::exp;
using base::log;
using base::max;
using base::min;
using base::pow;
using base::select;
using base::sqrt;

}  // namespace cleave::model
