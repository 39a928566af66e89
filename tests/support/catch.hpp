#pragma once

/// Catch2 2.13 (Debian 12) and Catch2 3 (Ubuntu 24.04) under the same names.

#include <string>

#ifdef LICHTRAUM_CATCH2_3
#include <catch2/catch_all.hpp>
using Catch::Approx;
inline auto contains_text(std::string const& text) { return Catch::Matchers::ContainsSubstring(text); }
#else
#include <catch2/catch.hpp>
inline auto contains_text(std::string const& text) { return Catch::Matchers::Contains(text); }
#endif
