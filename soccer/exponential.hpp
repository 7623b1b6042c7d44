// The exponential function with bit-identical results on every machine; see trigonometry.hpp for
// why the C library's differ.
#pragma once

namespace autoref {

// e^x, within 1e-12 of it relatively for |x| <= 700; beyond, that of the nearest such x.
double exponential(double x);

}  // namespace autoref
