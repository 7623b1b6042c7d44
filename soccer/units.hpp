// Literals that convert the rule book's values to SI units: `15_mm` is 0.015.
#pragma once

namespace autoref {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kGravity_mps2 = 9.81;

constexpr double to_radians(double degrees) { return degrees * kPi / 180.0; }

inline namespace literals {
constexpr double operator""_m(long double x) { return static_cast<double>(x); }
constexpr double operator""_m(unsigned long long x) { return static_cast<double>(x); }
constexpr double operator""_mm(long double x) { return static_cast<double>(x / 1000.0L); }
constexpr double operator""_mm(unsigned long long x) { return static_cast<double>(x) / 1000.0; }
constexpr double operator""_s(long double x) { return static_cast<double>(x); }
constexpr double operator""_s(unsigned long long x) { return static_cast<double>(x); }
constexpr double operator""_ms(unsigned long long x) { return static_cast<double>(x) / 1000.0; }
constexpr double operator""_mps(long double x) { return static_cast<double>(x); }
constexpr double operator""_mps(unsigned long long x) { return static_cast<double>(x); }
constexpr double operator""_deg(long double x) { return to_radians(static_cast<double>(x)); }
constexpr double operator""_deg(unsigned long long x) { return to_radians(static_cast<double>(x)); }
}  // namespace literals

}  // namespace autoref
