// The share of runs that ended so, with its exact bound (Clopper and Pearson 1934): what the true share
// is at least, or at most, with 95 % confidence, each bound by itself.
//
// Doc: docs/sweep.md   Test: tests/testbench/share_test.cpp
#pragma once

#include <boost/math/distributions/binomial.hpp>

#include <cstddef>

namespace steplock {

// In doubles all the way: Valgrind, which counts the engines' instructions, has no longer ones, and Boost's tables of such
// overflow in it before main().
using Binomial = boost::math::binomial_distribution<double, boost::math::policies::policy<boost::math::policies::promote_double<false>>>;

inline double share_at_least(std::size_t hits, std::size_t all) {
  return all == 0 ? 0 : Binomial::find_lower_bound_on_p(double(all), double(hits), 0.05);
}
inline double share_at_most(std::size_t hits, std::size_t all) {
  return all == 0 ? 1 : Binomial::find_upper_bound_on_p(double(all), double(hits), 0.05);
}

}  // namespace steplock
