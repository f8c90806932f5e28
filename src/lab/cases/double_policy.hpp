#pragma once
/// How Boost.Math evaluates distributions here: in double throughout. Its default is long double, which is
/// another format on every processor, and is called before main() already, where valgrind (64 bits of it)
/// ends the program.

#include <boost/math/policies/policy.hpp>

namespace flipside::lab {

using DoublePolicy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

}  // namespace flipside::lab
